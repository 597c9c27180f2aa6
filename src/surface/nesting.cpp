#include "surface/nesting.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <vector>

#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/box.h"
#include "nearwall/predicates/intersection.h"

namespace nearwall::surface {
namespace {

using geometry::Box;

/// Box tree over the triangles, for rays that run nearly along the x axis.
class RayTree {
 public:
  RayTree(const mesh::SurfaceMesh& surface, std::span<const char> is_flat) {
    boxes_.resize(surface.faces.size());
    for (const FaceId f : surface.faces.ids()) {
      if (is_flat[f.index()]) continue;
      boxes_[f.index()] = geometry::bounding_box(surface.triangle(f));
      faces_.push_back(f);
    }
    nodes_.reserve(faces_.size());
    if (!faces_.empty()) build(0, faces_.size());
  }

  bool is_empty() const { return nodes_.empty(); }
  const Box& bounds() const { return nodes_.front().box; }

  template <class Visit>
  void for_each_face_near(const Box& box, Visit&& visit) const {
    std::vector<std::size_t> stack = {0};
    while (!stack.empty()) {
      const Node& node = nodes_[stack.back()];
      const std::size_t first_child = stack.back() + 1;
      stack.pop_back();
      if (!node.box.intersects(box)) continue;
      if (node.second_child != 0) {
        stack.push_back(node.second_child);
        stack.push_back(first_child);
        continue;
      }
      for (std::size_t i = node.begin; i < node.end; ++i) {
        if (boxes_[faces_[i].index()].intersects(box)) visit(faces_[i]);
      }
    }
  }

 private:
  struct Node {
    Box box;
    std::size_t begin = 0, end = 0;
    std::size_t second_child = 0;  // the first follows its parent; 0: a leaf
  };

  void build(std::size_t begin, std::size_t end) {
    constexpr std::size_t kLeafSize = 8;
    const std::size_t self = nodes_.size();
    nodes_.push_back({Box(), begin, end});
    for (std::size_t i = begin; i < end; ++i) nodes_[self].box.include(boxes_[faces_[i].index()]);
    if (end - begin <= kLeafSize) return;
    // Rays run along x: only y and z tell triangles apart.
    const Vec3 extent = nodes_[self].box.high - nodes_[self].box.low;
    const int axis = extent.y() > extent.z() ? 1 : 2;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return faces_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end),
                     [&](FaceId a, FaceId b) { return boxes_[a.index()].low[axis] < boxes_[b.index()].low[axis]; });
    build(begin, middle);
    nodes_[self].second_child = nodes_.size();
    build(middle, end);
  }

  std::vector<Box> boxes_;     // (n_faces)
  std::vector<FaceId> faces_;  // in the order of the leaves
  std::vector<Node> nodes_;
};

/// End of a ray that leaves the surface's bounds on the side of +x, a little askew, another way at each attempt.
Vec3 ray_end(const Vec3& from, const Box& bounds, int attempt) {
  constexpr double kLean = 1.0 / 1024;  // small, so that few boxes lie near the ray
  // Few boxes lie near a short ray; but where a small surface is far from the origin, rounding takes its lean away, and
  // all attempts would be the same.
  constexpr int kShortAttempts = 8;
  const double extent = max_norm(bounds.high - bounds.low);
  const double size =
      attempt < kShortAttempts ? extent : std::max({extent, max_norm(bounds.low), max_norm(bounds.high)});
  const double lean_y = kLean * size * (0.5 + 0.5 / (1.0 + attempt));
  const double lean_z = kLean * size * (0.5 - 0.25 / (2.0 + attempt));
  return {bounds.high.x() + size, from.y() + lean_y, from.z() + lean_z};
}

/// Number of components other than `own` that enclose the point; nothing if the ray meets an edge or a corner.
std::optional<int> count_enclosing(const mesh::SurfaceMesh& surface,
                                   const IdVector<FaceId, ComponentId>& face_component, const RayTree& tree,
                                   ComponentId own, const Vec3& from, const Vec3& through) {
  Box ray_box;
  ray_box.include(from);
  ray_box.include(through);
  std::vector<ComponentId> crossed;
  bool is_generic = true;
  tree.for_each_face_near(ray_box, [&](FaceId f) {
    if (face_component[f] == own || !is_generic) return;
    switch (predicates::ray_crossing(from, through, surface.triangle(f))) {
      case predicates::RayCrossing::None:
        return;
      case predicates::RayCrossing::Degenerate:
        is_generic = false;
        return;
      default:
        crossed.push_back(face_component[f]);
    }
  });
  if (!is_generic) return std::nullopt;
  std::ranges::sort(crossed);
  int n_enclosing = 0;
  for (std::size_t begin = 0, end = 0; begin < crossed.size(); begin = end) {
    while (end < crossed.size() && crossed[end] == crossed[begin]) ++end;
    if ((end - begin) % 2 == 1) ++n_enclosing;
  }
  return n_enclosing;
}

int depth_of(const mesh::SurfaceMesh& surface, const IdVector<FaceId, ComponentId>& face_component, const RayTree& tree,
             ComponentId own, const Vec3& from) {
  constexpr int kMaxAttempts = 1000;
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    const Vec3 through = ray_end(from, tree.bounds(), attempt);
    if (const auto depth = count_enclosing(surface, face_component, tree, own, from, through)) return *depth;
  }
  expect(false, "a ray from a component meets no edge of the others");
  return 0;
}

}  // namespace

void find_nesting(const mesh::SurfaceMesh& surface, const IdVector<FaceId, ComponentId>& face_component,
                  std::span<const char> is_flat, IdVector<ComponentId, Component>& components) {
  if (components.size() < 2) return;
  const RayTree tree(surface, is_flat);
  if (tree.is_empty()) return;
  IdVector<ComponentId, Vec3> point(components.size());
  for (const FaceId f : surface.faces.ids()) point[face_component[f]] = surface.triangle(f)[0];
  parallel_for(components.size(), [&](std::size_t i) {
    const ComponentId c(i);
    components[c].depth = depth_of(surface, face_component, tree, c, point[c]);
  });
}

}  // namespace nearwall::surface
