#include "nearwall/surface/smoothing.h"

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"
#include "surface/normals_visible.h"
#include "surface/smoothing_room.h"

namespace nearwall::surface {

namespace {

/// Vertices that one thread takes at a time.
constexpr std::size_t kBlock = 4096;

/// A sum of unit vectors shorter than this has mostly cancelled: its direction is left alone.
constexpr double kCancelled = 0x1p-20;

void check(const SmoothingOptions& options) {
  if (options.iterations < 0) {
    throw InputError(fmt::format("smoothing: expected iterations >= 0, found {}", options.iterations));
  }
  if (!(options.lambda > 0 && options.lambda <= 1)) {
    throw InputError(fmt::format("smoothing: expected lambda in (0, 1], found {}", options.lambda));
  }
  if (options.filter == SmoothingFilter::Taubin && !(options.mu < -options.lambda && std::isfinite(options.mu))) {
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

/// Appends the vertices that a smooth or ridge vertex looks at.
void append_ring(const mesh::Topology& topology, const Features& features, VertexId v, std::vector<VertexId>& ring) {
  const bool along_ridge_only = features.kind[v] == PointKind::Ridge;
  for (const HalfedgeId h : topology.fan(v)) {
    if (!along_ridge_only || features.is_ridge[h]) ring.push_back(topology.target(h));
    // The last edge of an open fan has a halfedge towards v only.
    const HalfedgeId last = mesh::Topology::previous(h);
    if (!along_ridge_only && !topology.twin(last).is_valid()) ring.push_back(topology.origin(last));
  }
}

Neighbours find_neighbours(const mesh::Topology& topology, const Features& features,
                           const IdVector<VertexId, PointNormal>& normals) {
  Neighbours neighbours;
  neighbours.offset.push_back(0);
  for (const VertexId v : normals.ids()) {
    const PointKind kind = features.kind[v];
    if ((kind != PointKind::Smooth && kind != PointKind::Ridge) || !normals[v].is_visible) continue;
    const std::size_t before = neighbours.neighbour.size();
    append_ring(topology, features, v, neighbours.neighbour);
    if (neighbours.neighbour.size() == before) continue;
    neighbours.moving.push_back(v);
    neighbours.offset.push_back(static_cast<std::uint32_t>(neighbours.neighbour.size()));
  }
  return neighbours;
}

/// Moves `own` by `step` of the way to the mean of its neighbours (away from it if negative), back to unit length.
Vec3 stepped(const Vec3& own, std::span<const VertexId> neighbours, const IdVector<VertexId, Vec3>& directions,
             double step) {
  Vec3 sum;
  for (const VertexId v : neighbours) sum += directions[v];
  const Vec3 moved = own * (1.0 - step) + sum * (step / static_cast<double>(neighbours.size()));
  const double size = norm(moved);
  return size > kCancelled ? moved / size : own;
}

/// Calls `body(i, v, faces)` for each moving vertex, in blocks on all threads.
template <class Body>
void for_each_moving(const Neighbours& neighbours, const mesh::Topology& topology, const Features& features,
                     const Body& body) {
  parallel_blocks(neighbours.moving.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    FaceNormals faces(topology, features);
    for (std::size_t i = begin; i < end; ++i) body(i, neighbours.moving[i], faces);
  });
}

}  // namespace

void smooth_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, const Features& features,
                    const SmoothingOptions& options, IdVector<VertexId, PointNormal>& normals) {
  check(options);
  expect(normals.size() == topology.n_vertices() && normals.size() == surface.points.size(),
         "smooth_normals: one normal for each vertex");
  if (options.filter == SmoothingFilter::None || options.iterations == 0) return;

  const Neighbours neighbours = find_neighbours(topology, features, normals);
  const auto for_each = [&](const auto& body) { for_each_moving(neighbours, topology, features, body); };
  std::vector<Room> rooms(neighbours.moving.size());
  for_each([&](std::size_t i, VertexId v, FaceNormals&) { rooms[i] = room_of(normals[v]); });
  IdVector<VertexId, Vec3> current(normals.size());
  for (const VertexId v : normals.ids()) current[v] = normals[v].direction;
  IdVector<VertexId, Vec3> shrunk = current, next = current;

  // Every step reads the array that the step before has written, whole: the order of the vertices plays no part.
  const bool grows_back = options.filter == SmoothingFilter::Taubin;
  const double last_step = grows_back ? options.mu : options.lambda;
  for (int sweep = 0; sweep < options.iterations; ++sweep) {
    if (grows_back) {
      for_each([&](std::size_t i, VertexId v, FaceNormals&) {
        shrunk[v] = stepped(current[v], neighbours.of(i), current, options.lambda);
      });
    }
    const IdVector<VertexId, Vec3>& from = grows_back ? shrunk : current;
    for_each([&](std::size_t i, VertexId v, FaceNormals& faces) {
      const Vec3 wanted = stepped(from[v], neighbours.of(i), from, last_step);
      next[v] = is_surely_in(rooms[i], wanted) ? wanted : drawn_back(wanted, rooms[i], faces.round(v));
    });
    std::swap(current, next);
  }
  for_each([&](std::size_t, VertexId v, FaceNormals& faces) {
    const auto round = faces.round(v);
    normals[v] = judged(current[v], round, squared_chord_to_worst(current[v], round));
  });
}

}  // namespace nearwall::surface
