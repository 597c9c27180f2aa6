#include "nearwall/quality/limited_lines.h"

#include <algorithm>
#include <numeric>

#include "nearwall/core/expect.h"

namespace nearwall::quality {

namespace {

/// Of each vertex: the lowest patch with layers round it, invalid where there is none.
IdVector<VertexId, PatchId> patch_of_vertices(const mesh::SurfaceMesh& wall,
                                              const IdVector<PatchId, PatchRequest>& requests) {
  IdVector<VertexId, PatchId> patch(wall.points.size());
  for (const FaceId f : wall.faces.ids()) {
    const PatchId p = wall.face_patch[f];
    if (!requests[p].has_layers) continue;
    for (const VertexId v : wall.faces[f]) {
      if (!patch[v].is_valid() || p < patch[v]) patch[v] = p;
    }
  }
  return patch;
}

bool is_worse(const LimitedVertex& a, const LimitedVertex& b) {
  return a.share() != b.share() ? a.share() < b.share() : a.vertex < b.vertex;
}

/// Keeps the worst few, in order.
void keep(std::vector<LimitedVertex>& worst, const LimitedVertex& found) {
  if (worst.size() == kPlacesForEachReason && !is_worse(found, worst.back())) return;
  worst.insert(std::upper_bound(worst.begin(), worst.end(), found, is_worse), found);
  if (worst.size() > kPlacesForEachReason) worst.pop_back();
}

}  // namespace

std::uint64_t LimitedLines::n_limited() const {
  return std::accumulate(by_reason.begin(), by_reason.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const ReasonLines& r) { return sum + r.n_lines; });
}

std::uint64_t LimitedLines::n_at_wall() const {
  return std::accumulate(by_reason.begin(), by_reason.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const ReasonLines& r) { return sum + r.n_at_wall; });
}

LimitedLines limited_lines(const mesh::SurfaceMesh& wall, const mesh::Front& front, const mesh::Lines& lines,
                           const LineOutcome& outcome, const IdVector<PatchId, PatchRequest>& requests) {
  expect(requests.size() == wall.patch_names.size(), "one request for each patch");
  expect(outcome.reason.size() == lines.size(), "one outcome for each line");
  const auto patch = patch_of_vertices(wall, requests);
  LimitedLines all;
  all.by_patch.assign(requests.size(), {});
  for (const VertexId v : wall.points.ids()) {
    const LineId line = front.line_of(v);
    if (!patch[v].is_valid() || !(outcome.asked_thickness[line] > 0)) continue;
    const auto n_lines = static_cast<std::uint32_t>(front.n_lines(v));
    all.n_lines += n_lines;
    const auto reason = static_cast<std::size_t>(outcome.reason[line]);
    if (outcome.reason[line] == mesh::LimitReason::None) continue;
    if (outcome.reason[line] == mesh::LimitReason::Isotropic) continue;  // it has all that was asked
    const mesh::Window window = lines.windows[line];
    const Level levels = window.moves() ? window.end : Level{0};
    ReasonLines& of_reason = all.by_reason[reason];
    of_reason.n_lines += n_lines;
    if (!window.moves()) of_reason.n_at_wall += n_lines;
    all.by_patch[patch[v]][reason] += n_lines;
    keep(of_reason.worst, {v, patch[v], wall.points[v], n_lines, levels, outcome.reached_thickness[line],
                           outcome.asked_thickness[line]});
  }
  return all;
}

}  // namespace nearwall::quality
