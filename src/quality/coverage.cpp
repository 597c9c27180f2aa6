#include "nearwall/quality/coverage.h"

#include <algorithm>
#include <cmath>

#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/measures.h"

namespace nearwall::quality {

namespace {

constexpr double kPercent = 100;

/// What one line of a triangle contributes.
struct LineShare {
  Level end = 0;            ///< last level it reaches; 0 if it never moves
  double fraction = 0;      ///< of the asked thickness
  double first_height = 0;  ///< distance of its first node from the triangle's plane
  double thickness = 0;     ///< distance of its last node from the triangle's plane
};

LineShare share_of(const mesh::Lines& lines, LineId line, const Vec3& normal, const LineOutcome& outcome) {
  LineShare s;
  const mesh::Window window = lines.windows[line];
  if (!window.moves()) return s;
  const Vec3& base = lines.base[line];
  s.end = window.end;
  s.first_height = dot(lines.position(line, static_cast<Level>(window.start + 1)) - base, normal);
  s.thickness = dot(lines.position(line, window.end) - base, normal);
  if (outcome.asked_thickness[line] > 0) s.fraction = outcome.reached_thickness[line] / outcome.asked_thickness[line];
  return s;
}

FaceCoverage cover(const mesh::LayerMesh& layers, const mesh::SurfaceMesh& wall, FaceId f, const PatchRequest& request,
                   const LineOutcome& outcome) {
  const FrontFaceId column(f.index());
  const auto [a, b, c] = wall.triangle(f);
  const Vec3 normal = geometry::triangle_normal(a, b, c);

  FaceCoverage face;
  face.layers = request.count;
  face.has_any = layers.column_end(column) > layers.column_offset(column);
  std::array<double, 3> first_heights{}, thicknesses{}, asked{}, asked_first{};
  double smallest_fraction = 2;
  bool has_all_lines = request.count > 0, ends_isotropic = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const LineId line = layers.front().faces[column].lines[k];
    const LineShare s = share_of(layers.lines(), line, normal, outcome);
    face.layers = std::min(face.layers, s.end);
    first_heights[k] = s.first_height;
    thicknesses[k] = s.thickness;
    const bool is_asked = outcome.asked_thickness[line] > 0;
    asked[k] = is_asked ? outcome.asked_thickness[line] : request.total_thickness;
    asked_first[k] = is_asked && request.has_own_heights ? (*outcome.asked_first_height)[line] : request.first_height;
    const Level levels = is_asked && request.has_own_counts ? (*outcome.asked_levels)[line] : request.count;
    has_all_lines = has_all_lines && s.end >= levels;
    const mesh::LimitReason reason = outcome.reason[line];
    if (reason == mesh::LimitReason::Isotropic) ends_isotropic = true;
    if (reason == mesh::LimitReason::None || reason == mesh::LimitReason::Isotropic) continue;
    // Ties by the number of the reason: the answer must not depend on which corner comes first.
    if (s.fraction < smallest_fraction || (s.fraction == smallest_fraction && reason < face.reason)) {
      smallest_fraction = s.fraction;
      face.reason = reason;
    }
  }
  const auto mean = [](const std::array<double, 3>& v) { return sum3(v[0], v[1], v[2]) / 3; };
  face.has_all_layers = has_all_lines;
  face.first_height = mean(first_heights);
  face.thickness = mean(thicknesses);
  face.asked_first_height = mean(asked_first);
  face.asked_thickness = mean(asked);
  face.is_full = face.has_all_layers && face.thickness >= kFullThickness * face.asked_thickness;
  if (face.is_full) face.reason = ends_isotropic ? mesh::LimitReason::Isotropic : mesh::LimitReason::None;
  if (!face.is_full && face.reason == mesh::LimitReason::None) {
    // No line was limited: it shares a line with a patch of fewer layers, or its lines lean so far that its own are
    // thin.
    face.reason = face.has_all_layers ? mesh::LimitReason::Visibility : mesh::LimitReason::PatchEdge;
  }
  return face;
}

PatchCoverage sum_up(const mesh::SurfaceMesh& wall, const std::vector<FaceId>& members,
                     const IdVector<FaceId, FaceCoverage>& faces, const PatchRequest& request) {
  geometry::CompensatedSum total, full, all, any, layers, met, large;
  std::array<geometry::CompensatedSum, mesh::kNLimitReasons> limited;
  std::vector<double> areas, first_heights, thicknesses, asked_first_heights, asked_thicknesses;
  for (const FaceId f : members) {
    const auto [a, b, c] = wall.triangle(f);
    const double area = geometry::triangle_area(a, b, c);
    const FaceCoverage& face = faces[f];
    total.add(area);
    if (face.is_full) full.add(area);
    if (face.has_all_layers) all.add(area);
    if (face.has_any) any.add(area);
    layers.add(area * face.layers);
    const double asked = face.asked_first_height > 0 ? face.asked_first_height : request.first_height;
    if (std::abs(face.first_height - asked) <= kFirstHeightTolerance * asked) met.add(area);
    if (face.first_height > kLargeFirstHeight * asked) large.add(area);
    if (!face.is_full && face.reason != mesh::LimitReason::None) {
      limited[static_cast<std::size_t>(face.reason)].add(area);
    }
    areas.push_back(area);
    first_heights.push_back(face.first_height);
    thicknesses.push_back(face.thickness);
    asked_first_heights.push_back(face.asked_first_height);
    asked_thicknesses.push_back(face.asked_thickness);
  }
  PatchCoverage patch;
  patch.asked = request;
  patch.has_layers = request.has_layers;
  patch.area = total.value();
  if (!request.has_layers || !(patch.area > 0)) return patch;
  // A share of everything is 100 exactly: both sums are then the same.
  const auto percent = [&](const geometry::CompensatedSum& sum) { return kPercent * (sum.value() / patch.area); };
  patch.full_percent = percent(full);
  patch.all_layers_percent = percent(all);
  patch.any_percent = percent(any);
  patch.mean_layers = layers.value() / patch.area;
  patch.first_height_met_percent = percent(met);
  patch.first_height_large_percent = percent(large);
  for (std::size_t r = 0; r < limited.size(); ++r) patch.limit_percent[r] = percent(limited[r]);
  patch.first_height = weighted_statistics(first_heights, areas, true);
  patch.thickness = weighted_statistics(thicknesses, areas, true);
  patch.asked_first_height = weighted_statistics(asked_first_heights, areas, true);
  patch.asked_thickness = weighted_statistics(asked_thicknesses, areas, true);
  if (request.has_own_heights) patch.asked.first_height = patch.asked_first_height.median;
  if (request.has_own_heights || request.has_own_counts) patch.asked.total_thickness = patch.asked_thickness.median;
  return patch;
}

}  // namespace

