#include "volume/fill_check.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "nearwall/core/parallel.h"
#include "nearwall/predicates/cells.h"
#include "volume/face_table.h"

namespace nearwall::volume {

namespace {

void check_points(const FillBoundary& boundary, const Fill& fill) {
  const auto& points = boundary.points;
  const bool is_kept = fill.points.size() >= points.size() &&
                       std::memcmp(fill.points.data(), points.data(), points.size() * sizeof(Vec3)) == 0;
  if (!is_kept) {
    throw FillFailed("the tetrahedral mesher moved or merged points of the boundary: some lie too close together", {});
  }
}

void check_tetrahedra(const Fill& fill) {
  std::atomic<std::size_t> n_bad = 0;
  parallel_for(fill.tetrahedra.size(), [&](std::size_t t) {
    const auto& v = fill.tetrahedra[t];
    for (const std::uint32_t i : v) {
      if (i >= fill.points.size()) {
        ++n_bad;
        return;
      }
    }
    const std::array<Vec3, 4> p{fill.points[v[0]], fill.points[v[1]], fill.points[v[2]], fill.points[v[3]]};
    if (predicates::tetrahedron(p) != predicates::Positivity::Positive) ++n_bad;
  });
  if (n_bad > 0) {
    throw FillFailed(fmt::format("the tetrahedral mesher made {} tetrahedra of {} without a positive volume",
                                 n_bad.load(), fill.tetrahedra.size()),
                     {});
  }
}

}  // namespace

void check_fill(const FillBoundary& boundary, const Fill& fill) {
  check_points(boundary, fill);
  check_tetrahedra(fill);
  const FaceTable faces(fill.points.size(), fill.tetrahedra, boundary.triangles);
  if (!faces.unmatched_triangles().empty()) {
    const auto& missing = faces.unmatched_triangles();
    throw FillFailed(fmt::format("the tetrahedral mesher lost {} triangles of the boundary of {}", missing.size(),
                                 boundary.triangles.size()),
                     missing);
  }
  if (faces.n_unmatched_faces() > 0) {
    throw FillFailed(fmt::format("the tetrahedral mesher left {} faces open that are not of the boundary",
                                 faces.n_unmatched_faces()),
                     {});
  }
}

}  // namespace nearwall::volume
