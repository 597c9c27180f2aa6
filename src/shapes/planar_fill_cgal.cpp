#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "shapes/planar_fill.h"

namespace nearwall::shapes {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
struct FaceInfo {
  int depth = -1;  ///< number of constrained edges between the face and infinity; odd: inside
  bool is_inside() const { return depth % 2 == 1; }
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Face = Triangulation::Face_handle;
using Vertex = Triangulation::Vertex_handle;
using Point = Kernel::Point_2;

/// Largest circumradius that is left alone, over the size wanted there. An equilateral triangle has 0.577.
constexpr double kRadius = 0.72;
/// New points keep this distance from all others, and half of it from the boundary's edges, over the size wanted there.
constexpr double kSeparation = 0.65;
/// Size may grow by this much per unit of distance from the boundary.
constexpr double kGrowth = 0.25;
/// Edges of the boundary that are not much shorter than the size, by this factor, do not make triangles inside smaller.
constexpr double kShort = 0.77;
constexpr int kSmoothingRounds = 12;

double distance(const Point& a, const Point& b) { return std::sqrt(CGAL::squared_distance(a, b)); }

/// The edge length wanted at each place.
class SizeField {
 public:
  SizeField(const std::vector<std::vector<Point2>>& loops, double size) {
    double longest = 0;
    for (const auto& loop : loops) {
      const std::size_t n = loop.size();
      for (std::size_t i = 0; i < n; ++i) {
        const Point p(loop[i].u, loop[i].v);
        const Point q(loop[(i + 1) % n].u, loop[(i + 1) % n].v);
        short_edges_.push_back({CGAL::midpoint(p, q), distance(p, q)});
        longest = std::max(longest, short_edges_.back().length);
      }
    }
    // Triangles inside are no finer than the boundary asks for, and no coarser than asked.
    size_ = std::min(size, longest);
    std::erase_if(short_edges_, [this](const Edge& e) { return e.length > kShort * size_; });
    std::stable_sort(short_edges_.begin(), short_edges_.end(),
                     [](const Edge& a, const Edge& b) { return a.length < b.length; });
  }

  double operator()(const Point& p) const {
    double result = size_;
    for (const Edge& edge : short_edges_) {
      if (edge.length >= result) break;
      result = std::min(result, edge.length + kGrowth * distance(p, edge.middle));
    }
    return result;
  }

 private:
  struct Edge {
    Point middle;
    double length;
  };
  std::vector<Edge> short_edges_;  // shortest first
  double size_ = 0;
};

void mark_inside(Triangulation& t) {
  for (const Face f : t.all_face_handles()) f->info().depth = -1;
  std::deque<Face> queue{t.infinite_face()};
  t.infinite_face()->info().depth = 0;
  while (!queue.empty()) {
    const Face f = queue.front();
    queue.pop_front();
    for (int i = 0; i < 3; ++i) {
      const Face g = f->neighbor(i);
      if (g->info().depth >= 0) continue;
      const bool crosses = f->is_constrained(i);
      g->info().depth = f->info().depth + (crosses ? 1 : 0);
      // Faces beyond a constraint wait until all of this depth are done.
      if (crosses) {
        queue.push_back(g);
      } else {
        queue.push_front(g);
      }
    }
  }
}

Triangulation triangulate(const std::vector<std::vector<Point2>>& loops, const std::vector<Point>& interior) {
  Triangulation t;
  std::uint32_t next = 0;
  for (const auto& loop : loops) {
    std::vector<Vertex> corners;
    for (const Point2& p : loop) {
      corners.push_back(t.insert(Point(p.u, p.v), corners.empty() ? Face() : corners.back()->face()));
      corners.back()->info() = next++;
    }
    for (std::size_t i = 0; i < corners.size(); ++i) t.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
  }
  Face hint;
  for (const Point& p : interior) {
    const Vertex v = t.insert(p, hint);
    v->info() = next++;
    hint = v->face();
  }
  mark_inside(t);
  return t;
}

/// True if p is far enough from all vertices and boundary edges that it would be connected to.
bool has_room(const Triangulation& t, const Point& p, double size, Face located) {
  std::vector<Face> conflicts;
  t.get_conflicts(p, std::back_inserter(conflicts), located);
  for (const Face f : conflicts) {
    for (int i = 0; i < 3; ++i) {
      if (distance(f->vertex(i)->point(), p) < kSeparation * size) return false;
      if (!f->is_constrained(i)) continue;
      const Kernel::Segment_2 edge(f->vertex((i + 1) % 3)->point(), f->vertex((i + 2) % 3)->point());
      const double room = 0.5 * kSeparation * std::min(size, std::sqrt(edge.squared_length()));
      if (CGAL::squared_distance(edge, p) < room * room) return false;
    }
  }
  return true;
}

/// One round of refinement: the circumcentres of triangles too large, the worst first. \returns whether any was added
bool refine_once(Triangulation& t, const SizeField& size, std::vector<Point>& interior) {
  std::vector<std::pair<double, Point>> candidates;
  for (const Face f : t.finite_face_handles()) {
    if (!f->info().is_inside()) continue;
    const Point c = t.circumcenter(f);
    const double excess = distance(c, f->vertex(0)->point()) / size(c);
    if (excess > kRadius) candidates.push_back({excess, c});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });

