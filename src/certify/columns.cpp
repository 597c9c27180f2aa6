#include <limits>

#include "nearwall/certify/certificate.h"
#include "nearwall/core/parallel.h"
#include "nearwall/predicates/cells.h"

namespace nearwall::certify {

namespace {

using mesh::CellType;
using predicates::Positivity;

constexpr std::size_t kColumnsInBlock = 512;

/// Room for the points of three lines, kept by a thread from column to column.
class ColumnBuffer {
 public:
  explicit ColumnBuffer(Level n_levels) : stride_(n_levels + std::size_t{1}), data_(9 * stride_) {}

  /// Lays the points of the levels 0 … n_levels of a face's three lines.
  predicates::WedgeColumn lay(const mesh::Lines& lines, const mesh::FrontFace& face, Level n_levels) {
    predicates::WedgeColumn column{};
    for (std::size_t k = 0; k < 3; ++k) {
      double* x = data_.data() + 3 * k * stride_;
      lines.positions(face.lines[k], 0, n_levels, x, x + stride_, x + 2 * stride_);
      column.x[k] = x;
      column.y[k] = x + stride_;
      column.z[k] = x + 2 * stride_;
    }
    return column;
  }

 private:
  std::size_t stride_;
  std::vector<double> data_;
};

bool is_positive(const mesh::Lines& lines, const mesh::LayerCell& cell) {
  const std::array<Vec3, 8> p = mesh::corners_of(lines, cell);
  const std::span<const Vec3, 8> all(p);
  switch (cell.type) {
    case CellType::Tetrahedron:
      return predicates::tetrahedron(all.first<4>()) == Positivity::Positive;
    case CellType::Pyramid:
      return predicates::pyramid(all.first<5>()) == Positivity::Positive;
    case CellType::Wedge:
      return predicates::wedge(all.first<6>()) == Positivity::Positive;
    case CellType::Hexahedron:
      return predicates::hexahedron(all) == Positivity::Positive;
  }
  return false;
}

/// What no cell of a column can have as the level of its bottom.
constexpr Level kNoLevel = std::numeric_limits<Level>::max();

/// Level of the first cell of a column that is not positive; kNoLevel if there is none.
Level first_bad_level(const mesh::Front& front, const mesh::Lines& lines, FrontFaceId f, ColumnBuffer& buffer) {
  if (mesh::has_wedges_only(front, lines, f)) {
    const mesh::FrontFace& face = front.faces[f];
    const Level end = lines.windows[face.lines[0]].end;
    const int bad = end > 0 ? predicates::first_bad_wedge(buffer.lay(lines, face, end), end) : 0;
    return bad < end ? static_cast<Level>(bad) : kNoLevel;
  }
  const auto [first, last] = mesh::level_range(front, lines, f);
  for (Level level = first; level < last; ++level) {
    const auto cell = mesh::column_cell(front, lines, f, level);
    if (cell && !is_positive(lines, *cell)) return level;
  }
  const auto cap = mesh::cap_over(front, lines, f);
  return cap && predicates::pyramid(cap->corners) != Positivity::Positive ? last : kNoLevel;
}

}  // namespace

std::vector<BadColumn> bad_columns(const mesh::Front& front, const mesh::Lines& lines,
                                   std::span<const FrontFaceId> columns) {
  const std::size_t n = columns.empty() ? front.faces.size() : columns.size();
  std::vector<std::vector<BadColumn>> by_block((n + kColumnsInBlock - 1) / kColumnsInBlock);
  parallel_blocks(n, kColumnsInBlock, [&](std::size_t begin, std::size_t end) {
    ColumnBuffer buffer(lines.table.n_levels());
    for (std::size_t i = begin; i < end; ++i) {
      const FrontFaceId f = columns.empty() ? FrontFaceId(i) : columns[i];
      const Level bad = first_bad_level(front, lines, f, buffer);
      if (bad != kNoLevel) by_block[begin / kColumnsInBlock].push_back({f, bad});
    }
  });
  std::vector<BadColumn> all;
  for (const auto& block : by_block) all.insert(all.end(), block.begin(), block.end());
  return all;
}

}  // namespace nearwall::certify
