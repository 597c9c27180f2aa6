#include "nearwall/io/ugrid_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "io/batches.h"
#include "io/boundary_output.h"
#include "io/cell_sections.h"
#include "io/format_limits.h"
#include "io/number_text.h"
#include "io/ugrid_layout.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/pending_file.h"

namespace nearwall::io {
namespace {

using mesh::CellBatch;
using mesh::CellType;

/// FUN3D reads the names with Fortran's rules for lists, where these end a word or more.
constexpr std::string_view kForbidden = ",;/'\"";

/// Numbers in the form of the file.
class UgridNumbers {
 public:
  explicit UgridNumbers(UgridForm form)
      : is_text_(form == UgridForm::Ascii), is_turned_((form == UgridForm::BigEndian) != is_big_endian_machine()) {}

  void append(std::string& out, std::span<const std::int32_t> line) const {
    if (is_text_) {
      append_integers(out, line);
      out += '\n';
    } else {
      for (const std::int32_t value : line) append_value(out, value);
    }
  }

  void append(std::string& out, const Vec3& p) const {
    if (is_text_) {
      append_coordinates(out, p);
      out += '\n';
    } else {
      for (int axis = 0; axis < 3; ++axis) append_value(out, p[axis]);
    }
  }

 private:
  static constexpr bool is_big_endian_machine() { return std::endian::native == std::endian::big; }

  template <class T>
  void append_value(std::string& out, T value) const {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), &value, sizeof(T));
    if (is_turned_) std::ranges::reverse(raw);
    out.append(raw.data(), sizeof(T));
  }

  bool is_text_;
  bool is_turned_;
};

/// Finds out to which axis the patches of symmetry planes are normal, from points that come batch after batch.
class SymmetryAxes {
 public:
  explicit SymmetryAxes(const mesh::Boundary& boundary) : boundary_(boundary) {
    for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
      const mesh::BoundaryFace& face = boundary.faces[f];
      if (is_symmetry(boundary.patch[f])) nodes_.insert(nodes_.end(), face.begin(), face.begin() + mesh::size_of(face));
    }
    std::ranges::sort(nodes_);
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    positions_.resize(nodes_.size());
  }

  /// On several threads.
  void take(const mesh::PointBatch& points) {
    for (auto i = place_of(points.first); i < nodes_.size() && nodes_[i] - points.first < points.size(); ++i) {
      positions_[i] = points.position[nodes_[i] - points.first];
    }
  }

  /// None where the faces of the patch have normals along several axes.
  std::optional<int> axis_of(PatchId patch) const {
    constexpr double kMost = 0.999;  // of the area; planes are flat up to rounding
    if (!is_symmetry(patch)) return {};
    Vec3 area;
    for (std::size_t f = 0; f < boundary_.faces.size(); ++f) {
      if (boundary_.patch[f] != patch) continue;
      const Vec3 normal = normal_of(boundary_.faces[f]);
      for (int axis = 0; axis < 3; ++axis) area[axis] += std::abs(normal[axis]);
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (area[axis] > kMost * (area.x() + area.y() + area.z())) return axis;
    }
    return {};
  }

 private:
  bool is_symmetry(PatchId patch) const { return boundary_.patches[patch].type == mesh::BoundaryType::Symmetry; }
  std::size_t place_of(NodeIndex node) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(nodes_, node) - nodes_.begin());
  }
  const Vec3& position_of(NodeIndex node) const { return positions_[place_of(node)]; }
  Vec3 normal_of(const mesh::BoundaryFace& face) const {
    const Vec3 &a = position_of(face[0]), &b = position_of(face[1]), &c = position_of(face[2]);
    if (mesh::size_of(face) == 3) return cross(b - a, c - a);
    return cross(c - a, position_of(face[3]) - b);
  }

  const mesh::Boundary& boundary_;
  std::vector<NodeIndex> nodes_;  // of symmetry planes, ascending
  std::vector<Vec3> positions_;
};

class UgridWriter {
 public:
  UgridWriter(const std::filesystem::path& path, const WholeMesh& mesh, UgridForm form)
      : file_(path), map_(mapbc_path(path)), mesh_(mesh), numbers_(form), sections_(mesh.cells), axes_(mesh.boundary) {}

  void write(ProgressSink& progress) {
    progress_ = &progress;
    write_header();
    write_points();
    write_faces();
    for (std::size_t type = 0; type < mesh::kNCellTypes; ++type) write_cells(static_cast<CellType>(type));
    write_map();
    map_.commit();
    file_.commit();
  }

 private:
  /// Points or cells of a batch.
  struct Lines {
    std::string bytes;
    std::uint64_t n = 0;
  };

