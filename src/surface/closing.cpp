#include "surface/closing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <vector>

#include "nearwall/surface/weld.h"

namespace nearwall::surface {
namespace {

using EdgeEnds = std::array<std::uint32_t, 2>;

/// The open edges alone, with their points numbered anew: small enough to be welded again and again.
struct OpenEdges {
  std::vector<Vec3> points;
  std::vector<EdgeEnds> edges;
  double shortest = std::numeric_limits<double>::infinity();
};

OpenEdges extract(const mesh::SurfaceMesh& surface, std::span<const HalfedgeId> open_edges) {
  constexpr auto kUnseen = std::numeric_limits<std::uint32_t>::max();
  OpenEdges open;
  std::vector<std::uint32_t> number(surface.points.size(), kUnseen);
  for (const HalfedgeId h : open_edges) {
    EdgeEnds ends{origin_of(surface, h).index(), target_of(surface, h).index()};
    for (std::uint32_t& end : ends) {
      const Vec3& p = surface.points[VertexId(end)];
      if (number[end] == kUnseen) {
        number[end] = static_cast<std::uint32_t>(open.points.size());
        open.points.push_back(p);
      }
      end = number[end];
    }
    open.edges.push_back(ends);
    open.shortest = std::min(open.shortest, distance(open.points[ends[0]], open.points[ends[1]]));
  }
  return open;
}

/// Whether every open edge finds exactly one partner, and none collapses, if points within `tolerance` merge.
bool closes(const OpenEdges& open, double tolerance) {
  const std::vector<std::uint32_t> kept = merged_points(open.points, tolerance);
  std::vector<EdgeEnds> edges;
  edges.reserve(open.edges.size());
  for (const auto& [from, to] : open.edges) {
    const auto [low, high] = std::minmax(kept[from], kept[to]);
    if (low == high) return false;
    edges.push_back({low, high});
  }
  std::ranges::sort(edges);
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    if (edges[i] != edges[i + 1]) return false;
    if (i + 2 < edges.size() && edges[i] == edges[i + 2]) return false;
  }
  return true;
}

/// Some length that closes the open edges, 0 if none is found. A length that closes a crack is shorter than the edges
/// along it; one that is far too long merges what must stay apart, hence several orders of magnitude are tried.
double any_closing_length(const OpenEdges& open) {
  constexpr double kStep = 0.25;
  constexpr int kNSteps = 6;
  double length = open.shortest;
  for (int i = 0; i < kNSteps; ++i, length *= kStep) {
    if (closes(open, length)) return length;
  }
  return 0;
}

/// The shortest length that still closes: its order of magnitude first, then by bisection to a thousandth.
/// \param closing  a length that closes
double shortest_closing_length(const OpenEdges& open, double closing) {
  constexpr double kShrink = 1.0 / 16;
  constexpr int kNBisections = 14;  // 4 halvings of a bracket of 1 to 16, 10 for the digits
  constexpr double kTiny = 0x1p-20;
  const bool is_soup = closes(open, 0);  // equal points that were not welded: any length does
  if (is_soup) return closing * kTiny;
  double failing = closing * kShrink;
  while (closes(open, failing)) {
    closing = failing;
    failing *= kShrink;
  }
  for (int i = 0; i < kNBisections; ++i) {
    const double middle = 0.5 * (failing + closing);
    (closes(open, middle) ? closing : failing) = middle;
  }
  return closing;
}

/// Three decimal digits, so that a user can copy what a message says.
double rounded_up(double length) {
  // Rounding to three digits moves a number by at most half a percent; so much is added first, and a little.
  constexpr double kMargin = 1.0051;
  const std::string text = fmt::format("{:.3g}", length * kMargin);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

struct EdgeFaults {
  std::size_t n_open = 0;
  std::size_t n_crowded = 0;    // edges of more than two triangles
  std::size_t n_collapsed = 0;  // triangles with a repeated corner
};

EdgeFaults count_edge_faults(const mesh::SurfaceMesh& surface) {
  EdgeFaults faults;
  std::vector<char> is_collapsed(surface.faces.size(), 0);
  for (const FaceId f : surface.faces.ids()) {
    is_collapsed[f.index()] = has_repeated_corner(surface.faces[f]) ? 1 : 0;
    if (is_collapsed[f.index()]) ++faults.n_collapsed;
  }
  const EdgeGroups edges(surface, is_collapsed);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges[e].size() == 1) ++faults.n_open;
    if (edges[e].size() > 2) ++faults.n_crowded;
  }
  return faults;
}

/// The proof on the whole surface: no edge stays open, no other fault of edges arises, no triangle collapses.
bool weld_closes(const mesh::SurfaceMesh& surface, double tolerance) {
  const EdgeFaults before = count_edge_faults(surface);
  const EdgeFaults after = count_edge_faults(weld(surface, tolerance));
  return after.n_open == 0 && after.n_crowded <= before.n_crowded && after.n_collapsed <= before.n_collapsed;
}

}  // namespace

double closing_tolerance(const mesh::SurfaceMesh& surface, std::span<const HalfedgeId> open_edges) {
  const bool can_pair_up = open_edges.size() % 2 == 0;
  if (open_edges.empty() || !can_pair_up) return 0;
  const OpenEdges open = extract(surface, open_edges);
  if (!(open.shortest > 0) || !std::ranges::all_of(open.points, is_finite)) return 0;
  const double closing = any_closing_length(open);
  if (!(closing > 0)) return 0;
  const double tolerance = rounded_up(shortest_closing_length(open, closing));
  return weld_closes(surface, tolerance) ? tolerance : 0;
}

}  // namespace nearwall::surface
