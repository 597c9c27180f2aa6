#include "nearwall/volume/rest_boundary.h"

#include <algorithm>
#include <limits>
#include <map>

#include "nearwall/certify/flat_edges.h"
#include "nearwall/core/expect.h"
#include "nearwall/mesh/seams.h"
#include "nearwall/planar/crossing_edges.h"
#include "nearwall/planar/graded_points.h"
#include "nearwall/planar/region.h"
#include "nearwall/planar/size_field.h"

namespace nearwall::volume {

namespace {

using certify::FrontSurface;
using Flat = certify::FlatEdges;
using certify::TraceEdge;

/// Sizes are bounded by the growth alone.
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// A point of the front asks for sizes on a plane if it is no farther from it than so many of its edges.
constexpr double kNear = 20;

/// An edge at a corner between planes is no longer than this share of the shortest seam there.
constexpr double kShareOfSeam = 0.5;

class RestBuilder {
 public:
  RestBuilder(const mesh::LayerMesh& layers, const certify::CertifiedWall& wall, double growth,
              const PlaneBorders& borders)
      : layers_(layers),
        wall_(wall),
        growth_(growth),
        borders_(borders),
        front_(certify::front_surface(layers.front(), layers.lines())) {}

  RestBoundary build() {
    add_front();
    if (wall_.planes && !wall_.planes->empty()) add_planes();
    rename_points();
    return std::move(rest_);
  }

 private:
  double slope() const { return growth_ - 1; }

  /// Seen from outside of what is left: the other way round than the front, which looks into the fluid.
  void add_front() {
    rest_.surface.points = front_.points;
    for (std::size_t t = 0; t < front_.triangles.size(); ++t) {
      const FrontFaceId f = front_.face[t];
      if (layers_.front().is_wall(f) && !wall_.face_component[FaceId(f.index())].is_valid()) continue;
      const auto& [a, b, c] = front_.triangles[t];
      rest_.surface.triangles.push_back({a, c, b});
      rest_.front_face.push_back(f);
    }
    rest_.n_front = rest_.surface.triangles.size();
  }

  void add_planes() {
    const auto& planes = wall_.planes->planes;
    const auto traces = certify::plane_traces(layers_.front(), *wall_.planes, front_);
    edges_.resize(planes.size());
    for (std::size_t p = 0; p < planes.size(); ++p) {
      for (const TraceEdge& edge : traces[p]) edges_[p].push_back(edge.points);
    }
    find_sizes();
    const mesh::Seams seams = mesh::find_seams(front_.points, planes, edges_, wall_.planes->corners);
    expect(seams.loose.empty(), "rest_boundary: the edges of certified layers close on planes");
    for (const Vec3& corner : seams.corners) add_point(corner);
    find_sizes_at_corners(seams);
    for (const mesh::Seam& seam : seams.seams) divide(seam);
    for (mesh::PlaneIndex p = 0; p < planes.size(); ++p) fill(p);
  }

  /// Mean length of the edges of the front at each point.
  void find_sizes() {
    size_.assign(front_.points.size(), 0);
    std::vector<double> n(size_.size(), 0);
    for (const auto& t : front_.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double length = distance(front_.points[t[k]], front_.points[t[(k + 1) % 3]]);
        for (const std::size_t end : {k, (k + 1) % 3}) size_[t[end]] += length, ++n[t[end]];
      }
    }
    for (std::size_t i = 0; i < size_.size(); ++i) size_[i] = n[i] > 0 ? size_[i] / n[i] : 0.0;
  }

  /// What the other ends of the edges that meet there leave of the growth.
  void find_sizes_at_corners(const mesh::Seams& seams) {
    size_.resize(rest_.surface.points.size(), kNoLimit);
    for (int round = 0; round < 2; ++round) {
      for (const mesh::Seam& seam : seams.seams) {
        const double length = distance(rest_.surface.points[seam.ends[0]], rest_.surface.points[seam.ends[1]]);
        for (const std::size_t k : {0, 1}) {
          if (seam.ends[k] < front_.points.size()) continue;
          double& own = size_[seam.ends[k]];
          own = std::min({own, size_[seam.ends[1 - k]] + slope() * length, kShareOfSeam * length});
        }
      }
    }
  }

  std::uint32_t add_point(const Vec3& p) {
    rest_.surface.points.push_back(p);
    return static_cast<std::uint32_t>(rest_.surface.points.size() - 1);
  }

  /// Points along the edge between two planes.
  void divide(const mesh::Seam& seam) {
    const auto [from, to] = seam.ends;
    const Vec3 begin = rest_.surface.points[from], way = rest_.surface.points[to] - begin;
    const double length = norm(way);
    std::uint32_t last = from;
    const auto join = [&](std::uint32_t next) {
      edges_[seam.first].push_back({last, next});
      edges_[seam.second].push_back({next, last});
      last = next;
    };
    for (const double at : planar::graded_points(length, size_[from], size_[to], slope(), kNoLimit)) {
      join(add_point(begin + way * (at / length)));
    }
    join(to);
  }

  /// Whether a place is in the region to the left of edges: a ray crosses them an odd number of times.
  static bool is_inside(const Flat& flat, std::size_t n_edges, const planar::Point2& at) {
    bool is_odd = false;
    for (std::size_t i = 0; i < n_edges; ++i) {
      const planar::Point2 &a = flat.points[flat.edges[i][0]], &b = flat.points[flat.edges[i][1]];
      if ((a.v > at.v) == (b.v > at.v)) continue;
      if (at.u < a.u + (b.u - a.u) * ((at.v - a.v) / (b.v - a.v))) is_odd = !is_odd;
    }
    return is_odd;
  }

