#include "shapes/surface_builder.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "nearwall/core/expect.h"
#include "shapes/sampling.h"

namespace nearwall::shapes {

Row reversed(Row row) {
  std::reverse(row.begin(), row.end());
  return row;
}

Row joined(const std::vector<Row>& rows) {
  Row all;
  for (const Row& row : rows) {
    const bool repeats = !all.empty() && !row.empty() && all.back() == row.front();
    all.insert(all.end(), row.begin() + (repeats ? 1 : 0), row.end());
  }
  return all;
}

Row loop_of(const std::vector<Row>& rows) {
  Row all = joined(rows);
  if (all.size() > 1 && all.front() == all.back()) all.pop_back();
  return all;
}

Chart plane_chart(const Vec3& origin, const Vec3& normal) {
  int main = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(normal[axis]) > std::abs(normal[main])) main = axis;
  }
  Vec3 helper;
  helper[(main + 1) % 3] = 1;
  const Vec3 n = normalized(normal);
  const Vec3 u = normalized(helper - n * dot(helper, n));
  const Vec3 v = cross(n, u);
  return {[=](const Vec3& p) {
            return Point2{dot(p - origin, u), dot(p - origin, v)};
          },
          [=](const Point2& q) { return origin + (u * q.u + v * q.v); }};
}

PatchId SurfaceBuilder::patch(std::string_view name) {
  for (const PatchId p : mesh_.patch_names.ids()) {
    if (mesh_.patch_names[p] == name) return p;
  }
  return mesh_.patch_names.push_back(std::string(name));
}

void SurfaceBuilder::add_triangle(PatchId patch, VertexId a, VertexId b, VertexId c) {
  mesh_.faces.push_back({a, b, c});
  mesh_.face_patch.push_back(patch);
}

Row SurfaceBuilder::add_row(const std::vector<Vec3>& points) {
  Row row;
  row.reserve(points.size());
  for (const Vec3& p : points) row.push_back(add_point(p));
  return row;
}

Row SurfaceBuilder::edge(VertexId a, VertexId b, double size) {
  if (b < a) return reversed(edge(b, a, size));
  const auto [at, is_new] = edges_.try_emplace({a, b});
  if (is_new) {
    const Vec3 from = point(a), to = point(b);
    const int n = n_segments(distance(from, to), size);
    at->second.push_back(a);
    for (int i = 1; i < n; ++i) at->second.push_back(add_point(from + (to - from) * (static_cast<double>(i) / n)));
    at->second.push_back(b);
  }
  return at->second;
}

void SurfaceBuilder::stitch(PatchId patch, const Row& right, const Row& left) {
  std::size_t i = 0, j = 0;
  while (i + 1 < right.size() || j + 1 < left.size()) {
    const bool right_ends = i + 1 == right.size();
    const bool left_ends = j + 1 == left.size();
    const bool advance_right = !right_ends && (left_ends || squared_norm(point(right[i + 1]) - point(left[j])) <=
                                                                squared_norm(point(left[j + 1]) - point(right[i])));
    if (advance_right) {
      if (right[i + 1] != left[j] && right[i] != left[j]) add_triangle(patch, right[i], right[i + 1], left[j]);
      ++i;
    } else {
      if (left[j + 1] != right[i] && left[j] != right[i]) add_triangle(patch, right[i], left[j + 1], left[j]);
      ++j;
    }
  }
}

void SurfaceBuilder::stitch_pairs(PatchId patch, const Row& right, const Row& left) {
  expect(right.size() == left.size(), "rows of quadrangles have equally many points");
  for (std::size_t i = 0; i + 1 < right.size(); ++i) stitch(patch, {right[i], right[i + 1]}, {left[i], left[i + 1]});
}

void SurfaceBuilder::stitch_rings(PatchId patch, const Row& right, const Row& left) {
  const auto closed = [](Row ring) {
    if (ring.size() > 1) ring.push_back(ring.front());
    return ring;
  };
  stitch(patch, closed(right), closed(left));
}

void SurfaceBuilder::fill(PatchId patch, const std::vector<Row>& loops, const Chart& chart, double size) {
  std::vector<std::vector<Point2>> flat;
  Row nodes;
  double doubled_area = 0;
  for (const Row& loop : loops) {
    std::vector<Point2>& polygon = flat.emplace_back();
    for (const VertexId v : loop) polygon.push_back(chart.flatten(point(v)));
    nodes.insert(nodes.end(), loop.begin(), loop.end());
  }
  const std::vector<Point2>& outer = flat.front();
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const Point2 p = outer[i], q = outer[(i + 1) % outer.size()];
    doubled_area += p.u * q.v - q.u * p.v;
  }
  const PlanarFill filled = fill_region(flat, size);
  for (const Point2& q : filled.interior) nodes.push_back(add_point(chart.lift(q)));
  for (const auto& [a, b, c] : filled.triangles) {
    if (doubled_area > 0) {
      add_triangle(patch, nodes[a], nodes[b], nodes[c]);
    } else {
      add_triangle(patch, nodes[a], nodes[c], nodes[b]);
    }
  }
}

void SurfaceBuilder::mirror(int axis) {
  IdVector<VertexId, VertexId> image(mesh_.points.size());
  for (const VertexId v : image.ids()) {
    Vec3 p = point(v);
    image[v] = v;
    if (p[axis] == 0) continue;
    p[axis] = -p[axis];
    image[v] = add_point(p);
  }
  const std::size_t n = mesh_.faces.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto [a, b, c] = mesh_.faces[FaceId(i)];
    add_triangle(mesh_.face_patch[FaceId(i)], image[a], image[c], image[b]);
  }
}

void SurfaceBuilder::turn_over() {
  for (auto& [a, b, c] : mesh_.faces) std::swap(b, c);
}

void SurfaceBuilder::stretch(const Vec3& factors) {
  for (Vec3& p : mesh_.points) p = {p.x() * factors.x(), p.y() * factors.y(), p.z() * factors.z()};
}

mesh::SurfaceMesh SurfaceBuilder::finish() {
  IdVector<VertexId, VertexId> renumbered(mesh_.points.size());
  mesh::SurfaceMesh result;
  result.face_patch = mesh_.face_patch;
  result.patch_names = mesh_.patch_names;
  result.faces = mesh_.faces;
  for (auto& corners : result.faces) {
    for (VertexId& v : corners) {
      expect(v.is_valid(), "a triangle of a shape has three vertices");
      if (!renumbered[v].is_valid()) renumbered[v] = result.points.push_back(point(v));
      v = renumbered[v];
    }
  }
  return result;
}

}  // namespace nearwall::shapes
