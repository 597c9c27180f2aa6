#include "nearwall/surface/patch_normals.h"

#include <fmt/format.h>

#include <algorithm>

#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"
#include "nearwall/geometry/angles.h"
#include "surface/fan_normals.h"

namespace nearwall::surface {

namespace {

using mesh::Topology;

bool is_convex_ridge(const Features& features, HalfedgeId h) { return features.is_ridge[h] && features.turn[h] > 0; }

/// Vertices at which convex ridges meet or pass and which no direction sees under less than the steep angle.
IdVector<VertexId, char> find_steep(const mesh::SurfaceMesh& surface, const Topology& topology,
                                    const Features& features, double steep_angle) {
  IdVector<VertexId, char> is_steep(topology.n_vertices(), 0);
  const FanSource source(surface, topology, features, {.method = NormalMethod::MostVisible});
  for_each_vertex(source, [&](VertexId v, FanNormals& fans) {
    const auto fan = topology.fan(v);
    if (!std::any_of(fan.begin(), fan.end(), [&](HalfedgeId h) { return is_convex_ridge(features, h); })) return;
    const PointNormal normal = fans.of(v, fan);
    is_steep[v] = normal.is_visible && normal.max_angle <= steep_angle ? 0 : 1;
  });
  return is_steep;
}

/// The other ridge edge at the target of h, leaving it, if the ridge passes through there.
HalfedgeId next_along_ridge(const Topology& topology, const Features& features, HalfedgeId h) {
  const VertexId v = topology.target(h);
  if (features.kind[v] != PointKind::Ridge) return {};
  for (const HalfedgeId out : topology.fan(v)) {
    if (features.is_ridge[out] && out != topology.twin(h)) return out;
  }
  return {};
}

/// All edges of the ridge through `start`, one halfedge of each.
void collect_ridge(const Topology& topology, const Features& features, HalfedgeId start,
                   std::vector<HalfedgeId>& ridge) {
  ridge.assign(1, start);
  for (const HalfedgeId first : {start, topology.twin(start)}) {
    for (HalfedgeId h = next_along_ridge(topology, features, first); h.is_valid();
         h = next_along_ridge(topology, features, h)) {
      if (h == start) return;  // a closed loop
      ridge.push_back(h);
    }
  }
}

/// The faces round one vertex after the other, divided into runs.
class Runs {
 public:
  Runs(const Topology& topology, const IdVector<HalfedgeId, char>& is_separator)
      : topology_(topology), separates_{is_separator} {}

  /// Runs round v: as many as separators if the faces close up, but at least one; one more on a boundary.
  std::uint32_t count(VertexId v) const {
    const auto fan = topology_.fan(v);
    if (fan.empty()) return 0;
    const auto n = static_cast<std::uint32_t>(std::count_if(fan.begin(), fan.end(), separates_));
    return topology_.is_boundary(v) ? n + 1 : std::max(n, 1u);
  }

  /// Calls `body(k, faces)` for each run round v: the one with the first face of the fan is number 0.
  template <class Body>
  void for_each(VertexId v, const Body& body) {
    const auto fan = topology_.fan(v);
    auto start = fan.begin();
    if (!topology_.is_boundary(v) && count(v) > 1) start = std::find_if(fan.begin(), fan.end(), separates_);
    // Begun at a separator, no run is cut in two. The fan's first face is then in the last one, or begins the first.
    turned_.assign(start, fan.end());
    turned_.insert(turned_.end(), fan.begin(), start);
    const std::uint32_t n = count(v), first = start == fan.begin() ? 0 : 1;
    auto from = turned_.begin();
    for (std::uint32_t k = 0; k < n; ++k) {
      const auto to = k + 1 == n ? turned_.end() : std::find_if(from + 1, turned_.end(), separates_);
      body((first + k) % n, std::span<const HalfedgeId>(from, to));
      from = to;
    }
  }

 private:
  struct Separates {
    const IdVector<HalfedgeId, char>& is_separator;
    bool operator()(HalfedgeId h) const { return is_separator[h] != 0; }
  };

