#include "tests/peers/layer_figures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "nearwall/certify/mesh_certificate.h"
#include "nearwall/certify/wall_match.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/mesh/cell_faces.h"
#include "nearwall/quality/metrics.h"

namespace nearwall::peers {

namespace {

/// A first height is as asked if it is so near to it.
constexpr double kHeightTolerance = 0.01;

class Observer {
 public:
  Observer(const mesh::VolumeMesh& mesh, const mesh::SurfaceMesh& wall, double first_height)
      : mesh_(mesh), wall_(wall), first_height_(first_height), faces_(mesh), is_wall_node_(mesh.points.size(), 0) {}

  LayerFigures figures(const std::function<bool(const Vec3&)>& is_on_sharp_edge) {
    figures_.n_cells = mesh_.n_cells();
    for (std::size_t c = 0; c < mesh_.n_cells(); ++c) {
      figures_.smallest_jacobian = std::min(figures_.smallest_jacobian, jacobian(c));
    }
    look_at_wall();
    look_at_sharp_edge(is_on_sharp_edge);
    return figures_;
  }

 private:
  double jacobian(std::size_t cell) const {
    const auto corners = mesh_.corners_of(cell);
    return quality::scaled_jacobian(mesh_.type[cell], corners);
  }

  void look_at_wall() {
    const auto boundary = certify::conformity(mesh_).boundary;
    const certify::WallMatch match = certify::match_wall(mesh_, boundary, wall_);
    double area = 0, covered = 0, as_asked = 0;
    for (const FaceId f : wall_.faces.ids()) {
      const auto [a, b, c] = wall_.triangle(f);
      const Vec3 normal = cross(b - a, c - a);
      area += norm(normal);
      look_at_triangle({a, b, c});
      if (!match.face[f]) continue;
      covered += norm(normal);
      const double error = std::abs(height_over(*match.face[f], a, normalized(normal)) / first_height_ - 1);
      figures_.largest_height_error = std::max(figures_.largest_height_error, error);
      if (error <= kHeightTolerance) as_asked += norm(normal);
      climb(*match.face[f]);
    }
    constexpr double kPercent = 100;
    figures_.any_percent = kPercent * (covered / area);
    figures_.first_height_percent = kPercent * (as_asked / area);
  }

  /// The prism of equal ends and square sides over the triangle; how high it is does not matter.
  void look_at_triangle(const std::array<Vec3, 3>& t) {
    const Vec3 up = normalized(cross(t[1] - t[0], t[2] - t[0])) * distance(t[0], t[1]);
    const std::array<Vec3, 6> prism = {t[0], t[1], t[2], t[0] + up, t[1] + up, t[2] + up};
    const double jacobian = quality::scaled_jacobian(mesh::CellType::Wedge, prism);
    figures_.upright_jacobian = std::min(figures_.upright_jacobian, jacobian);
  }

  /// Mean distance of the first nodes from the plane of the wall triangle; a corner whose line rests counts as 0.
  double height_over(mesh::FaceName face, const Vec3& origin, const Vec3& normal) {
    const mesh::FaceNodes below = mesh::nodes_of(mesh_, face);
    double sum = 0;
    for (const std::uint32_t node : mesh_.nodes_of(face.cell())) {
      if (std::find(below.begin(), below.end(), node) != below.end()) {
        is_wall_node_[node] = 1;
      } else {
        sum += dot(mesh_.points[node] - origin, normal);
      }
    }
    if (mesh_.type[face.cell()] == mesh::CellType::Wedge) lean_of(face, normal);
    return sum / 3;
  }

  /// Nodes i and i + 3 of a wedge are ends of one line.
  void lean_of(mesh::FaceName face, const Vec3& normal) {
    const mesh::FaceNodes below = mesh::nodes_of(mesh_, face);
    const auto nodes = mesh_.nodes_of(face.cell());
    for (std::size_t i = 0; i < 3; ++i) {
      const bool is_below = std::find(below.begin(), below.end(), nodes[i]) != below.end();
      const Vec3 along = (mesh_.points[nodes[i + 3]] - mesh_.points[nodes[i]]) * (is_below ? 1.0 : -1.0);
      figures_.largest_lean = std::max(figures_.largest_lean, geometry::angle_between(along, normal));
    }
  }

