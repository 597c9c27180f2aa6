#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/planar/region.h"
#include "planar/constrained_cgal.h"

namespace nearwall::planar {
namespace {

using Face = ConstrainedDelaunay::Face_handle;
using Vertex = ConstrainedDelaunay::Vertex_handle;
using Point = Kernel::Point_2;

/// Largest circumradius that is left alone, over the size wanted there. An equilateral triangle has 0.577.
constexpr double kRadius = 0.72;
/// New points keep this distance from all others, and half of it from the edges given, over the size wanted there.
constexpr double kSeparation = 0.65;
/// More than these make angles no better (square of 120,000 triangles: 1 % are below 37.2 degrees, after 12
/// rounds 37.3).
constexpr int kSmoothingRounds = 4;
/// Four times the square root of three: makes the shape of an equilateral triangle 1.
const double kEquilateral = 4 * std::sqrt(3.0);
/// Shapes that smoothing may make of better ones: an isosceles triangle of this shape has angles of 43 degrees.
constexpr double kGoodShape = 0.85;

double distance(const Point& a, const Point& b) { return std::sqrt(CGAL::squared_distance(a, b)); }

class Refinement {
 public:
  Refinement(ConstrainedDelaunay& triangulation, std::uint32_t n_given, const SizeFunction& size)
      : t_(triangulation), n_given_(n_given), size_(size) {}

  void refine() {
    while (refine_once()) {
    }
  }
  void smooth();
  const std::vector<Vertex>& added() const { return added_; }

 private:
  struct Candidate {
    double excess;
    double size;
    Point place;
    Vertex near;
  };

  double size_at(const Point& p) const;
  bool refine_once();
  std::vector<Candidate> candidates();
  bool has_room_beside(const Candidate& c, Face f) const;
  bool has_room(const Candidate& c, Face located);
  bool insert(const Candidate& c);
  double worst_shape(const Point& p) const;
  void smooth_vertex(Vertex v);
  void restore_delaunay();

