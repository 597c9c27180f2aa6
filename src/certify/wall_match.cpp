#include "nearwall/certify/wall_match.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "nearwall/core/parallel.h"
#include "nearwall/search/point_tree.h"

namespace nearwall::certify {

namespace {

using mesh::FaceName;
using mesh::FaceNodes;

/// Share of the shortest edge within which a corner is the same: more than files written with a few digits lose, less
/// than would take one corner for another.
constexpr double kNear = 1e-3;
/// Relative error of a coordinate as a single precision float, along the diagonal of a cube.
constexpr double kFloatRounding = 0x1p-23;

/// The boundary's nodes, numbered for themselves, with the faces at each.
class BoundaryNodes {
 public:
  BoundaryNodes(const mesh::VolumeMesh& mesh, std::span<const FaceName> boundary) : boundary_(boundary) {
    std::vector<std::uint32_t> nodes;
    for (const FaceName name : boundary) {
      corners_.push_back(nodes_of(mesh, name));
      for (const std::uint32_t node : corners_.back()) {
        if (node != mesh::kNoNode && is_finite(mesh.points[node])) nodes.push_back(node);
      }
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    nodes_ = std::move(nodes);
    for (const std::uint32_t node : nodes_) points_.push_back(mesh.points[node]);
    offset_.assign(nodes_.size() + 1, 0);
    for_each_corner([&](std::size_t own, std::size_t) { ++offset_[own]; });
    for (std::size_t i = 1; i < offset_.size(); ++i) offset_[i] += offset_[i - 1];
    faces_.resize(offset_.back());
    for_each_corner([&](std::size_t own, std::size_t face) { faces_[--offset_[own]] = face; });
  }

  std::span<const Vec3> points() const { return points_; }
  std::span<const std::size_t> faces_at(std::uint32_t own) const {
    return {faces_.data() + offset_[own], faces_.data() + offset_[own + std::size_t{1}]};
  }
  std::uint32_t node(std::uint32_t own) const { return nodes_[own]; }
  const FaceNodes& corners(std::size_t face) const { return corners_[face]; }
  FaceName name(std::size_t face) const { return boundary_[face]; }

 private:
  template <class Visit>
  void for_each_corner(Visit&& visit) const {
    for (std::size_t face = 0; face < corners_.size(); ++face) {
      for (const std::uint32_t node : corners_[face]) {
        const auto at = std::lower_bound(nodes_.begin(), nodes_.end(), node);
        if (at != nodes_.end() && *at == node) visit(static_cast<std::size_t>(at - nodes_.begin()), face);
      }
    }
  }

  std::span<const FaceName> boundary_;
  std::vector<FaceNodes> corners_;    // (n_faces)
  std::vector<std::uint32_t> nodes_;  // ascending
  std::vector<Vec3> points_;          // (n_nodes)
  std::vector<std::size_t> offset_;   // (n_nodes + 1)
  std::vector<std::size_t> faces_;    // faces at each node
};

struct Found {
  std::size_t face = 0;
  double distance = std::numeric_limits<double>::infinity();  ///< of the corner that is farthest off
};

/// Nearest of the given nodes that is a corner of the face.
double nearest_corner(const BoundaryNodes& nodes, const FaceNodes& face, const std::vector<std::uint32_t>& candidates,
                      const Vec3& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::uint32_t own : candidates) {
    if (std::find(face.begin(), face.end(), nodes.node(own)) == face.end()) continue;
    nearest = std::min(nearest, distance(nodes.points()[own], place));
  }
  return nearest;
}

/// The best boundary face for a triangle; infinitely far if there is none within the radius.
Found find(const BoundaryNodes& nodes, const search::PointTree& tree, const std::array<Vec3, 3>& triangle,
           double radius) {
  std::array<std::vector<std::uint32_t>, 3> candidates;
  for (std::size_t k = 0; k < 3; ++k) {
    candidates[k] = tree.within(triangle[k], radius);
    if (candidates[k].empty()) return {};
  }
  Found best;
  for (const std::uint32_t own : candidates[0]) {
    for (const std::size_t face : nodes.faces_at(own)) {
      double farthest = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        farthest = std::max(farthest, nearest_corner(nodes, nodes.corners(face), candidates[k], triangle[k]));
      }
      if (farthest < best.distance || (farthest == best.distance && face < best.face)) best = {face, farthest};
    }
  }
  return best;
}

double radius_of(const std::array<Vec3, 3>& t) {
  const double shortest = std::min({distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])});
  const double reach = std::max({max_norm(t[0]), max_norm(t[1]), max_norm(t[2])});
  return kNear * shortest + kFloatRounding * reach;
}

}  // namespace

WallMatch match_wall(const mesh::VolumeMesh& mesh, std::span<const FaceName> boundary, const mesh::SurfaceMesh& wall) {
  const BoundaryNodes nodes(mesh, boundary);
  const search::PointTree tree(nodes.points());
  WallMatch match;
  match.face.resize(wall.faces.size());
  std::vector<char> is_exact(wall.faces.size(), 0);
  parallel_for(wall.faces.size(), [&](std::size_t i) {
    const std::array<Vec3, 3> triangle = wall.triangle(FaceId(i));
    if (!std::all_of(triangle.begin(), triangle.end(), is_finite)) return;
    Found found = find(nodes, tree, triangle, 0);
    is_exact[i] = found.distance == 0;
    if (!is_exact[i]) found = find(nodes, tree, triangle, radius_of(triangle));
    if (found.distance < std::numeric_limits<double>::infinity()) match.face[FaceId(i)] = nodes.name(found.face);
  });
  for (const FaceId f : wall.faces.ids()) {
    if (!match.face[f]) continue;
    ++(is_exact[f.index()] ? match.n_exact : match.n_near);
  }
  return match;
}

}  // namespace nearwall::certify
