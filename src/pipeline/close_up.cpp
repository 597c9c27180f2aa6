#include "pipeline/close_up.h"

#include <algorithm>
#include <cmath>

#include "nearwall/geometry/box.h"
#include "nearwall/io/vtu_writer.h"
#include "nearwall/mesh/front_part.h"
#include "nearwall/mesh/mesh_source.h"

namespace nearwall::pipeline {

namespace {

/// Half the height of the picture over the thickness of the layers, and its width over its height.
constexpr double kHalfHeight = 0.85;
constexpr double kAspect = 1.6;
/// Share of the asked thickness from which a place is worth a picture.
constexpr double kWorthShowing = 0.9;

LineId line_of(const layers::Growth& growth, VertexId v) { return growth.front.line_of(v); }

double thickness(const layers::Growth& growth, VertexId v) { return growth.reached_thickness[line_of(growth, v)]; }

bool is_worth_showing(const layers::Growth& growth, VertexId v) {
  const LineId line = line_of(growth, v);
  return growth.asked_thickness[line] > 0 &&
         growth.reached_thickness[line] >= kWorthShowing * growth.asked_thickness[line];
}

/// The ridge halfedge with the largest turn of which both ends have their layers; invalid if there is none.
HalfedgeId sharpest_ridge(const layers::Wall& wall, const layers::Growth& growth) {
  HalfedgeId best;
  double largest = 0;
  for (const HalfedgeId h : wall.features.is_ridge.ids()) {
    if (!wall.features.is_ridge[h] || !(wall.features.turn[h] > largest)) continue;
    if (!is_worth_showing(growth, wall.topology.origin(h)) || !is_worth_showing(growth, wall.topology.target(h)))
      continue;
    largest = wall.features.turn[h];
    best = h;
  }
  return best;
}

VertexId thickest(const layers::Wall& wall, const layers::Growth& growth) {
  VertexId best;
  double largest = 0;
  for (const VertexId v : wall.surface.points.ids()) {
    if (thickness(growth, v) > largest) largest = thickness(growth, v), best = v;
  }
  return best;
}

io::ZoomBox box_about(const Vec3& centre, double half) {
  const Vec3 extent(half, half, half);
  return {centre - extent, centre + extent};
}

/// Front and lines over some of the faces only.
struct Columns {
  mesh::SurfaceMesh wall;
  mesh::Front front;
  mesh::Lines lines;
};

Columns columns_over(const layers::Wall& wall, const layers::Growth& growth, const std::vector<FaceId>& faces) {
  mesh::FrontPart part(growth.front);
  for (const FaceId f : faces) part.add(FrontFaceId(f.index()));
  for (std::size_t i = growth.front.n_wall_faces; i < growth.front.faces.size(); ++i) {
    if (part.has_vertices_of(FrontFaceId(i))) part.add(FrontFaceId(i));
  }
  Columns c;
  c.front = part.front();
  c.lines.table = growth.lines.table;
  c.lines.first_piece.push_back(0);
  for (const LineId line : part.original_line()) {
    for (std::uint32_t i = growth.lines.first_piece[line.index()]; i < growth.lines.first_piece[line.index() + 1];
         ++i) {
      c.lines.pieces.push_back(growth.lines.pieces[i]);
    }
    c.lines.first_piece.push_back(static_cast<std::uint32_t>(c.lines.pieces.size()));
    c.lines.base.push_back(growth.lines.base[line]);
    c.lines.heights.push_back(growth.lines.heights[line]);
    c.lines.windows.push_back(growth.lines.windows[line]);
  }
  c.wall.patch_names = wall.surface.patch_names;
  for (std::size_t v = 0; v + 1 < c.front.first_line.size(); ++v) {
    c.wall.points.push_back(wall.surface.points[part.original_vertex(VertexId(v))]);
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto& lines = c.front.faces[FrontFaceId(i)].lines;
    c.wall.faces.push_back(
        {c.front.line_vertex[lines[0]], c.front.line_vertex[lines[1]], c.front.line_vertex[lines[2]]});
    c.wall.face_patch.push_back(wall.surface.face_patch[faces[i]]);
  }
  return c;
}

}  // namespace

std::optional<CloseUp> choose_close_up(const layers::Wall& wall, const layers::Growth& growth) {
  const HalfedgeId ridge = sharpest_ridge(wall, growth);
  const VertexId vertex = ridge.is_valid() ? wall.topology.origin(ridge) : thickest(wall, growth);
  if (!vertex.is_valid()) return std::nullopt;
  const LineId line = line_of(growth, vertex);
  const Vec3 base = growth.lines.base[line];
  const Vec3 top = growth.lines.position(line, growth.lines.windows[line].end);

  CloseUp place;
  place.vertex = vertex;
  // Across the ridge, a little beside the vertex: a plane through it would cut along the faces of its cells.
  const HalfedgeId edge = ridge.is_valid() ? ridge : wall.topology.fan(vertex).front();
  const Vec3 along = wall.topology.target(edge) == vertex ? base - wall.surface.points[wall.topology.origin(edge)]
                                                          : wall.surface.points[wall.topology.target(edge)] - base;
  const double half = kHalfHeight * distance(base, top);
  const double aside = std::min(0.25 * norm(along), half);
  const Vec3 step = normalized(along) * aside;
  place.plane = {along, base + step};
  place.zoom = box_about(base + step + (top - base) * 0.5, half);
  return place;
}

void write_columns_near(const layers::Wall& wall, const layers::Growth& growth, const CloseUp& place,
                        const std::filesystem::path& path) {
  const Vec3 centre = (place.zoom.low + place.zoom.high) * 0.5;
  const double half = 0.5 * max_norm(place.zoom.high - place.zoom.low);
  const io::ZoomBox seen = box_about(centre, 2 * kAspect * half);
  geometry::Box box;
  box.include(seen.low);
  box.include(seen.high);
  std::vector<FaceId> faces;
  for (const FaceId f : wall.surface.faces.ids()) {
    const auto corners = wall.surface.triangle(f);
    const auto& v = wall.surface.faces[f];
    const bool is_near =
        geometry::bounding_box(corners).intersects(box) || std::find(v.begin(), v.end(), place.vertex) != v.end();
    if (is_near) faces.push_back(f);
  }
  const Columns columns = columns_over(wall, growth, faces);
  const mesh::LayerMesh layers(columns.front, columns.lines);
  const mesh::LayerSource source(layers, columns.wall.face_patch, columns.wall.points.raw());
  io::write_vtu(path, source, {}, {columns.wall.patch_names.raw()});
}

}  // namespace nearwall::pipeline
