#include "nearwall/surface/point_normals.h"

#include <vector>

#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"
#include "surface/fan_normals.h"

namespace nearwall::surface {

namespace {

/// Vertices that one thread takes at a time.
constexpr std::size_t kBlock = 4096;

/// Calls `body(v, fan_normals)` for each vertex, in blocks on all threads.
template <class Body>
void for_each_vertex(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, const Features& features,
                     const NormalOptions& options, const std::vector<char>& is_left_out, const Body& body) {
  parallel_blocks(surface.points.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    FanNormals fans(surface, topology, features, options, is_left_out);
    for (std::size_t i = begin; i < end; ++i) body(VertexId(i), fans);
  });
}

}  // namespace

IdVector<VertexId, PointNormal> point_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology,
                                              const Features& features, const NormalOptions& options) {
  expect(surface.points.size() == topology.n_vertices(), "point_normals: surface and topology are of the same mesh");
  expect(features.face_normal.size() == topology.n_faces(), "point_normals: features are of the same mesh");
  IdVector<VertexId, PointNormal> normals(surface.points.size());
  for_each_vertex(surface, topology, features, options, {},
                  [&](VertexId v, FanNormals& fans) { normals[v] = fans.of(v, topology.fan(v)); });
  return normals;
}

void replace_blind_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, const Features& features,
                           IdVector<VertexId, PointNormal>& normals) {
  const NormalOptions most_visible;
  for_each_vertex(surface, topology, features, most_visible, {}, [&](VertexId v, FanNormals& fans) {
    if (normals[v].is_visible) return;
    const PointNormal best = fans.of(v, topology.fan(v));
    if (best.is_visible) normals[v] = best;
    normals[v].is_fallback = true;
  });
}

}  // namespace nearwall::surface
