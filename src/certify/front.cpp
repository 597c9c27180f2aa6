#include <algorithm>

#include "nearwall/certify/certificate.h"
#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/box.h"
#include "nearwall/predicates/volume.h"
#include "nearwall/search/self_intersection.h"
#include "nearwall/search/winding.h"

namespace nearwall::certify {

FrontSurface front_surface(const mesh::Front& front, const mesh::Lines& lines) {
  FrontSurface surface;
  surface.points.resize(front.n_lines());
  parallel_for(front.n_lines(), [&](std::size_t i) {
    const LineId line(i);
    surface.points[i] = lines.position(line, lines.windows[line].end);
  });
  surface.triangles.reserve(front.faces.size());
  for (const mesh::FrontFace& face : front.faces) {
    expect(face.size() == 3, "a front of triangles");
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const LineId line = face.lines[k];
      const VertexId v = front.line_vertex[line];
      corners[k] = lines.windows[line].moves() ? line.index() : front.first_line[v.index()];
    }
    surface.triangles.push_back(corners);
  }
  return surface;
}

std::vector<std::pair<FrontFaceId, FrontFaceId>> front_intersections(const FrontSurface& front,
                                                                     std::span<const char> changed) {
  const auto pairs = search::self_intersections({front.points, front.triangles}, changed);
  std::vector<std::pair<FrontFaceId, FrontFaceId>> result;
  result.reserve(pairs.size());
  for (const auto& [a, b] : pairs) result.emplace_back(FrontFaceId(a), FrontFaceId(b));
  return result;
}

std::vector<ComponentId> covered_twice(const FrontSurface& front, const IdVector<FaceId, ComponentId>& face_component,
                                       bool fluid_is_inside) {
  std::vector<std::vector<std::uint32_t>> members;
  std::vector<geometry::Box> boxes;
  for (const FaceId f : face_component.ids()) {
    const ComponentId c = face_component[f];
    if (!c.is_valid()) continue;
    if (members.size() <= c.index()) {
      members.resize(c.index() + std::size_t{1});
      boxes.resize(members.size());
    }
    members[c.index()].push_back(f.index());
    for (const std::uint32_t p : front.triangles[f.index()]) boxes[c.index()].include(front.points[p]);
  }

  std::vector<ComponentId> wrong;
  std::vector<char> counts(front.triangles.size());
  for (std::size_t c = 0; c < members.size(); ++c) {
    if (members[c].empty()) continue;
    const Vec3 point = front.points[front.triangles[members[c].front()][0]];
    // Only components whose boxes hold the point can wind about it.
    std::fill(counts.begin(), counts.end(), 0);
    bool any = false;
    for (std::size_t other = 0; other < members.size(); ++other) {
      if (other == c || !boxes[other].contains(point)) continue;
      for (const std::uint32_t t : members[other]) counts[t] = 1;
      any = true;
    }
    int covered = fluid_is_inside ? 1 : 0;
    if (any) covered += search::winding_number({front.points, front.triangles}, point, counts);
    const auto triangle = [&](std::size_t i) {
      const auto [p, q, r] = front.triangles[members[c][i]];
      return predicates::Triangle{front.points[p], front.points[q], front.points[r]};
    };
    const bool is_body = predicates::enclosed_volume(members[c].size(), triangle).sign == predicates::Sign::Positive;
    if (covered != (is_body ? 0 : 1)) wrong.push_back(ComponentId(c));
  }
  return wrong;
}

}  // namespace nearwall::certify
