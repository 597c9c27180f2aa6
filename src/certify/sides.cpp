#include <algorithm>

#include "nearwall/certify/certificate.h"
#include "nearwall/core/parallel.h"
#include "nearwall/mesh/side_face.h"
#include "nearwall/predicates/orientation.h"

namespace nearwall::certify {

bool is_turned(std::span<const Vec3> corners, const mesh::SidePlane& plane) {
  const std::size_t n = corners.size();
  std::array<Vec3, 4> flat;
  for (std::size_t k = 0; k < n; ++k) {
    const auto [u, v] = plane.flat(corners[k]);
    flat[k] = Vec3(u, v, 0);
  }
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3 &p = flat[(k + n - 1) % n], &q = flat[k], &r = flat[(k + 1) % n];
    // Clockwise in the plane's coordinates, which are seen from the domain.
    if (predicates::orientation(q, p, r, q + Vec3(0, 0, 1)) != predicates::Sign::Positive) return true;
  }
  return false;
}

std::vector<FrontFaceId> turned_sides(const mesh::Front& front, const mesh::Lines& lines,
                                      const mesh::SidePlanes& planes, const FrontSurface& surface) {
  std::vector<FrontFaceId> turned;
  const auto traces = plane_traces(front, planes, surface);
  for (mesh::PlaneIndex p = 0; p < traces.size(); ++p) {
    std::vector<char> is_bad(traces[p].size(), 0);
    parallel_for(traces[p].size(), [&](std::size_t i) {
      // A trace runs the other way round than the wall's edge.
      const LineId a(traces[p][i].points[1]), b(traces[p][i].points[0]);
      const auto [first, last] = mesh::level_range(lines, a, b);
      for (Level j = first; j < last && !is_bad[i]; ++j) {
        const mesh::SideFace face = mesh::side_face(front, lines, a, b, j);
        std::array<Vec3, 4> corners;
        const auto n = static_cast<std::size_t>(face.size);
        for (std::size_t k = 0; k < n; ++k) corners[k] = lines.position(face.nodes[k].line, face.nodes[k].level);
        is_bad[i] = n >= 3 && is_turned({corners.data(), n}, planes.planes[p]);
      }
    });
    for (std::size_t i = 0; i < is_bad.size(); ++i) {
      if (is_bad[i]) turned.push_back(traces[p][i].face);
    }
  }
  std::sort(turned.begin(), turned.end());
  turned.erase(std::unique(turned.begin(), turned.end()), turned.end());
  return turned;
}

}  // namespace nearwall::certify
