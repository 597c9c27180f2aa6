#include "nearwall/certify/certificate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "nearwall/core/parallel.h"
#include "nearwall/geometry/box.h"
#include "nearwall/geometry/measures.h"

namespace nearwall::certify {

namespace {

constexpr std::size_t kColumnsInBlock = 1024;

double sum_of_cells(const mesh::LayerMesh& layers) {
  std::vector<double> by_block((layers.n_columns() + kColumnsInBlock - 1) / kColumnsInBlock);
  parallel_blocks(layers.n_columns(), kColumnsInBlock, [&](std::size_t begin, std::size_t end) {
    geometry::CompensatedSum sum;
    for (std::size_t f = begin; f < end; ++f) {
      layers.for_each_cell(FrontFaceId(f), [&](const mesh::LayerCell& cell, Level) {
        sum.add(mesh::cell_volume(cell.type, mesh::corners_of(layers.lines(), cell)));
      });
    }
    by_block[begin / kColumnsInBlock] = sum.value();
  });
  geometry::CompensatedSum total;
  for (const double v : by_block) total.add(v);
  for (const FrontFaceId f : layers.caps()) {
    total.add(mesh::cell_volume(mesh::CellType::Pyramid, mesh::cap_over(layers.front(), layers.lines(), f)->corners));
  }
  return total.value();
}

/// Volume within triangles, as the sum of the cones over them about a centre.
struct Cones {
  geometry::CompensatedSum six_volumes;
  /// Of base times slant: what the rounding of the terms is in proportion to, in a flat body, too, whose cones have no
  /// height.
  geometry::CompensatedSum sizes;

  void add(const std::array<Vec3, 3>& t, const Vec3& centre) {
    const Vec3 base = cross(t[1] - t[0], t[2] - t[0]), slant = t[0] - centre;
    six_volumes.add(dot(base, slant));
    sizes.add(norm(base) * norm(slant));
  }
};

/// The rest of the planes, and all of them: the cones over what lies between are those over the sides of the layers.
void add_sides(const mesh::LayerMesh& layers, const mesh::SidePlanes& planes, const FrontSurface& front,
               const Vec3& centre, Cones& of_front, Cones& of_wall) {
  const auto add = [&](const FrontSurface& surface, Cones& cones) {
    for (std::size_t t = surface.face.size(); t < surface.triangles.size(); ++t) {
      const auto& corners = surface.triangles[t];
      cones.add({surface.points[corners[0]], surface.points[corners[1]], surface.points[corners[2]]}, centre);
    }
  };
  add(front, of_front);
  FrontSurface base = front;
  for (const LineId line : base.point_of_line.ids()) {
    const std::uint32_t first = layers.front().line_of(layers.front().line_vertex[line]).index();
    base.point_of_line[line] = first;
    base.points[first] = layers.lines().base[line];
  }
  base.triangles.resize(base.face.size());
  base.rest_plane.clear();
  base.rest_beside.clear();
  close_front(layers.front(), planes, base);
  add(base, of_wall);
}

}  // namespace

double Certificate::closure() const {
  return summed_volume > 0 ? std::abs(cells_volume - enclosed_volume) / summed_volume : 0;
}

Certificate certify_layers(const mesh::LayerMesh& layers, const CertifiedWall& wall, ProgressSink& progress) {
  progress.begin_stage("certificate");
  Certificate result;
  result.n_cells = layers.n_cells();
  result.n_bad_columns = bad_columns(layers.front(), layers.lines()).size();
  progress.update(0.3);
  FrontSurface front = front_surface(layers.front(), layers.lines());
  if (wall.planes) {
    result.n_turned_sides = turned_sides(layers.front(), layers.lines(), *wall.planes, front).size();
  }
  if (wall.planes) {
    result.n_front_intersections = close_front(layers.front(), *wall.planes, front).size();
    if (!front.is_closed && result.n_front_intersections == 0) result.n_front_intersections = 1;
  }
  if (result.n_front_intersections == 0) result.n_front_intersections = front_intersections(front).size();
  progress.update(0.7);
  // Winding numbers have a meaning only where the front does not meet itself.
  if (result.n_front_intersections == 0) {
    result.n_covered_twice = covered_twice(layers.front(), front, wall.face_component, wall.fluid_is_inside).size();
  }
  progress.update(0.8);

  const Vec3 centre = geometry::bounding_box(wall.surface.points.raw()).centre();
  Cones of_front, of_wall;
  for (std::size_t t = 0; t < front.face.size(); ++t) {
    // A component out of the fluid's reach has no lines that move, hence no virtual faces in the front.
    const bool is_wall = layers.front().is_wall(front.face[t]);
    const FaceId f = is_wall ? FaceId(t) : FaceId();
    if (is_wall && !wall.face_component[f].is_valid()) continue;
    const auto& corners = front.triangles[t];
    of_front.add({front.points[corners[0]], front.points[corners[1]], front.points[corners[2]]}, centre);
    if (is_wall) of_wall.add(wall.surface.triangle(f), centre);
  }
  if (wall.planes) add_sides(layers, *wall.planes, front, centre, of_front, of_wall);
  result.cells_volume = sum_of_cells(layers);
  result.enclosed_volume = (of_front.six_volumes.value() - of_wall.six_volumes.value()) / 6;
  result.front_volume = std::abs(of_front.six_volumes.value()) / 6;
  result.summed_volume = std::max(of_front.sizes.value(), of_wall.sizes.value()) / 6;
  progress.update(1.0);
  progress.end_stage();
  return result;
}

}  // namespace nearwall::certify
