#include "nearwall/surface/point_normals.h"

#include <vector>

#include "nearwall/core/expect.h"
#include "nearwall/surface/minimum_norm_network.h"
#include "surface/fan_normals.h"

namespace nearwall::surface {

namespace {

IdVector<VertexId, PointNormal> fitted_normals(const FanSource& source, Fit fit) {
  IdVector<VertexId, PointNormal> normals(source.surface.points.size());
  parallel_blocks(normals.size(), kVertexBlock, [&](std::size_t begin, std::size_t end) {
    FanNormals fans(source);
    Neighbourhood neighbourhood(source.topology);
    std::vector<Vec3> neighbours;
    for (std::size_t i = begin; i < end; ++i) {
      const VertexId v(i);
      const auto faces = source.topology.fan(v);
      const Vec3 axis = fans.mean(Weight::Max, v, faces);
      neighbours.clear();
      for (const VertexId w : neighbourhood.of(v)) neighbours.push_back(source.surface.points[w]);
      const auto fitted = fitted_normal(fit, source.surface.points[v], axis, neighbours);
      normals[v] = fans.judge(fitted.value_or(axis), faces);
      normals[v].is_fallback = !fitted;
    }
  });
  return normals;
}

IdVector<VertexId, PointNormal> network_normals(const FanSource& source) {
  IdVector<VertexId, Vec3> axes(source.surface.points.size());
  for_each_vertex(source,
                  [&](VertexId v, FanNormals& fans) { axes[v] = fans.mean(Weight::Max, v, source.topology.fan(v)); });
  const NetworkNormals network = minimum_norm_network_normals(source.surface, source.topology, axes);
  IdVector<VertexId, PointNormal> normals(axes.size());
  for_each_vertex(source, [&](VertexId v, FanNormals& fans) {
    normals[v] = fans.judge(network.direction[v], source.topology.fan(v));
    normals[v].is_fallback = network.is_axis[v] != 0;
  });
  return normals;
}

}  // namespace

IdVector<VertexId, PointNormal> point_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology,
                                              const Features& features, const NormalOptions& options) {
  expect(surface.points.size() == topology.n_vertices(), "point_normals: surface and topology are of the same mesh");
  expect(features.face_normal.size() == topology.n_faces(), "point_normals: features are of the same mesh");
  const FanSource source(surface, topology, features, options);
  if (options.method == NormalMethod::Nielson) return network_normals(source);
  if (const auto fit = fit_of(options.method)) return fitted_normals(source, *fit);
  IdVector<VertexId, PointNormal> normals(surface.points.size());
  for_each_vertex(source, [&](VertexId v, FanNormals& fans) { normals[v] = fans.of(v, topology.fan(v)); });
  return normals;
}

void replace_blind_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, const Features& features,
                           IdVector<VertexId, PointNormal>& normals) {
  const FanSource source(surface, topology, features, {.method = NormalMethod::MostVisible});
  for_each_vertex(source, [&](VertexId v, FanNormals& fans) {
    if (normals[v].is_visible) return;
    const PointNormal best = fans.of(v, topology.fan(v));
    if (best.is_visible) normals[v] = best;
    normals[v].is_fallback = true;
  });
}

}  // namespace nearwall::surface