  void write_header() {
    std::array<std::int32_t, kUgridHeader> header{static_cast<std::int32_t>(mesh_.cells.n_points())};
    for (const mesh::BoundaryFace& face : mesh_.boundary.faces) ++header[mesh::size_of(face) == 3 ? 1 : 2];
    const auto n_cells = mesh_.cells.n_cells_by_type();
    for (std::size_t type = 0; type < n_cells.size(); ++type)
      header[3 + type] = static_cast<std::int32_t>(n_cells[type]);
    std::string bytes;
    numbers_.append(bytes, header);
    file_.write(bytes);
  }

  void write_points() {
    in_batches(
        mesh_.cells.n_point_batches(),
        [&](std::size_t batch) {
          mesh::PointBatch points;
          mesh_.cells.read_points(batch, points);
          axes_.take(points);
          Lines lines{{}, points.size()};
          for (const Vec3& p : points.position) numbers_.append(lines.bytes, p);
          return lines;
        },
        [&](std::size_t, const Lines& lines) { write_lines(lines); });
  }

  /// Triangles, then quads, then the numbers of the patches of all of them.
  void write_faces() {
    const mesh::Boundary& boundary = mesh_.boundary;
    number_patches();
    std::string numbers;
    for (const int size : {3, 4}) {
      std::string bytes;
      for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
        const mesh::BoundaryFace face = seen_from_inside(boundary.faces[f]);
        if (mesh::size_of(face) != size) continue;
        std::array<std::int32_t, 4> line;
        const auto n = static_cast<std::size_t>(size);
        for (std::size_t k = 0; k < n; ++k) line[k] = static_cast<std::int32_t>(face[k] + 1);
        numbers_.append(bytes, std::span<const std::int32_t>(line.data(), n));
        numbers_.append(numbers, std::span<const std::int32_t>(&number_[boundary.patch[f]], 1));
      }
      file_.write(bytes);
    }
    file_.write(numbers);
  }

  /// From 1, those without faces left out.
  void number_patches() {
    number_.assign(mesh_.boundary.patches.size(), 0);
    for (const PatchId patch : mesh_.boundary.patch) number_[patch] = 1;
    for (std::int32_t& number : number_) number = number ? ++n_patches_ : 0;
  }

  void write_cells(CellType type) {
    const auto& nodes = kUgridNodes[static_cast<std::size_t>(type)];
    const auto n = static_cast<std::size_t>(mesh::size_of(type));
    for (const CellSection& section : sections_.sections()) {
      if (section.type != type) continue;
      sections_.stream(
          section,
          [&](const CellBatch& cells, const std::vector<std::uint32_t>& places) {
            Lines lines{{}, places.size()};
            for (const std::uint32_t c : places) {
              std::array<std::int32_t, 8> line;
              for (std::size_t k = 0; k < n; ++k) line[k] = static_cast<std::int32_t>(cells.nodes[c][nodes[k]] + 1);
              numbers_.append(lines.bytes, std::span<const std::int32_t>(line.data(), n));
            }
            return lines;
          },
          [&](const Lines& lines) { write_lines(lines); });
    }
  }

  void write_map() {
    const auto& patches = mesh_.boundary.patches;
    const auto words = patch_words(patches, kForbidden, {});
    std::string text = fmt::format("{}\n", n_patches_);
    for (const PatchId patch : patches.ids()) {
      if (number_[patch] == 0) continue;
      const int code = fun3d_code(patches[patch].type, axes_.axis_of(patch));
      text += fmt::format("{} {} {}\n", number_[patch], code, words[patch]);
    }
    map_.write(text);
  }

  void write_lines(const Lines& lines) {
    file_.write(lines.bytes);
    n_written_ += lines.n;
    progress_->update(static_cast<double>(n_written_) /
                      static_cast<double>(mesh_.cells.n_points() + mesh_.cells.n_cells()));
  }

  PendingFile file_;
  PendingFile map_;
  const WholeMesh& mesh_;
  UgridNumbers numbers_;
  CellSections sections_;
  SymmetryAxes axes_;
  IdVector<PatchId, std::int32_t> number_;  // in the file; 0: not in it
  std::int32_t n_patches_ = 0;
  ProgressSink* progress_ = nullptr;
  std::uint64_t n_written_ = 0;  // points and cells
};

}  // namespace

void write_ugrid(const std::filesystem::path& path, const WholeMesh& mesh, UgridForm form, ProgressSink* progress) {
  require_ugrid_limits(path, mesh);
  UgridWriter(path, mesh, form).write(progress ? *progress : silent_progress());
}

}  // namespace nearwall::io
