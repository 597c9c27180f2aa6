#include "pipeline/surface_file.h"

#include <algorithm>
#include <limits>

#include "nearwall/certify/certificate.h"
#include "nearwall/geometry/angles.h"

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

/// Direction in which a line marches, or the normal of its vertex where it has none.
Vec3 direction_of(const layers::Growth& growth, LineId line) {
  const std::uint32_t begin = growth.lines.first_piece[line.index()];
  const std::uint32_t end = growth.lines.first_piece[line.index() + 1];
  const Vec3 d = begin < end ? normalized(growth.lines.pieces[begin].direction) : Vec3();
  return d == Vec3() ? growth.normals[growth.front.line_vertex[line]].direction : d;
}

/// Angle between the line of a corner and the normal of its face, the largest of each vertex [deg].
Doubles visibility_angles(const layers::Wall& wall, const layers::Growth& growth) {
  Doubles worst(wall.surface.points.size(), 0);
  for (const FaceId f : wall.surface.faces.ids()) {
    for (std::size_t k = 0; k < 3; ++k) {
      const LineId line = growth.front.faces[FrontFaceId(f.index())].lines[k];
      const VertexId v = wall.surface.faces[f][k];
      const Vec3 d = direction_of(growth, line);
      worst[v.index()] = std::max(worst[v.index()], geometry::angle_between(d, wall.features.face_normal[f]));
    }
  }
  for (double& angle : worst) angle = geometry::to_degrees(angle);
  return worst;
}

/// Lines of each vertex that march from faces: one for each group of faces round it.
Integers group_counts(const layers::Wall& wall, const layers::Growth& growth) {
  std::vector<char> is_of_faces(growth.front.n_lines(), 0);
  for (std::size_t f = 0; f < growth.front.n_wall_faces; ++f) {
    for (std::size_t k = 0; k < 3; ++k) is_of_faces[growth.front.faces[FrontFaceId(f)].lines[k].index()] = 1;
  }
  Integers counts(wall.surface.points.size(), 0);
  for (const LineId line : growth.front.line_vertex.ids()) {
    counts[growth.front.line_vertex[line].index()] += is_of_faces[line.index()];
  }
  return counts;
}

void add_point_arrays(const layers::Wall& wall, const layers::Growth& growth, io::PolyDataFile& file) {
  const auto vertices = wall.surface.points.ids();
  const auto line = [&](VertexId v) { return growth.front.line_of(v); };
  Doubles normals;
  for (const VertexId v : vertices) {
    const Vec3 d = direction_of(growth, line(v));
    normals.insert(normals.end(), {d.x(), d.y(), d.z()});
  }
  file.point_data.push_back({"Normals", std::move(normals), 3});
  file.point_data.push_back({"VisibilityAngle", visibility_angles(wall, growth)});
  file.point_data.push_back({"PointKind", values(vertices, [&](VertexId v) { return to_int(wall.features.kind[v]); })});
  file.point_data.push_back(
      {"LineCount", values(vertices, [&](VertexId v) { return to_int(growth.front.n_lines(v)); })});
  file.point_data.push_back({"Groups", group_counts(wall, growth)});
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

/// The tuples that are kept, of an array of any type.
void keep(io::DataArray& array, const std::vector<char>& is_kept) {
  std::visit(
      [&](auto& values) {
        const auto n = static_cast<std::size_t>(array.components);
        std::size_t to = 0;
        for (std::size_t i = 0; i < is_kept.size(); ++i) {
          for (std::size_t c = 0; is_kept[i] && c < n; ++c) values[to++] = values[n * i + c];
        }
        values.resize(to);
      },
      array.values);
}

template <std::size_t N>
void keep(std::vector<std::array<std::uint32_t, N>>& cells, std::vector<io::DataArray>& data,
          const std::vector<char>& is_kept, const std::vector<std::uint32_t>& number) {
  std::size_t to = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!is_kept[i]) continue;
    for (std::size_t k = 0; k < N; ++k) cells[to][k] = number[cells[i][k]];
    ++to;
  }
  cells.resize(to);
  for (io::DataArray& array : data) keep(array, is_kept);
}

