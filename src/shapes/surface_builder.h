#pragma once

#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "nearwall/mesh/surface_mesh.h"
#include "shapes/planar_fill.h"

namespace nearwall::shapes {

/// Vertices along a curve, in order. Surfaces that meet at a curve share its row, so they share its points bit for bit.
using Row = std::vector<VertexId>;

Row reversed(Row row);
/// Rows one after the other; where one ends with the vertex the next begins with, it is taken once.
Row joined(const std::vector<Row>& rows);
/// The same, for rows that close: the last vertex, which is the first again, is left out.
Row loop_of(const std::vector<Row>& rows);

/// A map between a smooth face in space and a plane in which it is triangulated; the less it distorts lengths, the
/// better the triangles.
struct Chart {
  std::function<Point2(const Vec3&)> flatten;
  std::function<Vec3(const Point2&)> lift;
};

/// The plane through `origin`; lengths are kept. Coordinates that are constant over a face parallel to two axes stay so
/// exactly.
Chart plane_chart(const Vec3& origin, const Vec3& normal);

/// Collects points and triangles of a surface, patch by patch.
class SurfaceBuilder {
 public:
  VertexId add_point(const Vec3& p) { return mesh_.points.push_back(p); }
  const Vec3& point(VertexId v) const { return mesh_.points[v]; }
  /// The patch of this name, new if need be. Patches are numbered in the order in which they are first named.
  PatchId patch(std::string_view name);
  void add_triangle(PatchId patch, VertexId a, VertexId b, VertexId c);

  /// New vertices at the points.
  Row add_row(const std::vector<Vec3>& points);
  /// Straight row from a to b in pieces of about `size`; the same one (reversed if need be) whenever it is asked for.
  Row edge(VertexId a, VertexId b, double size);

  /// Triangles between two rows that run the same way, `left` lying to the left of `right` seen from outside. The rows
  /// may have different numbers of points, and may begin or end in the same vertex. Of the two triangles that could
  /// come next the one with the shorter new edge does.
  void stitch(PatchId patch, const Row& right, const Row& left);
  /// Two triangles between each two neighbours of rows with equally many points, cut along the shorter diagonal.
  void stitch_pairs(PatchId patch, const Row& right, const Row& left);
  /// `stitch` for closed rows, whose first vertex is not repeated; a row of one vertex is the tip of a cone.
  void stitch_rings(PatchId patch, const Row& right, const Row& left);
  /// Triangles of about `size` inside closed rows: the first runs round the face counterclockwise seen from outside,
  /// the others round holes in it. Edges of the rows are kept.
  void fill(PatchId patch, const std::vector<Row>& loops, const Chart& chart, double size);

  /// Adds the mirror image in the plane through the origin normal to `axis`. Points in the plane are shared.
  void mirror(int axis);

  /// Turns the normals of all triangles so far.
  void turn_over();

  /// Multiplies the coordinates of all points.
  void stretch(const Vec3& factors);

  /// The surface, without points that no triangle uses.
  mesh::SurfaceMesh finish();

 private:
  mesh::SurfaceMesh mesh_;
  std::map<std::pair<VertexId, VertexId>, Row> edges_;
};

}  // namespace nearwall::shapes
