#include "nearwall/surface/smoothing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/surface/iterative_normals.h"
#include "surface/face_normals.h"
#include "surface/normals_cap.h"
#include "surface/normals_visible.h"
#include "surface/smoothing_room.h"

namespace nearwall::surface {

namespace {

/// A sum of unit vectors shorter than this has mostly cancelled: its direction is left alone.
constexpr double kCancelled = 0x1p-20;

bool grows_back(SmoothingFilter filter) {
  return filter == SmoothingFilter::Taubin || filter == SmoothingFilter::MostVisibleTaubin;
}

bool looks_for_most_visible(SmoothingFilter filter) {
  return filter == SmoothingFilter::MostVisible || filter == SmoothingFilter::MostVisibleTaubin;
}

void check(const SmoothingOptions& options) {
  if (options.iterations < 0) {
    throw InputError(fmt::format("smoothing: expected iterations >= 0, found {}", options.iterations));
  }
  if (!(options.lambda > 0 && options.lambda <= 1)) {
    throw InputError(fmt::format("smoothing: expected lambda in (0, 1], found {}", options.lambda));
  }
  if (!(options.trigger > 0 && options.trigger <= 1)) {
    throw InputError(fmt::format("smoothing: expected trigger in (0, 1], found {}", options.trigger));
  }
  if (grows_back(options.filter) && !(options.mu < -options.lambda && std::isfinite(options.mu))) {
    throw InputError(fmt::format("smoothing: expected mu < -lambda = {}, found {}", -options.lambda, options.mu));
  }
}

/// The vertices whose normals move, and whose normals each of them looks at.
struct Neighbours {
  std::vector<VertexId> moving;
  std::vector<std::uint32_t> offset;  // (moving.size() + 1)
  std::vector<VertexId> neighbour;

  std::span<const VertexId> of(std::size_t i) const {
    return {neighbour.data() + offset[i], neighbour.data() + offset[i + 1]};
  }
};

/// Calls `body(w)` for each vertex that a smooth or ridge vertex looks at.
template <class Body>
void for_each_in_sight(const mesh::Topology& topology, const Features& features, VertexId v, const Body& body) {
  if (features.kind[v] != PointKind::Ridge) {
    topology.for_each_neighbour(v, body);
    return;
  }
  for (const HalfedgeId h : topology.fan(v)) {
    if (features.is_ridge[h]) body(topology.target(h));
  }
}

Neighbours find_neighbours(const mesh::Topology& topology, const Features& features,
                           const IdVector<VertexId, PointNormal>& normals, const IdVector<VertexId, char>& is_held) {
  IdVector<VertexId, std::uint32_t> n_in_sight(normals.size());
  parallel_for(normals.size(), [&](std::size_t i) {
    const VertexId v(i);
    const PointKind kind = features.kind[v];
    std::uint32_t n = 0;
    if ((is_held.empty() || !is_held[v]) && (kind == PointKind::Smooth || kind == PointKind::Ridge) &&
        normals[v].is_visible) {
      for_each_in_sight(topology, features, v, [&](VertexId) { ++n; });
    }
    n_in_sight[v] = n;
  });
  Neighbours neighbours;
  neighbours.moving.reserve(normals.size());
  neighbours.offset.reserve(normals.size() + 1);
  neighbours.offset.push_back(0);
  for (const VertexId v : normals.ids()) {
    if (n_in_sight[v] == 0) continue;
    neighbours.moving.push_back(v);
    neighbours.offset.push_back(neighbours.offset.back() + n_in_sight[v]);
  }
  neighbours.neighbour.resize(neighbours.offset.back());
  parallel_for(neighbours.moving.size(), [&](std::size_t i) {
    VertexId* next = neighbours.neighbour.data() + neighbours.offset[i];
    for_each_in_sight(topology, features, neighbours.moving[i], [&](VertexId w) { *next++ = w; });
  });
  return neighbours;
}

/// Moves directions towards what their neighbours say, one vertex after the other.
class Mover {
 public:
  explicit Mover(const SmoothingOptions& options) : options_(options) {}

  /// `own` moved by `step` of the way to its neighbours (away from them if negative), back to unit length.
  Vec3 stepped(const Vec3& own, std::span<const VertexId> neighbours, const IdVector<VertexId, Vec3>& directions,
               double step) {
    const Vec3 goal = looks_for_most_visible(options_.filter) ? most_visible(own, neighbours, directions)
                                                              : mean(neighbours, directions);
    const Vec3 moved = own * (1.0 - step) + goal * step;
    const double size = norm(moved);
    return size > kCancelled ? moved / size : own;
  }

 private:
  static Vec3 mean(std::span<const VertexId> neighbours, const IdVector<VertexId, Vec3>& directions) {
    Vec3 sum;
    for (const VertexId v : neighbours) sum += directions[v];
    return sum / static_cast<double>(neighbours.size());
  }