IdVector<FaceId, FaceCoverage> face_coverage(const mesh::LayerMesh& layers, const mesh::SurfaceMesh& wall,
                                             const IdVector<PatchId, PatchRequest>& requests,
                                             const LineOutcome& outcome) {
  expect(requests.size() == wall.patch_names.size(), "one request for each patch");
  expect(outcome.reason.size() == layers.lines().size(), "one outcome for each line");
  for (const PatchRequest& request : requests) {
    expect(
        (!request.has_own_heights || outcome.asked_first_height) && (!request.has_own_counts || outcome.asked_levels),
        "what was asked for line by line");
  }
  IdVector<FaceId, FaceCoverage> faces(wall.faces.size());
  parallel_for(faces.size(), [&](std::size_t i) {
    const PatchRequest& request = requests[wall.face_patch[FaceId(i)]];
    const auto& lines = layers.front().faces[FrontFaceId(i)].lines;
    const bool is_asked =
        std::any_of(lines.begin(), lines.begin() + 3, [&](LineId line) { return outcome.asked_thickness[line] > 0; });
    if (request.has_layers && is_asked) faces[FaceId(i)] = cover(layers, wall, FaceId(i), request, outcome);
  });
  return faces;
}

IdVector<PatchId, PatchCoverage> patch_coverage(const mesh::SurfaceMesh& wall,
                                                const IdVector<FaceId, FaceCoverage>& faces,
                                                const IdVector<PatchId, PatchRequest>& requests,
                                                const IdVector<FaceId, char>& is_wetted) {
  IdVector<PatchId, std::vector<FaceId>> members(requests.size());
  for (const FaceId f : wall.faces.ids()) {
    if (is_wetted[f]) members[wall.face_patch[f]].push_back(f);
  }
  IdVector<PatchId, PatchCoverage> patches(requests.size());
  parallel_blocks(patches.size(), 1, [&](std::size_t p, std::size_t) {
    patches[PatchId(p)] = sum_up(wall, members[PatchId(p)], faces, requests[PatchId(p)]);
  });
  return patches;
}

}  // namespace nearwall::quality
