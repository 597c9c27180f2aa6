#include "studies/height_field.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "nearwall/geometry/measures.h"
#include "studies/random.h"
#include "studies/test_functions.h"

namespace nearwall::studies {

namespace {

mesh::SurfaceMesh lifted(const HeightField& field, const std::vector<Triangle2>& triangles) {
  mesh::SurfaceMesh mesh;
  for (std::size_t i = 0; i < field.points.size(); ++i) {
    mesh.points.push_back({field.points[i].x, field.points[i].y, field.truth[i].value});
  }
  for (const Triangle2& t : triangles) {
    mesh.faces.push_back({VertexId(t[0]), VertexId(t[1]), VertexId(t[2])});
    mesh.face_patch.push_back(PatchId(0));
  }
  mesh.patch_names.push_back("graph");
  return mesh;
}

double area(const HeightField& field, const Triangle2& t) {
  const Point2 &a = field.points[t[0]], &b = field.points[t[1]], &c = field.points[t[2]];
  return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// Takes thin triangles away from the boundary inwards.
class Trimming {
 public:
  Trimming(const std::vector<Point2>& points, const std::vector<Triangle2>& triangles)
      : points_(points), triangles_(triangles), is_gone_(triangles.size(), 0), is_on_boundary_(points.size(), 0) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) left_of_[edge(i, k)] = i;
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (!is_open(i, k)) continue;
        for (const std::uint32_t v : {edge(i, k).first, edge(i, k).second}) is_on_boundary_[v] = 1;
      }
    }
  }

  std::vector<Triangle2> run(double widest) {
    std::vector<std::size_t> waiting(triangles_.size());
    for (std::size_t i = 0; i < waiting.size(); ++i) waiting[i] = i;
    while (!waiting.empty()) {
      const std::size_t i = waiting.back();
      waiting.pop_back();
      if (is_gone_[i] || !may_go(i) || widest_corner(i) <= widest) continue;
      is_gone_[i] = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        is_on_boundary_[triangles_[i][k]] = 1;
        if (!is_open(i, k)) waiting.push_back(left_of_.at(reversed(edge(i, k))));
      }
    }
    std::vector<Triangle2> left;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      if (!is_gone_[i]) left.push_back(triangles_[i]);
    }
    return left;
  }

 private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  Edge edge(std::size_t i, std::size_t k) const { return {triangles_[i][k], triangles_[i][(k + 1) % 3]}; }
  static Edge reversed(const Edge& e) { return {e.second, e.first}; }

  bool is_open(std::size_t i, std::size_t k) const {
    const auto other = left_of_.find(reversed(edge(i, k)));
    return other == left_of_.end() || is_gone_[other->second];
  }

  /// Just one side on the boundary, and the corner opposite to it not: with more, the boundary would touch itself.
  bool may_go(std::size_t i) const {
    std::size_t n_open = 0, opposite = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (is_open(i, k)) ++n_open, opposite = (k + 2) % 3;
    }
    return n_open == 1 && !is_on_boundary_[triangles_[i][opposite]];
  }

  double widest_corner(std::size_t i) const {
    std::array<Vec3, 3> t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = {points_[triangles_[i][k]].x, points_[triangles_[i][k]].y, 0};
    return geometry::widest_corner(t[0], t[1], t[2]);
  }

  const std::vector<Point2>& points_;
  const std::vector<Triangle2>& triangles_;
  std::map<Edge, std::size_t> left_of_;
  std::vector<char> is_gone_, is_on_boundary_;
};

/// A random stream for each kind of use, function and number of points.
RandomStream stream_of(std::uint64_t seed, std::uint64_t use, std::uint64_t function, std::uint64_t n_points) {
  return RandomStream(seed, (use << 56) + (function << 48) + n_points);
}

}  // namespace

HeightField height_field(int function, std::size_t n_points, std::uint64_t seed) {
  RandomStream random = stream_of(seed, 0, static_cast<std::uint64_t>(function), n_points);
  HeightField field;
  for (std::size_t i = 0; i < n_points; ++i) {
    const double x = random.uniform(), y = random.uniform();
    field.points.push_back({x, y});
    field.truth.push_back(test_function(function, x, y));
  }
  field.triangles = delaunay(field.points);
  return field;
}

std::vector<Triangle2> without_thin_boundary(const std::vector<Point2>& points, const std::vector<Triangle2>& triangles,
                                             double widest) {
  return Trimming(points, triangles).run(widest);
}

Graph::Graph(const HeightField& field, const std::vector<Triangle2>& triangles)
    : mesh(lifted(field, triangles)), topology(mesh), features(surface::find_features(mesh, topology)) {}

std::vector<Place> random_places(const HeightField& field, std::size_t n, std::uint64_t seed) {
  RandomStream random = stream_of(seed, 1, 0, field.points.size());
  std::vector<double> area_up_to;
  double sum = 0;
  for (const Triangle2& t : field.triangles) area_up_to.push_back(sum += area(field, t));
  std::vector<Place> places;
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = std::upper_bound(area_up_to.begin(), area_up_to.end() - 1, sum * random.uniform());
    const auto triangle = static_cast<std::size_t>(at - area_up_to.begin());
    const auto& t = field.triangles[triangle];
    const Point2 &a = field.points[t[0]], &b = field.points[t[1]], &c = field.points[t[2]];
    // Uniform in the parallelogram; the far half is folded back.
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    places.push_back({triangle, {a.x + u * (b.x - a.x) + v * (c.x - a.x), a.y + u * (b.y - a.y) + v * (c.y - a.y)}});
  }
  return places;
}

}  // namespace nearwall::studies