  const Topology& topology_;
  Separates separates_;
  std::vector<HalfedgeId> turned_;
};

IdVector<VertexId, std::uint32_t> offsets(const Topology& topology, const IdVector<HalfedgeId, char>& is_separator) {
  const std::size_t n = topology.n_vertices();
  IdVector<VertexId, std::uint32_t> offset(n + 1, 0);
  const Runs runs(topology, is_separator);
  parallel_for(n, [&](std::size_t i) { offset[VertexId(i + 1)] = runs.count(VertexId(i)); });
  for (std::size_t i = 0; i < n; ++i) offset[VertexId(i + 1)] += offset[VertexId(i)];
  return offset;
}

/// The ridges that divide the faces round their ends.
IdVector<HalfedgeId, char> separators(const mesh::SurfaceMesh& surface, const Topology& topology,
                                      const Features& features, Separation separation, const GroupOptions& groups) {
  return separation == Separation::Groups ? ridges_with_several_lines(surface, topology, features, groups)
                                          : features.is_ridge;
}

}  // namespace

IdVector<HalfedgeId, char> ridges_with_several_lines(const mesh::SurfaceMesh& surface, const Topology& topology,
                                                     const Features& features, const GroupOptions& options) {
  if (!(options.multi_angle > 0 && options.multi_angle < geometry::kPi)) {
    throw InputError(fmt::format("multi_angle: expected an angle between 0 and 180 degrees, found {}",
                                 geometry::to_degrees(options.multi_angle)));
  }
  if (!(options.steep_angle > 0 && options.steep_angle <= geometry::kPi / 2)) {
    throw InputError(fmt::format("steep_angle: expected an angle above 0 and up to 90 degrees, found {}",
                                 geometry::to_degrees(options.steep_angle)));
  }
  const IdVector<VertexId, char> is_steep = find_steep(surface, topology, features, options.steep_angle);
  IdVector<HalfedgeId, char> has_several(features.is_ridge.size(), 0), is_done = has_several;
  std::vector<HalfedgeId> ridge;
  for (const HalfedgeId start : features.is_ridge.ids()) {
    if (is_done[start] || !is_convex_ridge(features, start)) continue;
    collect_ridge(topology, features, start, ridge);
    bool needs_several = false;
    for (const HalfedgeId h : ridge) {
      needs_several |= features.turn[h] > options.multi_angle || is_steep[topology.origin(h)] != 0 ||
                       is_steep[topology.target(h)] != 0;
    }
    for (const HalfedgeId h : ridge) {
      is_done[h] = is_done[topology.twin(h)] = 1;
      has_several[h] = has_several[topology.twin(h)] = needs_several ? 1 : 0;
    }
  }
  return has_several;
}

CornerGroups corner_groups(const Topology& topology, const IdVector<HalfedgeId, char>& is_separator) {
  CornerGroups groups{IdVector<VertexId, std::uint32_t>(topology.n_vertices() + 1, 0),
                      IdVector<HalfedgeId, std::uint32_t>(is_separator.size())};
  const Runs all(topology, is_separator);
  for (std::size_t i = 0; i < topology.n_vertices(); ++i) {
    groups.offset[VertexId(i + 1)] = groups.offset[VertexId(i)] + std::max(1u, all.count(VertexId(i)));
  }
  parallel_blocks(topology.n_vertices(), kVertexBlock, [&](std::size_t begin, std::size_t end) {
    Runs runs(topology, is_separator);
    for (std::size_t i = begin; i < end; ++i) {
      const VertexId v(i);
      runs.for_each(v, [&](std::uint32_t k, std::span<const HalfedgeId> faces) {
        for (const HalfedgeId h : faces) groups.of_corner[h] = groups.offset[v] + k;
      });
    }
  });
  return groups;
}

IdVector<VertexId, std::uint32_t> group_offsets(const mesh::SurfaceMesh& surface, const Topology& topology,
                                                const Features& features, Separation separation,
                                                const GroupOptions& groups) {
  return offsets(topology, separators(surface, topology, features, separation, groups));
}

bool is_for_runs(NormalMethod method) {
  return weight_of(method).has_value() || method == NormalMethod::MostVisible || method == NormalMethod::Kallinderis ||
         method == NormalMethod::Pirzadeh || method == NormalMethod::Iterative;
}

PatchNormals patch_normals(const mesh::SurfaceMesh& surface, const Topology& topology, const Features& features,
                           Separation separation, const NormalOptions& options, const GroupOptions& groups) {
  expect(surface.points.size() == topology.n_vertices(), "patch_normals: surface and topology are of the same mesh");
  expect(features.face_normal.size() == topology.n_faces(), "patch_normals: features are of the same mesh");
  if (!is_for_runs(options.method)) {
    throw InputError(
        fmt::format("patch_normals: expected a method that needs only some of the faces round a vertex, "
                    "found {}",
                    method_name(options.method)));
  }
  const IdVector<HalfedgeId, char> is_separator = separators(surface, topology, features, separation, groups);
  PatchNormals result;
  result.offset = offsets(topology, is_separator);
  result.normal.resize(result.offset.raw().back());
  result.group_of_corner.resize(3 * topology.n_faces());
  const FanSource source(surface, topology, features, options);
  parallel_blocks(topology.n_vertices(), kVertexBlock, [&](std::size_t begin, std::size_t end) {
    FanNormals fans(source);
    Runs runs(topology, is_separator);
    for (std::size_t i = begin; i < end; ++i) {
      const VertexId v(i);
      runs.for_each(v, [&](std::uint32_t k, std::span<const HalfedgeId> faces) {
        const std::uint32_t group = result.offset[v] + k;
        result.normal[group] = fans.of(v, faces);
        for (const HalfedgeId h : faces) result.group_of_corner[h] = group;
      });
    }
  });
  return result;
}

}  // namespace nearwall::surface