/// Drops triangles, the points that nothing has then, and the lines between such points.
void keep_triangles(const std::vector<char>& is_kept, io::PolyDataFile& file) {
  std::vector<char> has_point(file.points.size(), 0), has_line;
  for (std::size_t t = 0; t < is_kept.size(); ++t) {
    for (const std::uint32_t p : file.triangles[t]) has_point[p] |= is_kept[t];
  }
  for (const auto& [a, b] : file.lines) has_line.push_back(has_point[a] && has_point[b] ? 1 : 0);
  std::vector<std::uint32_t> number(file.points.size(), 0);
  std::uint32_t n = 0;
  for (std::size_t p = 0; p < number.size(); ++p) {
    if (!has_point[p]) continue;
    file.points[n] = file.points[p];
    number[p] = n++;
  }
  file.points.resize(n);
  keep(file.triangles, file.triangle_data, is_kept, number);
  keep(file.lines, file.line_data, has_line, number);
  for (io::DataArray& array : file.point_data) keep(array, has_point);
}

}  // namespace

io::PolyDataFile surface_file(const layers::Wall& wall, const layers::Growth& growth,
                              const IdVector<FaceId, quality::FaceCoverage>& coverage,
                              const IdVector<FaceId, FaceId>& input_face, const IdVector<FaceId, char>& is_shown) {
  io::PolyDataFile file = io::polydata_of(wall.surface);
  add_point_arrays(wall, growth, file);
  const auto faces = wall.surface.faces.ids();
  file.triangle_data.push_back({"Layers", values(faces, [&](FaceId f) { return to_int(coverage[f].layers); })});
  file.triangle_data.push_back({"LimitReason", values(faces, [&](FaceId f) { return to_int(coverage[f].reason); })});
  file.triangle_data.push_back({"FirstHeight", values(faces, [&](FaceId f) { return coverage[f].first_height; })});
  file.triangle_data.push_back({"Triangle", values(faces, [&](FaceId f) {
                                  return input_face[f].is_valid() ? to_int(input_face[f].index()) : std::int32_t{-1};
                                })});
  add_ridges(wall, file);
  if (!is_shown.empty()) keep_triangles(is_shown.raw(), file);
  return file;
}

io::PolyDataFile front_file(const layers::Wall& wall, const layers::Growth& growth,
                            const IdVector<FaceId, char>& is_shown) {
  const mesh::Front& front = growth.front;
  certify::FrontSurface surface = certify::front_surface(front, growth.lines);
  io::PolyDataFile file;
  file.points = std::move(surface.points);
  file.triangles = std::move(surface.triangles);
  // What stands over a virtual face counts to the patch of the first triangle round its vertex.
  const auto wall_face = [&](FrontFaceId f) {
    if (front.is_wall(f)) return FaceId(f.index());
    return mesh::Topology::face(wall.topology.fan(front.line_vertex[front.faces[f].lines[0]]).front());
  };
  file.triangle_data.push_back({"Patch", values(surface.face, [&](FrontFaceId f) {
                                  return to_int(wall.surface.face_patch[wall_face(f)].index());
                                })});
  file.triangle_data.push_back({"Column", values(surface.face, [&](FrontFaceId f) {
                                  return front.is_wall(f) ? to_int(f.index()) : std::int32_t{-1};
                                })});
  file.field_data.push_back({"PatchNames", wall.surface.patch_names.raw()});
  Integers levels;
  Doubles thickness;
  for (const LineId line : front.line_vertex.ids()) {
    const mesh::Window window = growth.lines.windows[line];
    levels.push_back(window.moves() ? window.end : Level{0});
    thickness.push_back(growth.reached_thickness[line]);
  }
  // The apices of caps lie on no line.
  levels.resize(file.points.size(), -1);
  thickness.resize(file.points.size(), std::numeric_limits<double>::quiet_NaN());
  file.point_data.push_back({"Levels", std::move(levels)});
  file.point_data.push_back({"Thickness", std::move(thickness)});
  if (is_shown.empty()) return file;
  std::vector<char> is_kept;
  for (const FrontFaceId f : surface.face) is_kept.push_back(is_shown[wall_face(f)]);
  keep_triangles(is_kept, file);
  return file;
}

}  // namespace nearwall::pipeline