  ConstrainedDelaunay& t_;
  std::uint32_t n_given_;
  const SizeFunction& size_;
  std::vector<Vertex> added_;
  std::vector<std::pair<Face, Face>> conflicts_;  // kept for their memory
  std::vector<std::pair<Point, Point>> links_;    // the same
};

double Refinement::size_at(const Point& p) const {
  const double size = size_({p.x(), p.y()});
  if (!(size > 0 && std::isfinite(size))) {
    throw InputError(
        fmt::format("refinement of a region: expected positive sizes, found {} at ({}, {})", size, p.x(), p.y()));
  }
  return size;
}

/// Circumcentres of the faces that are too large, the worst first. Each face is looked at once: what is refused has no
/// room for a point, and never will.
std::vector<Refinement::Candidate> Refinement::candidates() {
  std::vector<Candidate> result;
  for (const Face f : t_.finite_face_handles()) {
    if (!f->info().is_inside || f->info().is_settled) continue;
    f->info().is_settled = true;
    const Point c = t_.circumcenter(f);
    // Triangles without height to rounding have none.
    if (!std::isfinite(c.x()) || !std::isfinite(c.y())) continue;
    const double size = size_at(c), excess = distance(c, f->vertex(0)->point()) / size;
    if (excess > kRadius) result.push_back({excess, size, c, f->vertex(0)});
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Candidate& a, const Candidate& b) { return a.excess > b.excess; });
  return result;
}

bool Refinement::has_room_beside(const Candidate& c, Face f) const {
  for (int i = 0; i < 3; ++i) {
    if (distance(f->vertex(i)->point(), c.place) < kSeparation * c.size) return false;
    if (!f->is_constrained(i)) continue;
    const Kernel::Segment_2 edge(f->vertex(t_.ccw(i))->point(), f->vertex(t_.cw(i))->point());
    const double room = 0.5 * kSeparation * std::min(c.size, std::sqrt(edge.squared_length()));
    if (CGAL::squared_distance(edge, c.place) < room * room) return false;
  }
  return true;
}

/// True if the place is far enough from all vertices and given edges that it would be connected to. Nearest
/// faces first, it stops at what is too near: most places are refused, and may be in the circumcircles of very many
/// faces.
bool Refinement::has_room(const Candidate& c, Face located) {
  conflicts_.assign(1, {located, Face()});
  for (std::size_t next = 0; next < conflicts_.size(); ++next) {
    const auto [f, from] = conflicts_[next];
    if (!has_room_beside(c, f)) return false;
    // Seen across edges, the faces in conflict are a tree: none comes up twice.
    for (int i = 0; i < 3; ++i) {
      const Face g = f->neighbor(i);
      if (g != from && !f->is_constrained(i) && t_.test_conflict(c.place, g)) conflicts_.push_back({g, f});
    }
  }
  return true;
}

bool Refinement::insert(const Candidate& c) {
  ConstrainedDelaunay::Locate_type type;
  int index = 0;
  const Face f = t_.locate(c.place, type, index, c.near->face());
  if (type != ConstrainedDelaunay::FACE && type != ConstrainedDelaunay::EDGE) return false;
  if (!f->info().is_inside || (type == ConstrainedDelaunay::EDGE && f->is_constrained(index))) return false;
  if (!has_room(c, f)) return false;
  const Vertex v = t_.insert(c.place, type, f, index);
  v->info() = {n_given_ + static_cast<std::uint32_t>(added_.size()), c.size};
  added_.push_back(v);
  // All that changed is around the new vertex.
  auto around = t_.incident_faces(v), first = around;
  do {
    around->info().is_inside = true;
    around->info().is_settled = false;
  } while (++around != first);
  return true;
}

/// One round: tries the circumcentres of the faces not yet looked at. \returns whether any was added
bool Refinement::refine_once() {
  bool added = false;
  for (const Candidate& c : candidates()) added |= insert(c);
  return added;
}

/// Shape of the worst triangle between a place and the links of a vertex: area over the sum of squared edges, 1 for an
/// equilateral triangle; not above 0 if one turns over.
double Refinement::worst_shape(const Point& p) const {
  double worst = 1;
  for (const auto& [a, b] : links_) {
    if (CGAL::orientation(p, a, b) != CGAL::LEFT_TURN) return 0;
    const double edges = CGAL::squared_distance(p, a) + CGAL::squared_distance(a, b) + CGAL::squared_distance(b, p);
    worst = std::min(worst, kEquilateral * CGAL::area(p, a, b) / edges);
  }
  return worst;
}

/// Moves a vertex to the mean of the centroids of its triangles, weighted so that sizes are kept, unless one of them
/// would turn over or get a bad shape, worse than the worst that is there.
void Refinement::smooth_vertex(Vertex v) {
  double weight = 0, u = 0, w = 0;
  links_.clear();
  auto f = t_.incident_faces(v), first = f;
  do {
    const int i = f->index(v);
    const Vertex a = f->vertex(t_.ccw(i)), b = f->vertex(t_.cw(i));
    const Point centre = CGAL::centroid(v->point(), a->point(), b->point());
    const double s = (v->info().size + a->info().size + b->info().size) / v->info().size;
    const double share = CGAL::area(v->point(), a->point(), b->point()) / (s * s * s * s);
    weight += share, u += share * centre.x(), w += share * centre.y();
    links_.push_back({a->point(), b->point()});
  } while (++f != first);
  const Point moved(u / weight, w / weight);
  const double shape = worst_shape(moved);
  if (shape > 0 && (shape >= kGoodShape || shape >= worst_shape(v->point()))) v->set_point(moved);
}

/// Flips edges until all faces inside are Delaunay again.
void Refinement::restore_delaunay() {
  std::vector<Face> stack;
  for (const Face start : t_.finite_face_handles()) {
    if (!start->info().is_inside) continue;
    stack.push_back(start);
    while (!stack.empty()) {
      Face f = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        if (!t_.is_flipable(f, i)) continue;
        const Face g = f->neighbor(i);
        t_.flip(f, i);
        stack.push_back(g);
        stack.push_back(f);
        break;
      }
    }
  }
}

void Refinement::smooth() {
  for (const Vertex v : t_.finite_vertex_handles()) v->info().size = size_at(v->point());
  for (int round = 0; round < kSmoothingRounds; ++round) {
    for (const Vertex v : added_) smooth_vertex(v);
    restore_delaunay();
  }
}

}  // namespace

RefinedRegion refine_region(std::span<const Point2> points, std::span<const Edge> edges, const SizeFunction& size) {
  ConstrainedRegion region(points, edges);
  if (!region.contradicting_edges.empty()) {
    throw InputError(fmt::format(
        "refinement of a region: expected edges with the region to their left, found {} that contradict others, first "
        "edge {}",
        region.contradicting_edges.size(), region.contradicting_edges.front()));
  }
  Refinement refinement(region.triangulation, static_cast<std::uint32_t>(points.size()), size);
  refinement.refine();
  refinement.smooth();

  RefinedRegion result{{points.begin(), points.end()}, region.triangles()};
  for (const Vertex v : refinement.added()) result.points.push_back({v->point().x(), v->point().y()});
  return result;
}

}  // namespace nearwall::planar