  /// Borders as slits, where they meet no edge but at its ends and lie in the region.
  void add_borders(mesh::PlaneIndex p, Flat& flat) {
    std::map<std::pair<double, double>, std::uint32_t> at;
    for (std::uint32_t i = 0; i < flat.points.size(); ++i) at.emplace(std::pair(flat.points[i].u, flat.points[i].v), i);
    Flat tried = flat;
    const auto number = [&](const Vec3& place) {
      const auto [u, v] = wall_.planes->planes[p].flat(place);
      const auto [found, is_new] = at.emplace(std::pair(u, v), static_cast<std::uint32_t>(tried.points.size()));
      if (is_new) tried.points.push_back({u, v});
      return found->second;
    };
    for (const auto& [begin, end] : borders_[p]) {
      const std::uint32_t from = number(begin), to = number(end);
      tried.edges.push_back({from, to});
    }
    const std::size_t n = flat.edges.size(), n_points = flat.points.size();
    std::vector<char> is_kept(tried.edges.size(), 1);
    for (const auto& [i, j] : planar::crossing_edges(tried.points, tried.edges)) is_kept[j] = 0;
    std::vector<std::uint32_t> added(tried.points.size(), 0);
    const auto own = [&](std::uint32_t point) {
      if (point < n_points) return point;
      if (added[point] == 0) {
        const planar::Point2& place = tried.points[point];
        added[point] = static_cast<std::uint32_t>(flat.points.size());
        flat.points.push_back(place);
        flat.original.push_back(add_point(wall_.planes->planes[p].lifted(place.u, place.v)));
      }
      return added[point];
    };
    for (std::size_t i = n; i < tried.edges.size(); ++i) {
      const planar::Point2 &a = tried.points[tried.edges[i][0]], &b = tried.points[tried.edges[i][1]];
      if (!is_kept[i] || !is_inside(flat, n, {0.5 * (a.u + b.u), 0.5 * (a.v + b.v)})) continue;
      const std::uint32_t from = own(tried.edges[i][0]), to = own(tried.edges[i][1]);
      flat.edges.push_back({from, to});
      flat.edges.push_back({to, from});
    }
  }

  /// Fronts near the plane that do not touch it.
  std::vector<planar::SizeSource> sources_near(const mesh::SidePlane& plane) const {
    std::vector<planar::SizeSource> sources;
    for (std::size_t i = 0; i < front_.points.size(); ++i) {
      const double height = plane.height(front_.points[i]);
      if (!(size_[i] > 0) || !(height > 0) || height > kNear * size_[i]) continue;
      const auto [u, v] = plane.flat(front_.points[i]);
      sources.push_back({{u, v}, size_[i] + slope() * height});
    }
    return sources;
  }

  void fill(mesh::PlaneIndex p) {
    if (edges_[p].empty()) return;
    const mesh::SidePlane& plane = wall_.planes->planes[p];
    Flat flat(plane, edges_[p], rest_.surface.points);
    if (p < borders_.size()) add_borders(p, flat);
    const planar::GradedSize size(flat.points, flat.edges, {slope(), kNoLimit}, sources_near(plane));
    const planar::RefinedRegion region =
        planar::refine_region(flat.points, flat.edges, [&](const planar::Point2& at) { return size(at); });
    for (std::size_t i = flat.original.size(); i < region.points.size(); ++i) {
      flat.original.push_back(add_point(plane.lifted(region.points[i].u, region.points[i].v)));
    }
    for (const auto& [a, b, c] : region.triangles) {
      rest_.surface.triangles.push_back({flat.original[a], flat.original[c], flat.original[b]});
      rest_.rest_plane.push_back(p);
    }
  }

  /// Leaves out the points that no triangle has.
  void rename_points() {
    std::vector<Vec3> points;
    std::vector<std::uint32_t> number(rest_.surface.points.size(), 0);
    std::vector<char> is_used(number.size(), 0);
    for (const auto& t : rest_.surface.triangles) {
      for (const std::uint32_t p : t) is_used[p] = 1;
    }
    for (std::uint32_t p = 0; p < number.size(); ++p) {
      if (!is_used[p]) continue;
      number[p] = static_cast<std::uint32_t>(points.size());
      points.push_back(rest_.surface.points[p]);
      rest_.node.push_back(node_of_front(layers_, p));
    }
    for (auto& t : rest_.surface.triangles) {
      for (std::uint32_t& p : t) p = number[p];
    }
    rest_.surface.points = std::move(points);
  }

  const mesh::LayerMesh& layers_;
  const certify::CertifiedWall& wall_;
  double growth_;
  const PlaneBorders& borders_;
  const FrontSurface front_;
  std::vector<double> size_;  // (n_front_points)
  mesh::PlaneEdges edges_;
  RestBoundary rest_;
};

}  // namespace

NodeIndex node_of_front(const mesh::LayerMesh& layers, std::uint32_t point) {
  const std::size_t n_lines = layers.front().n_lines(), n_caps = layers.caps().size();
  if (point >= n_lines + n_caps) return kNoLayerNode;
  if (point >= n_lines) return layers.n_nodes() - n_caps + (point - n_lines);
  const LineId line(point);
  return layers.node(line, layers.lines().windows[line].end);
}

RestBoundary rest_boundary(const mesh::LayerMesh& layers, const certify::CertifiedWall& wall, double growth,
                           const PlaneBorders& borders) {
  return RestBuilder(layers, wall, growth, borders).build();
}

}  // namespace nearwall::volume
