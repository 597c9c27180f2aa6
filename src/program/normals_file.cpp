#include "program/normals_file.h"

#include <algorithm>

#include "nearwall/geometry/angles.h"

namespace nearwall::program {

namespace {

using surface::PointNormal;

/// Number of runs into which the separators cut the faces round each vertex.
IdVector<VertexId, std::int32_t> runs_at_vertices(const NormalsSource& source, surface::Separation separation) {
  const auto offset = surface::group_offsets(source.mesh, source.topology, source.features, separation, source.groups);
  IdVector<VertexId, std::int32_t> n(source.mesh.points.size());
  for (const VertexId v : n.ids()) n[v] = static_cast<std::int32_t>(offset[VertexId(v.index() + 1)] - offset[v]);
  return n;
}

/// Point arrays for normals that stand on the vertices `wall`.
void add_point_arrays(const NormalsSource& source, const std::vector<VertexId>& wall,
                      const std::vector<PointNormal>& normals, ShownNormals& shown) {
  const auto patches = runs_at_vertices(source, surface::Separation::DiscretePatches);
  const auto groups = runs_at_vertices(source, surface::Separation::Groups);
  std::vector<double> directions, angles;
  std::vector<std::int32_t> kinds, n_patches, n_groups, fallbacks, vertices;
  for (std::size_t i = 0; i < wall.size(); ++i) {
    const PointNormal& n = normals[i];
    directions.insert(directions.end(), {n.direction.x(), n.direction.y(), n.direction.z()});
    angles.push_back(geometry::to_degrees(n.max_angle));
    kinds.push_back(static_cast<std::int32_t>(source.features.kind[wall[i]]));
    n_patches.push_back(patches[wall[i]]);
    n_groups.push_back(groups[wall[i]]);
    fallbacks.push_back(n.is_fallback ? 1 : 0);
    vertices.push_back(static_cast<std::int32_t>(wall[i].index()));
    shown.n_blind += n.is_visible ? 0 : 1;
    shown.n_fallbacks += n.is_fallback ? 1 : 0;
    shown.worst_angle = std::max(shown.worst_angle, n.max_angle);
  }
  shown.n_normals = wall.size();
  auto& data = shown.file.point_data;
  data.push_back({"Normals", std::move(directions), 3});
  data.push_back({"VisibilityAngle", std::move(angles)});
  data.push_back({"PointKind", std::move(kinds)});
  data.push_back({"Patches", std::move(n_patches)});
  data.push_back({"Groups", std::move(n_groups)});
  data.push_back({"Fallback", std::move(fallbacks)});
  data.push_back({"Vertex", std::move(vertices)});
}

/// \param point_of  point of the file for the corner at which a halfedge begins
template <class PointOf>
void add_ridges(const NormalsSource& source, const PointOf& point_of, io::PolyDataFile& file) {
  std::vector<double> turns;
  for (const HalfedgeId h : source.features.turn.ids()) {
    const HalfedgeId twin = source.topology.twin(h);
    if (!source.features.is_ridge[h] || (twin.is_valid() && twin < h)) continue;
    file.lines.push_back({point_of(h), point_of(mesh::Topology::next(h))});
    turns.push_back(geometry::to_degrees(source.features.turn[h]));
  }
  file.line_data.push_back({"Turn", std::move(turns)});
}

}  // namespace

ShownNormals normals_of_vertices(const NormalsSource& source, const surface::SmoothingOptions& smoothing) {
  auto normals = surface::point_normals(source.mesh, source.topology, source.features, source.options);
  surface::smooth_normals(source.mesh, source.topology, source.features, smoothing, normals);
  ShownNormals shown;
  shown.file = io::polydata_of(source.mesh);
  std::vector<VertexId> wall;
  for (const VertexId v : normals.ids()) wall.push_back(v);
  add_point_arrays(source, wall, {normals.begin(), normals.end()}, shown);
  add_ridges(
      source, [&](HalfedgeId h) { return source.topology.origin(h).index(); }, shown.file);
  return shown;
}

ShownNormals normals_of_runs(const NormalsSource& source, surface::Separation separation) {
  const auto runs =
      surface::patch_normals(source.mesh, source.topology, source.features, separation, source.options, source.groups);
  ShownNormals shown;
  shown.file = io::polydata_of(source.mesh);
  shown.file.points.clear();
  std::vector<VertexId> wall;
  for (const VertexId v : source.mesh.points.ids()) {
    wall.insert(wall.end(), runs.n_groups(v), v);
    shown.file.points.insert(shown.file.points.end(), runs.n_groups(v), source.mesh.points[v]);
  }
  for (std::size_t f = 0; f < shown.file.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      shown.file.triangles[f][k] = runs.group_of_corner[mesh::Topology::halfedge(FaceId(f), static_cast<int>(k))];
    }
  }
  add_point_arrays(source, wall, runs.normal, shown);
  add_ridges(
      source, [&](HalfedgeId h) { return runs.group_of_corner[h]; }, shown.file);
  return shown;
}

}  // namespace nearwall::program
