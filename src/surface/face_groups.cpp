#include "surface/face_groups.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace nearwall::surface {
namespace {

/// Disjoint sets of numbers; the smallest member stands for its set.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

using Corners = std::array<VertexId, 3>;

/// A face by its corners in increasing order.
struct SortedFace {
  VertexId low, middle, high;
  FaceId face;
  auto operator<=>(const SortedFace&) const = default;

  bool has_corners_of(const SortedFace& other) const {
    return low == other.low && middle == other.middle && high == other.high;
  }
};

SortedFace sorted_face(Corners corners, FaceId f) {
  std::ranges::sort(corners);
  return {corners[0], corners[1], corners[2], f};
}

/// Whether the face runs from its smallest to its middle to its largest corner.
bool runs_upwards(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners[1] < corners[2];
}

/// Corner of the face of h that lies at v: 3 f + k.
std::uint32_t corner_at(const mesh::SurfaceMesh& surface, HalfedgeId h, VertexId v) {
  const std::uint32_t f = h.index() / 3;
  const std::uint32_t k = h.index() % 3;
  return origin_of(surface, h) == v ? h.index() : 3 * f + (k + 1) % 3;
}

}  // namespace

Copies find_copies(const mesh::SurfaceMesh& surface) {
  Copies copies;
  copies.kind.assign(surface.faces.size(), Copy::None);
  std::vector<SortedFace> entries;
  for (const FaceId f : surface.faces.ids()) {
    copies.original.push_back(f);
    if (!has_repeated_corner(surface.faces[f])) entries.push_back(sorted_face(surface.faces[f], f));
  }
  std::ranges::sort(entries);
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    std::array<bool, 2> is_seen = {false, false};
    while (end < entries.size() && entries[end].has_corners_of(entries[begin])) {
      const FaceId f = entries[end].face;
      const std::size_t way = runs_upwards(surface.faces[f]) ? 1 : 0;
      copies.original[f] = entries[begin].face;
      if (end != begin) copies.kind[f] = is_seen[way] ? Copy::Same : Copy::Reversed;
      is_seen[way] = true;
      ++end;
    }
  }
  return copies;
}

IdVector<FaceId, ComponentId> find_components(const mesh::SurfaceMesh& surface, std::size_t& n_components) {
  DisjointSets sets(surface.points.size());
  for (const auto& face : surface.faces) {
    sets.unite(face[0].index(), face[1].index());
    sets.unite(face[0].index(), face[2].index());
  }
  n_components = 0;
  std::vector<ComponentId> number(surface.points.size());
  IdVector<FaceId, ComponentId> component(surface.faces.size());
  for (const FaceId f : surface.faces.ids()) {
    ComponentId& c = number[sets.find(surface.faces[f][0].index())];
    if (!c.is_valid()) c = ComponentId(n_components++);
    component[f] = c;
  }
  return component;
}

std::vector<PinchedVertex> find_pinched_vertices(const mesh::SurfaceMesh& surface, const EdgeGroups& edges,
                                                 std::span<const char> is_left_out) {
  DisjointSets fans(3 * surface.faces.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const HalfedgeId first = edges[e].front();
    for (const VertexId v : {origin_of(surface, first), target_of(surface, first)}) {
      for (const HalfedgeId h : edges[e].subspan(1)) fans.unite(corner_at(surface, first, v), corner_at(surface, h, v));
    }
  }
  constexpr std::uint32_t kNoFan = HalfedgeId().index();
  IdVector<VertexId, std::uint32_t> fan(surface.points.size(), kNoFan);
  IdVector<VertexId, std::uint32_t> pinched(surface.points.size(), 0);  // 1 + position in the result
  std::vector<PinchedVertex> result;
  const auto for_each_corner = [&](auto&& visit) {
    for (const FaceId f : surface.faces.ids()) {
      if (is_left_out[f.index()]) continue;
      for (std::uint32_t k = 0; k < 3; ++k) visit(f, surface.faces[f][k], 3 * f.index() + k);
    }
  };
  for_each_corner([&](FaceId, VertexId v, std::uint32_t corner) {
    const std::uint32_t own_fan = fans.find(corner);
    if (fan[v] == kNoFan) fan[v] = own_fan;
    if (fan[v] == own_fan || pinched[v] != 0) return;
    result.push_back({v, {}});
    pinched[v] = static_cast<std::uint32_t>(result.size());
  });
  for_each_corner([&](FaceId f, VertexId v, std::uint32_t) {
    if (pinched[v] != 0) result[pinched[v] - 1].faces.push_back(f);
  });
  return result;
}

bool disagree(const mesh::SurfaceMesh& surface, std::span<const HalfedgeId> edge_of_two) {
  return origin_of(surface, edge_of_two[0]) == origin_of(surface, edge_of_two[1]);
}

std::vector<char> find_turns(const mesh::SurfaceMesh& surface, const EdgeGroups& edges) {
  struct Link {
    FaceId to;
    bool disagrees = false;
  };
  const std::size_t n = surface.faces.size();
  std::vector<std::array<Link, 3>> links(n);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges[e].size() != 2) continue;
    const bool disagrees = disagree(surface, edges[e]);
    const HalfedgeId a = edges[e][0], b = edges[e][1];
    links[face_of(a).index()][a.index() % 3] = {face_of(b), disagrees};
    links[face_of(b).index()][b.index() % 3] = {face_of(a), disagrees};
  }
  constexpr char kUnseen = 2;
  std::vector<char> turn(n, kUnseen);
  std::vector<FaceId> linked;  // the faces linked to the seed, in the order in which they are found
  for (std::size_t seed = 0; seed < n; ++seed) {
    if (turn[seed] != kUnseen) continue;
    turn[seed] = 0;
    linked.assign(1, FaceId(seed));
    bool is_one_sided = false;
    std::size_t n_turned = 0;
    for (std::size_t i = 0; i < linked.size(); ++i) {
      const char own = turn[linked[i].index()];
      n_turned += own == 1 ? 1 : 0;
      for (const Link& link : links[linked[i].index()]) {
        if (!link.to.is_valid()) continue;
        char& other = turn[link.to.index()];
        const char wanted = link.disagrees ? static_cast<char>(1 - own) : own;
        if (other == kUnseen) {
          other = wanted;
          linked.push_back(link.to);
        } else if (other != wanted) {
          is_one_sided = true;
        }
      }
    }
    const bool turns_the_rest = 2 * n_turned > linked.size();
    for (const FaceId f : linked) {
      char& t = turn[f.index()];
      t = is_one_sided ? char{0} : turns_the_rest ? static_cast<char>(1 - t) : t;
    }
  }
  return turn;
}

}  // namespace nearwall::surface
