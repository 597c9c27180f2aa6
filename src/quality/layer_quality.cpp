#include "nearwall/quality/layer_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "nearwall/core/parallel.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/quality/metrics.h"

namespace nearwall::quality {

namespace {

/// Blocks of work, and so of histograms in memory. A fixed number, so that results do not depend on the threads.
constexpr std::size_t kNBlocks = 32;

// Widths of the bins: docs/theory/quality.md.
Binning jacobian_bins() { return Binning::linear(-1, 1, 4096); }
Binning aspect_bins() { return Binning::doublings(0, 40, 128); }
Binning growth_bins() { return Binning::doublings(-2, 2, 4096); }
Binning volume_bins() { return Binning::doublings(0, 20, 512); }

struct Cells {
  Histogram jacobian{jacobian_bins()};
  Histogram aspect{aspect_bins()};
  Histogram volume_ratio{volume_bins()};
  double worst = std::numeric_limits<double>::infinity();
  FrontFaceId worst_column;
  Level worst_level = 0;

  void merge(const Cells& other) {
    jacobian.merge(other.jacobian);
    aspect.merge(other.aspect);
    volume_ratio.merge(other.volume_ratio);
    if (other.worst < worst) worst = other.worst, worst_column = other.worst_column, worst_level = other.worst_level;
  }
};

/// Points of the lines of one column: each computed once, though every level but the ends belongs to two cells.
class ColumnPoints {
 public:
  void read(const mesh::LayerMesh& layers, FrontFaceId column) {
    const auto [first, last] = mesh::level_range(layers.front(), layers.lines(), column);
    first_ = first;
    const mesh::FrontFace& face = layers.front().faces[column];
    n_lines_ = face.size();
    for (int k = 0; k < n_lines_; ++k) {
      const auto i = static_cast<std::size_t>(k);
      lines_[i] = face.lines[i];
      points_[i].clear();
      for (Level j = first; j <= last; ++j) points_[i].push_back(layers.lines().position(lines_[i], j));
    }
  }

  const Vec3& at(const mesh::LineNode& node) const {
    std::size_t k = 0;
    while (lines_[k] != node.line) ++k;
    return points_[k][static_cast<std::size_t>(node.level - first_)];
  }

 private:
  std::array<LineId, 4> lines_;
  std::array<std::vector<Vec3>, 4> points_;
  Level first_ = 0;
  int n_lines_ = 0;
};

void add_column(const mesh::LayerMesh& layers, FrontFaceId column, ColumnPoints& points, Cells& cells) {
  if (layers.column_offset(column) == layers.column_end(column)) return;
  points.read(layers, column);
  double volume_below = 0;
  layers.for_each_cell(column, [&](const mesh::LayerCell& cell, Level level) {
    std::array<Vec3, 8> corners;
    const auto n = static_cast<std::size_t>(mesh::size_of(cell.type));
    for (std::size_t i = 0; i < n; ++i) corners[i] = points.at(cell.nodes[i]);
    const std::span<const Vec3> p(corners.data(), n);

    const double jacobian = scaled_jacobian(cell.type, p);
    cells.jacobian.add(jacobian);
    if (jacobian < cells.worst) cells.worst = jacobian, cells.worst_column = column, cells.worst_level = level;
    cells.aspect.add(aspect_ratio(cell.type, p));
    const double v = mesh::cell_volume(cell.type, p);
    if (volume_below > 0) cells.volume_ratio.add(v > volume_below ? v / volume_below : volume_below / v);
    volume_below = v;
  });
}

void add_line(const mesh::Lines& lines, LineId line, Histogram& growth) {
  const mesh::Window window = lines.windows[line];
  if (!window.moves()) return;
  Vec3 below = lines.position(line, window.start);
  double height_below = 0;
  for (Level j = static_cast<Level>(window.start + 1); j <= window.end; ++j) {
    const Vec3 here = lines.position(line, j);
    const double height = distance(here, below);
    if (height_below > 0) growth.add(height / height_below);
    below = here;
    height_below = height;
  }
}

/// Runs `add(item, part)` over blocks of [0, n) and merges the parts in order.
template <class Part, class Add>
Part by_blocks(std::size_t n, Part empty, Add&& add) {
  const std::size_t block = std::max<std::size_t>(1, (n + kNBlocks - 1) / kNBlocks);
  std::vector<std::optional<Part>> parts(kNBlocks);
  parallel_blocks(n, block, [&](std::size_t begin, std::size_t end) {
    Part part = empty;
    for (std::size_t i = begin; i < end; ++i) add(i, part);
    parts[begin / block] = std::move(part);
  });
  for (const auto& part : parts) {
    if (part) empty.merge(*part);
  }
  return empty;
}

Statistics orthogonality(const mesh::LayerMesh& layers, const mesh::SurfaceMesh& wall) {
  const mesh::Lines& lines = layers.lines();
  std::vector<double> angles(layers.front().n_wall_faces, 0.0), areas(layers.front().n_wall_faces, 0.0);
  parallel_for(angles.size(), [&](std::size_t i) {
    const auto [a, b, c] = wall.triangle(FaceId(i));
    const Vec3 normal = geometry::triangle_area_vector(a, b, c);
    bool moves = false;
    for (int k = 0; k < 3; ++k) {
      const LineId line = layers.front().faces[FrontFaceId(i)].lines[static_cast<std::size_t>(k)];
      const mesh::Window window = lines.windows[line];
      if (!window.moves()) continue;
      moves = true;
      const Vec3 step = lines.position(line, static_cast<Level>(window.start + 1)) - lines.base[line];
      angles[i] = std::max(angles[i], geometry::to_degrees(geometry::angle_between(step, normal)));
    }
    if (moves) areas[i] = norm(normal);
  });
  return weighted_statistics(angles, areas);
}

}  // namespace

LayerQuality layer_quality(const mesh::LayerMesh& layers, const mesh::SurfaceMesh& wall) {
  struct WithScratch : Cells {
    ColumnPoints points;
  };
  const Cells cells = by_blocks(layers.n_columns(), WithScratch{}, [&](std::size_t i, WithScratch& part) {
    add_column(layers, FrontFaceId(i), part.points, part);
  });
  const Histogram growth =
      by_blocks(layers.lines().size(), Histogram(growth_bins()),
                [&](std::size_t i, Histogram& part) { add_line(layers.lines(), LineId(i), part); });

  LayerQuality quality;
  quality.scaled_jacobian = cells.jacobian.statistics();
  quality.aspect_ratio = cells.aspect.statistics();
  quality.volume_ratio = cells.volume_ratio.statistics();
  quality.growth = growth.statistics();
  quality.orthogonality = orthogonality(layers, wall);
  quality.worst_column = cells.worst_column;
  quality.worst_level = cells.worst_level;
  return quality;
}

}  // namespace nearwall::quality
