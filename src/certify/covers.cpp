#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "nearwall/certify/certificate.h"
#include "nearwall/geometry/box.h"
#include "nearwall/predicates/volume.h"
#include "nearwall/search/winding.h"

namespace nearwall::certify {

namespace {

/// Component of each triangle: that of the wall triangles round the vertices that it stands on.
std::vector<ComponentId> triangle_components(const mesh::Front& front, const FrontSurface& surface,
                                             const IdVector<FaceId, ComponentId>& face_component) {
  std::vector<ComponentId> of_line(front.n_lines());
  for (std::size_t f = 0; f < front.n_wall_faces; ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      of_line[front.faces[FrontFaceId(f)].lines[k].index()] = face_component[FaceId(f)];
    }
  }
  const auto of_vertex = [&](VertexId v) {
    for (const LineId line : front.lines_of(v)) {
      if (of_line[line.index()].is_valid()) return of_line[line.index()];
    }
    return ComponentId();
  };
  std::vector<ComponentId> components(surface.triangles.size());
  for (std::size_t t = 0; t < surface.face.size(); ++t) {
    const FrontFaceId f = surface.face[t];
    components[t] =
        front.is_wall(f) ? face_component[FaceId(f.index())] : of_vertex(front.line_vertex[front.faces[f].lines[0]]);
  }
  // The rest of planes has ends of lines for corners, no apices of caps, and corners of the domain; what has none but
  // these belongs to what else lies on its plane.
  std::vector<ComponentId> of_plane;
  const auto n_front = surface.face.size();
  for (const bool is_first : {true, false}) {
    for (std::size_t t = n_front; t < components.size(); ++t) {
      const mesh::PlaneIndex plane = surface.rest_plane[t - n_front];
      if (of_plane.size() <= plane) of_plane.resize(plane + std::size_t{1});
      for (const std::uint32_t p : surface.triangles[t]) {
        if (is_first && p < front.n_lines()) components[t] = of_vertex(front.line_vertex[LineId(p)]);
      }
      if (is_first && components[t].is_valid()) of_plane[plane] = components[t];
      if (!components[t].is_valid()) components[t] = of_plane[plane];
    }
  }
  return components;
}

/// Components of the wall that the rest of planes joins: named by the smallest of them.
class Parts {
 public:
  Parts(const FrontSurface& surface, const std::vector<ComponentId>& of_triangle) {
    std::uint32_t n = 0;
    for (const ComponentId c : of_triangle) n = std::max(n, c.is_valid() ? c.index() + 1 : 0);
    part_.resize(n);
    std::iota(part_.begin(), part_.end(), std::uint32_t{0});
    if (surface.rest_plane.empty()) return;
    std::unordered_map<std::uint32_t, std::uint32_t> at_point;
    for (std::size_t t = 0; t < surface.face.size(); ++t) {
      if (!of_triangle[t].is_valid()) continue;
      for (const std::uint32_t p : surface.triangles[t]) at_point.emplace(p, of_triangle[t].index());
    }
    for (std::size_t t = surface.face.size(); t < surface.triangles.size(); ++t) {
      for (const std::uint32_t p : surface.triangles[t]) {
        if (const auto found = at_point.find(p); found != at_point.end()) join(of_triangle[t].index(), found->second);
      }
    }
  }

  std::uint32_t of(ComponentId c) {
    std::uint32_t i = c.index();
    while (part_[i] != i) i = part_[i] = part_[part_[i]];
    return i;
  }
  std::uint32_t n_components() const { return static_cast<std::uint32_t>(part_.size()); }

 private:
  void join(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax({of(ComponentId(a)), of(ComponentId(b))});
    part_[high] = low;
  }

  std::vector<std::uint32_t> part_;
};

/// The triangles of each part, by its name.
struct Members {
  std::vector<std::vector<std::uint32_t>> triangles;
  std::vector<geometry::Box> boxes;

  Members(const FrontSurface& surface, const std::vector<ComponentId>& of_triangle, Parts& parts)
      : triangles(parts.n_components()), boxes(parts.n_components()) {
    for (std::size_t t = 0; t < of_triangle.size(); ++t) {
      if (!of_triangle[t].is_valid()) continue;
      const std::uint32_t part = parts.of(of_triangle[t]);
      triangles[part].push_back(static_cast<std::uint32_t>(t));
      for (const std::uint32_t p : surface.triangles[t]) boxes[part].include(surface.points[p]);
    }
  }
};

}  // namespace

std::vector<ComponentId> covered_twice(const mesh::Front& front, const FrontSurface& surface,
                                       const IdVector<FaceId, ComponentId>& face_component, bool fluid_is_inside) {
  const std::vector<ComponentId> components = triangle_components(front, surface, face_component);
  Parts parts(surface, components);
  const Members by_part(surface, components, parts);
  const auto& members = by_part.triangles;
  const auto& boxes = by_part.boxes;

  std::vector<char> is_wrong(members.size(), 0), counts(surface.triangles.size());
  for (std::size_t c = 0; c < members.size(); ++c) {
    if (members[c].empty()) continue;
    const Vec3 point = surface.points[surface.triangles[members[c].front()][0]];
    // Only parts whose boxes hold the point can wind about it.
    const auto mark_around = [&](char value) {
      bool any = false;
      for (std::size_t other = 0; other < members.size(); ++other) {
        if (other == c || !boxes[other].contains(point)) continue;
        for (const std::uint32_t t : members[other]) counts[t] = value;
        any = true;
      }
      return any;
    };
    int covered = fluid_is_inside ? 1 : 0;
    if (mark_around(1)) {
      covered += search::winding_number({surface.points, surface.triangles}, point, counts);
      mark_around(0);
    }
    const auto triangle = [&](std::size_t i) {
      const auto [p, q, r] = surface.triangles[members[c][i]];
      return predicates::Triangle{surface.points[p], surface.points[q], surface.points[r]};
    };
    const bool is_body = predicates::enclosed_volume(members[c].size(), triangle).sign == predicates::Sign::Positive;
    is_wrong[c] = covered != (is_body ? 0 : 1);
  }
  std::vector<ComponentId> wrong;
  for (std::uint32_t c = 0; c < parts.n_components(); ++c) {
    if (is_wrong[parts.of(ComponentId(c))]) wrong.push_back(ComponentId(c));
  }
  return wrong;
}

}  // namespace nearwall::certify
