#include <algorithm>

#include "nearwall/certify/certificate.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/box.h"
#include "nearwall/predicates/volume.h"
#include "nearwall/search/self_intersection.h"
#include "nearwall/search/winding.h"

namespace nearwall::certify {

namespace {

/// Adds the triangles of the front, a face at a time.
class FrontBuilder {
 public:
  FrontBuilder(const mesh::Front& front, const mesh::Lines& lines) : front_(front), lines_(lines) {
    surface_.points.resize(front.n_lines());
    parallel_for(front.n_lines(), [&](std::size_t i) {
      const LineId line(i);
      surface_.points[i] = lines.position(line, lines.windows[line].end);
    });
    surface_.triangles.reserve(front.faces.size());
    surface_.face.reserve(front.faces.size());
  }

  void add_wall(FrontFaceId f) {
    const auto& corners = front_.faces[f].lines;
    add(f, {point_of(corners[0]), point_of(corners[1]), point_of(corners[2])});
  }

  void add_virtual(FrontFaceId f) {
    if (const auto cap = mesh::cap_over(front_, lines_, f)) return add_cap(f, *cap);
    std::array<std::uint32_t, 4> outline{};
    std::size_t n = 0;
    for (int k = 0; k < front_.faces[f].size(); ++k) {
      const std::uint32_t point = point_of(front_.faces[f].lines[static_cast<std::size_t>(k)]);
      if (std::find(outline.begin(), outline.begin() + n, point) == outline.begin() + n) outline[n++] = point;
    }
    if (n == 3) add(f, {outline[0], outline[1], outline[2]});
  }

  FrontSurface take() { return std::move(surface_); }

 private:
  std::uint32_t point_of(LineId line) const {
    const VertexId v = front_.line_vertex[line];
    return lines_.windows[line].moves() ? line.index() : front_.line_of(v).index();
  }

  void add(FrontFaceId f, const std::array<std::uint32_t, 3>& corners) {
    surface_.triangles.push_back(corners);
    surface_.face.push_back(f);
  }

  void add_cap(FrontFaceId f, const mesh::Cap& cap) {
    const auto apex = static_cast<std::uint32_t>(surface_.points.size());
    surface_.points.push_back(cap.corners[4]);
    for (std::size_t k = 0; k < 4; ++k) {
      add(f, {cap.base[k].line.index(), cap.base[(k + 1) % 4].line.index(), apex});
    }
  }

  const mesh::Front& front_;
  const mesh::Lines& lines_;
  FrontSurface surface_;
};

/// Component of each front triangle: that of the wall triangles round the vertices that it stands on.
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
  for (std::size_t t = 0; t < components.size(); ++t) {
    const FrontFaceId f = surface.face[t];
    components[t] =
        front.is_wall(f) ? face_component[FaceId(f.index())] : of_vertex(front.line_vertex[front.faces[f].lines[0]]);
  }
  return components;
}

}  // namespace

FrontSurface front_surface(const mesh::Front& front, const mesh::Lines& lines) {
  FrontBuilder builder(front, lines);
  for (const FrontFaceId f : front.faces.ids()) {
    if (front.is_wall(f)) {
      builder.add_wall(f);
    } else {
      builder.add_virtual(f);
    }
  }
  return builder.take();
}

std::vector<std::pair<FrontFaceId, FrontFaceId>> front_intersections(const FrontSurface& front,
                                                                     std::span<const char> changed) {
  std::vector<char> moved;
  if (!changed.empty()) {
    for (const FrontFaceId f : front.face) moved.push_back(changed[f.index()]);
  }
  const auto pairs = search::self_intersections({front.points, front.triangles}, moved);
  std::vector<std::pair<FrontFaceId, FrontFaceId>> result;
  result.reserve(pairs.size());
  for (const auto& [a, b] : pairs) result.emplace_back(front.face[a], front.face[b]);
  return result;
}

std::vector<ComponentId> covered_twice(const mesh::Front& front, const FrontSurface& surface,
                                       const IdVector<FaceId, ComponentId>& face_component, bool fluid_is_inside) {
  std::vector<std::vector<std::uint32_t>> members;
  std::vector<geometry::Box> boxes;
  const std::vector<ComponentId> components = triangle_components(front, surface, face_component);
  for (std::size_t t = 0; t < components.size(); ++t) {
    const ComponentId c = components[t];
    if (!c.is_valid()) continue;
    if (members.size() <= c.index()) {
      members.resize(c.index() + std::size_t{1});
      boxes.resize(members.size());
    }
    members[c.index()].push_back(static_cast<std::uint32_t>(t));
    for (const std::uint32_t p : surface.triangles[t]) boxes[c.index()].include(surface.points[p]);
  }

  std::vector<ComponentId> wrong;
  std::vector<char> counts(surface.triangles.size());
  for (std::size_t c = 0; c < members.size(); ++c) {
    if (members[c].empty()) continue;
    const Vec3 point = surface.points[surface.triangles[members[c].front()][0]];
    // Only components whose boxes hold the point can wind about it.
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
    if (covered != (is_body ? 0 : 1)) wrong.push_back(ComponentId(c));
  }
  return wrong;
}

}  // namespace nearwall::certify