  bool added = false;
  Face hint;
  for (const auto& [excess, c] : candidates) {
    Triangulation::Locate_type type;
    int index = 0;
    const Face f = t.locate(c, type, index, hint);
    hint = f;
    if (type != Triangulation::FACE && type != Triangulation::EDGE) continue;
    if (!f->info().is_inside() || (type == Triangulation::EDGE && f->is_constrained(index))) continue;
    if (!has_room(t, c, size(c), f)) continue;
    const Vertex v = t.insert(c, type, f, index);
    hint = v->face();
    auto around = t.incident_faces(v), first = around;
    do {
      around->info().depth = 1;
    } while (++around != first);
    interior.push_back(c);
    added = true;
  }
  return added;
}

/// Moves a vertex to the mean of the centroids of its triangles, weighted so that sizes are kept, unless one of them
/// would turn over.
void smooth_vertex(Triangulation& t, Vertex v, const SizeField& size) {
  double weight = 0, u = 0, w = 0;
  std::vector<std::pair<Point, Point>> links;
  auto f = t.incident_faces(v), first = f;
  do {
    const int i = f->index(v);
    const Point a = f->vertex((i + 1) % 3)->point(), b = f->vertex((i + 2) % 3)->point();
    const Point centre = CGAL::centroid(v->point(), a, b);
    const double s = size(centre);
    const double share = CGAL::area(v->point(), a, b) / (s * s * s * s);
    weight += share, u += share * centre.x(), w += share * centre.y();
    links.push_back({a, b});
  } while (++f != first);
  const Point moved(u / weight, w / weight);
  for (const auto& [a, b] : links) {
    if (CGAL::orientation(moved, a, b) != CGAL::LEFT_TURN) return;
  }
  v->set_point(moved);
}

void smooth(const std::vector<std::vector<Point2>>& loops, const SizeField& size, std::vector<Point>& interior) {
  std::size_t n_boundary = 0;
  for (const auto& loop : loops) n_boundary += loop.size();
  for (int round = 0; round < kSmoothingRounds; ++round) {
    Triangulation t = triangulate(loops, interior);
    std::vector<Vertex> vertices(interior.size());
    for (const Vertex v : t.finite_vertex_handles()) {
      if (v->info() >= n_boundary) vertices[v->info() - n_boundary] = v;
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      smooth_vertex(t, vertices[i], size);
      interior[i] = vertices[i]->point();
    }
  }
}

}  // namespace

PlanarFill fill_region(const std::vector<std::vector<Point2>>& loops, double size) {
  const SizeField field(loops, size);
  std::vector<Point> interior;
  Triangulation t = triangulate(loops, interior);
  while (refine_once(t, field, interior)) {
  }
  smooth(loops, field, interior);

  PlanarFill result;
  for (const Point& p : interior) result.interior.push_back({p.x(), p.y()});
  const Triangulation final = triangulate(loops, interior);
  for (const Face f : final.finite_face_handles()) {
    if (!f->info().is_inside()) continue;
    result.triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  }
  return result;
}

}  // namespace nearwall::shapes
