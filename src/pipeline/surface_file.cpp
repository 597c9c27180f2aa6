#include "pipeline/surface_file.h"

#include <algorithm>

#include "nearwall/certify/certificate.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/surface/patch_normals.h"

namespace nearwall::pipeline {

namespace {

using Doubles = std::vector<double>;
using Integers = std::vector<std::int32_t>;

template <class Ids, class Value>
auto values(const Ids& ids, Value&& value) {
  std::vector<decltype(value(*ids.begin()))> all;
  for (const auto id : ids) all.push_back(value(id));
  return all;
}

std::int32_t to_int(auto value) { return static_cast<std::int32_t>(value); }

/// Direction in which a vertex marches: that of its first line, or its normal where that line has none.
Vec3 direction_of(const layers::Growth& growth, VertexId v) {
  const LineId line(growth.front.first_line[v.index()]);
  const std::uint32_t begin = growth.lines.first_piece[line.index()];
  const std::uint32_t end = growth.lines.first_piece[line.index() + 1];
  const Vec3 d = begin < end ? normalized(growth.lines.pieces[begin].direction) : Vec3();
  return d == Vec3() ? growth.normals[v].direction : d;
}

double visibility_angle(const layers::Wall& wall, VertexId v, const Vec3& direction) {
  double worst = 0;
  for (const HalfedgeId h : wall.topology.fan(v)) {
    const Vec3& normal = wall.features.face_normal[mesh::Topology::face(h)];
    worst = std::max(worst, geometry::angle_between(direction, normal));
  }
  return geometry::to_degrees(worst);
}

void add_point_arrays(const layers::Wall& wall, const layers::Growth& growth, io::PolyDataFile& file) {
  const auto vertices = wall.surface.points.ids();
  const auto line = [&](VertexId v) { return LineId(growth.front.first_line[v.index()]); };
  Doubles normals, angles;
  for (const VertexId v : vertices) {
    const Vec3 d = direction_of(growth, v);
    normals.insert(normals.end(), {d.x(), d.y(), d.z()});
    angles.push_back(visibility_angle(wall, v, d));
  }
  file.point_data.push_back({"Normals", std::move(normals), 3});
  file.point_data.push_back({"VisibilityAngle", std::move(angles)});
  file.point_data.push_back({"PointKind", values(vertices, [&](VertexId v) { return to_int(wall.features.kind[v]); })});
  file.point_data.push_back({"LineCount", values(vertices, [&](VertexId v) {
                               return to_int(growth.front.first_line[v.index() + 1] -
                                             growth.front.first_line[v.index()]);
                             })});
  const auto offset = surface::group_offsets(wall.surface, wall.topology, wall.features, surface::Separation::Groups);
  file.point_data.push_back(
      {"Groups", values(vertices, [&](VertexId v) { return to_int(offset[VertexId(v.index() + 1)] - offset[v]); })});
  file.point_data.push_back({"Levels", values(vertices, [&](VertexId v) {
                               const mesh::Window window = growth.lines.windows[line(v)];
                               return to_int(window.moves() ? window.end : Level{0});
                             })});
  file.point_data.push_back(
      {"Thickness", values(vertices, [&](VertexId v) { return growth.reached_thickness[line(v)]; })});
  file.point_data.push_back(
      {"LimitReason", values(vertices, [&](VertexId v) { return to_int(growth.reason[line(v)]); })});
}

void add_ridges(const layers::Wall& wall, io::PolyDataFile& file) {
  Doubles turns;
  for (const HalfedgeId h : wall.features.is_ridge.ids()) {
    if (!wall.features.is_ridge[h] || wall.topology.twin(h) < h) continue;
    file.lines.push_back({wall.topology.origin(h).index(), wall.topology.target(h).index()});
    turns.push_back(geometry::to_degrees(wall.features.turn[h]));
  }
  file.line_data.push_back({"Turn", std::move(turns)});
}

}  // namespace

io::PolyDataFile surface_file(const layers::Wall& wall, const layers::Growth& growth,
                              const IdVector<FaceId, quality::FaceCoverage>& coverage,
                              const IdVector<FaceId, FaceId>& input_face) {
  io::PolyDataFile file = io::polydata_of(wall.surface);
  add_point_arrays(wall, growth, file);
  const auto faces = wall.surface.faces.ids();
  file.triangle_data.push_back({"Layers", values(faces, [&](FaceId f) { return to_int(coverage[f].layers); })});
  file.triangle_data.push_back({"LimitReason", values(faces, [&](FaceId f) { return to_int(coverage[f].reason); })});
  file.triangle_data.push_back({"FirstHeight", values(faces, [&](FaceId f) { return coverage[f].first_height; })});
  file.triangle_data.push_back({"Triangle", values(faces, [&](FaceId f) { return to_int(input_face[f].index()); })});
  add_ridges(wall, file);
  return file;
}

io::PolyDataFile front_file(const layers::Wall& wall, const layers::Growth& growth) {
  certify::FrontSurface front = certify::front_surface(growth.front, growth.lines);
  io::PolyDataFile file = io::polydata_of(wall.surface);
  file.points = std::move(front.points);
  file.triangles = std::move(front.triangles);
  const auto lines = growth.front.line_vertex.ids();
  file.point_data.push_back({"Levels", values(lines, [&](LineId l) {
                               const mesh::Window window = growth.lines.windows[l];
                               return to_int(window.moves() ? window.end : Level{0});
                             })});
  file.point_data.push_back({"Thickness", values(lines, [&](LineId l) { return growth.reached_thickness[l]; })});
  return file;
}

}  // namespace nearwall::pipeline