  /// The direction itself where nothing sees all of its neighbours' directions.
  Vec3 most_visible(const Vec3& own, std::span<const VertexId> neighbours, const IdVector<VertexId, Vec3>& directions) {
    Vec3 sum;
    for (const VertexId v : neighbours) sum += directions[v];
    const double size = norm(sum);
    double least = size;
    for (const VertexId v : neighbours) least = std::min(least, dot(directions[v], sum));
    if (least > options_.trigger * size) return sum / size;
    if (room_.size() < neighbours.size()) room_.resize(neighbours.size());
    for (std::size_t k = 0; k < neighbours.size(); ++k) room_[k] = directions[neighbours[k]];
    const Vec3 best = search({room_.data(), neighbours.size()});
    return best != Vec3{} ? best : own;
  }

  /// Zero where nothing sees all directions.
  Vec3 search(std::span<const Vec3> directions) const {
    if (options_.search == SearchMethod::Direct) return smallest_cap(directions).centre;
    const IterativeNormal found = iterative_normal(directions);
    return found.max_angle < geometry::kPi / 2 ? found.direction : Vec3{};
  }

  const SmoothingOptions& options_;
  std::vector<Vec3> room_;
};

/// Calls `body(i, v, tools)` for each moving vertex, in blocks on all threads; `make_tools()` is called for each block.
template <class MakeTools, class Body>
void for_each_moving(const Neighbours& neighbours, const MakeTools& make_tools, const Body& body) {
  parallel_blocks(neighbours.moving.size(), kVertexBlock, [&](std::size_t begin, std::size_t end) {
    auto tools = make_tools();
    for (std::size_t i = begin; i < end; ++i) body(i, neighbours.moving[i], tools);
  });
}

}  // namespace

std::string_view filter_name(SmoothingFilter filter) { return kSmoothingFilterNames[static_cast<std::size_t>(filter)]; }

std::optional<SmoothingFilter> smoothing_filter(std::string_view name) {
  const auto at = std::find(kSmoothingFilterNames.begin(), kSmoothingFilterNames.end(), name);
  if (at == kSmoothingFilterNames.end()) return std::nullopt;
  return static_cast<SmoothingFilter>(at - kSmoothingFilterNames.begin());
}

void smooth_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, const Features& features,
                    const SmoothingOptions& options, IdVector<VertexId, PointNormal>& normals,
                    const IdVector<VertexId, char>& is_held) {
  check(options);
  expect(normals.size() == topology.n_vertices() && normals.size() == surface.points.size(),
         "smooth_normals: one normal for each vertex");
  expect(is_held.empty() || is_held.size() == normals.size(), "smooth_normals: one mark for each vertex, or none");
  if (options.filter == SmoothingFilter::None || options.iterations == 0) return;

  const Neighbours neighbours = find_neighbours(topology, features, normals, is_held);
  struct Tools {
    Mover mover;
    FaceNormals faces;
  };
  const auto for_each = [&](const auto& body) {
    for_each_moving(
        neighbours,
        [&] {
          return Tools{Mover(options), FaceNormals(features)};
        },
        body);
  };
  std::vector<Room> rooms(neighbours.moving.size());
  for_each([&](std::size_t i, VertexId v, Tools&) { rooms[i] = room_of(normals[v]); });
  IdVector<VertexId, Vec3> current(normals.size());
  parallel_for(normals.size(), [&](std::size_t i) { current[VertexId(i)] = normals[VertexId(i)].direction; });
  IdVector<VertexId, Vec3> next = current, shrunk;

  // Every step reads the array that the step before has written, whole: the order of the vertices plays no part.
  const bool has_counter_step = grows_back(options.filter);
  if (has_counter_step) shrunk = current;
  const double last_step = has_counter_step ? options.mu : options.lambda;
  for (int sweep = 0; sweep < options.iterations; ++sweep) {
    if (has_counter_step) {
      for_each([&](std::size_t i, VertexId v, Tools& tools) {
        shrunk[v] = tools.mover.stepped(current[v], neighbours.of(i), current, options.lambda);
      });
    }
    const IdVector<VertexId, Vec3>& from = has_counter_step ? shrunk : current;
    for_each([&](std::size_t i, VertexId v, Tools& tools) {
      const Vec3 wanted = tools.mover.stepped(from[v], neighbours.of(i), from, last_step);
      next[v] = is_surely_in(rooms[i], wanted) ? wanted : drawn_back(wanted, rooms[i], tools.faces.of(topology.fan(v)));
    });
    std::swap(current, next);
  }
  for_each([&](std::size_t, VertexId v, Tools& tools) {
    const auto round = tools.faces.of(topology.fan(v));
    const bool is_fallback = normals[v].is_fallback;
    normals[v] = judged(current[v], round, squared_chord_to_worst(current[v], round));
    normals[v].is_fallback = is_fallback;
  });
}

}  // namespace nearwall::surface