  /// Through wedges from triangle to triangle; the first other cell is the last that stands over the wall triangle.
  void climb(mesh::FaceName face) {
    for (bool is_higher = true; is_higher;) {
      const std::size_t cell = face.cell();
      figures_.smallest_wall_jacobian = std::min(figures_.smallest_wall_jacobian, jacobian(cell));
      if (mesh_.type[cell] != mesh::CellType::Wedge) return;
      const mesh::FaceName top = other_triangle(face);
      face = faces_.opposite(mesh_, top);
      is_higher = face != top;
    }
  }

  mesh::FaceName other_triangle(mesh::FaceName face) const {
    const auto faces = mesh::cell_faces(mesh::CellType::Wedge);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (faces[i].size == 3 && i != face.face()) return {face.cell(), i};
    }
    return face;
  }

  /// Lines are the mesh edges that leave the wall; two are neighbours if an edge joins their ends.
  void look_at_sharp_edge(const std::function<bool(const Vec3&)>& is_on_sharp_edge) {
    std::map<std::uint32_t, std::set<std::uint32_t>> lines;
    std::set<std::array<std::uint32_t, 3>> neighbours;
    const auto is_base = [&](std::uint32_t node) {
      return is_wall_node_[node] && is_on_sharp_edge(mesh_.points[node]);
    };
    for (std::size_t c = 0; c < mesh_.n_cells(); ++c) {
      const auto nodes = mesh_.nodes_of(c);
      if (std::none_of(nodes.begin(), nodes.end(), is_base)) continue;
      const auto edges = edges_of(c);
      for (const std::uint32_t base : nodes) {
        if (!is_base(base)) continue;
        std::set<std::uint32_t> ends;
        for (const auto& [a, b] : edges) {
          if (a == base && !is_wall_node_[b]) ends.insert(b);
        }
        lines[base].insert(ends.begin(), ends.end());
        for (const auto& [a, b] : edges) {
          if (ends.count(a) > 0 && ends.count(b) > 0) neighbours.insert({base, a, b});
        }
      }
    }
    for (const auto& [base, ends] : lines) {
      figures_.fewest_lines = std::min(figures_.fewest_lines, static_cast<std::uint32_t>(ends.size()));
    }
    for (const auto& [base, a, b] : neighbours) {
      const Vec3& p = mesh_.points[base];
      const double turn = geometry::angle_between(mesh_.points[a] - p, mesh_.points[b] - p);
      figures_.largest_turn = std::max(figures_.largest_turn, turn);
    }
  }

  /// Both ways round.
  std::set<std::array<std::uint32_t, 2>> edges_of(std::size_t cell) const {
    std::set<std::array<std::uint32_t, 2>> edges;
    const auto faces = mesh::cell_faces(mesh_.type[cell]);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const mesh::FaceNodes nodes = mesh::nodes_of(mesh_, {cell, i});
      for (std::size_t k = 0; k < faces[i].size; ++k) {
        const std::uint32_t a = nodes[k], b = nodes[(k + 1) % faces[i].size];
        edges.insert({a, b});
        edges.insert({b, a});
      }
    }
    return edges;
  }

  const mesh::VolumeMesh& mesh_;
  const mesh::SurfaceMesh& wall_;
  double first_height_;
  mesh::FaceIndex faces_;
  std::vector<char> is_wall_node_;
  LayerFigures figures_;
};

}  // namespace

LayerFigures layer_figures(const mesh::VolumeMesh& mesh, const mesh::SurfaceMesh& wall, double first_height,
                           const std::function<bool(const Vec3&)>& is_on_sharp_edge) {
  return Observer(mesh, wall, first_height).figures(is_on_sharp_edge);
}

}  // namespace nearwall::peers
