#include "nearwall/surface/point_normals.h"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/surface/fitted_normals.h"
#include "nearwall/surface/minimum_norm_network.h"
#include "surface/fan_normals.h"
#include "surface/thin_faces.h"

namespace nearwall::surface {

namespace {

/// Vertices that one thread takes at a time.
constexpr std::size_t kBlock = 4096;

/// What the normals of one surface are made from, and the options in force.
struct Source {
  const mesh::SurfaceMesh& surface;
  const mesh::Topology& topology;
  const Features& features;
  const NormalOptions& options;
  std::vector<char> is_left_out;
};

/// Calls `body(v, fan_normals, neighbourhood)` for each vertex, in blocks on all threads.
template <class Body>
void for_each_vertex(const Source& source, const Body& body) {
  parallel_blocks(source.surface.points.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    FanNormals fans(source.surface, source.topology, source.features, source.options, source.is_left_out);
    Neighbourhood neighbourhood(source.topology);
    for (std::size_t i = begin; i < end; ++i) body(VertexId(i), fans, neighbourhood);
  });
}

std::optional<Fit> fit_of(NormalMethod method) {
  switch (method) {
    case NormalMethod::LinearFit:
      return Fit::LinearLeastSquares;
    case NormalMethod::QuadraticFit:
      return Fit::QuadraticLeastSquares;
    case NormalMethod::RenkaCline:
      return Fit::RenkaCline;
    case NormalMethod::Shepard:
      return Fit::Shepard;
    case NormalMethod::Hardy:
      return Fit::Hardy;
    case NormalMethod::ThinPlate:
      return Fit::ThinPlate;
    default:
      return std::nullopt;
  }
}

IdVector<VertexId, PointNormal> fitted_normals(const Source& source, Fit fit) {
  IdVector<VertexId, PointNormal> normals(source.surface.points.size());
  for_each_vertex(source, [&](VertexId v, FanNormals& fans, Neighbourhood& neighbourhood) {
    const auto faces = source.topology.fan(v);
    const Vec3 axis = fans.mean(Weight::Max, v, faces);
    std::vector<Vec3> neighbours;
    for (const VertexId w : neighbourhood.of(v)) neighbours.push_back(source.surface.points[w]);
    const auto fitted = fitted_normal(fit, source.surface.points[v], axis, neighbours);
    normals[v] = fans.judge(fitted.value_or(axis), faces);
    normals[v].is_fallback = !fitted;
  });
  return normals;
}

IdVector<VertexId, PointNormal> network_normals(const Source& source) {
  IdVector<VertexId, Vec3> axes(source.surface.points.size());
  for_each_vertex(source, [&](VertexId v, FanNormals& fans, Neighbourhood&) {
    axes[v] = fans.mean(Weight::Max, v, source.topology.fan(v));
  });
  const auto directions = minimum_norm_network_normals(source.surface, source.topology, axes);
  IdVector<VertexId, PointNormal> normals(axes.size());
  for_each_vertex(source, [&](VertexId v, FanNormals& fans, Neighbourhood&) {
    normals[v] = fans.judge(directions[v], source.topology.fan(v));
  });
  return normals;
}

IdVector<VertexId, PointNormal> fan_normals(const Source& source) {
  IdVector<VertexId, PointNormal> normals(source.surface.points.size());
  for_each_vertex(
      source, [&](VertexId v, FanNormals& fans, Neighbourhood&) { normals[v] = fans.of(v, source.topology.fan(v)); });
  return normals;
}

}  // namespace

IdVector<VertexId, PointNormal> point_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology,
                                              const Features& features, const NormalOptions& options) {
  expect(surface.points.size() == topology.n_vertices(), "point_normals: surface and topology are of the same mesh");
  expect(features.face_normal.size() == topology.n_faces(), "point_normals: features are of the same mesh");
  if (!(options.thin_angle > 0 && options.thin_angle <= geometry::kPi)) {
    throw InputError(fmt::format("thin_angle: expected more than 0 and at most 180 degrees, found {}",
                                 geometry::to_degrees(options.thin_angle)));
  }
  const Source source{surface, topology, features, options, thin_boundary_faces(surface, topology, options.thin_angle)};
  if (options.method == NormalMethod::Nielson) return network_normals(source);
  if (const auto fit = fit_of(options.method)) return fitted_normals(source, *fit);
  return fan_normals(source);
}

void replace_blind_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, const Features& features,
                           IdVector<VertexId, PointNormal>& normals) {
  const NormalOptions most_visible;
  const Source source{surface, topology, features, most_visible, {}};
  for_each_vertex(source, [&](VertexId v, FanNormals& fans, Neighbourhood&) {
    if (normals[v].is_visible) return;
    const PointNormal best = fans.of(v, topology.fan(v));
    if (best.is_visible) normals[v] = best;
    normals[v].is_fallback = true;
  });
}

}  // namespace nearwall::surface
