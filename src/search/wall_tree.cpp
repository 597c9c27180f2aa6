#include "nearwall/search/wall_tree.h"

#include <algorithm>
#include <limits>

#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"
#include "nearwall/predicates/intersection.h"
#include "search/box_tree.h"
#include "search/nearest_point.h"
#include "search/segment_boxes.h"

namespace nearwall::search {

namespace {

std::vector<geometry::Box> boxes_of(const std::vector<std::array<Vec3, 3>>& triangles) {
  std::vector<geometry::Box> boxes(triangles.size());
  parallel_for(boxes.size(), [&](std::size_t i) { boxes[i] = geometry::bounding_box(triangles[i]); });
  return boxes;
}

std::vector<std::array<Vec3, 3>> triangles_of(const mesh::SurfaceMesh& surface) {
  std::vector<std::array<Vec3, 3>> triangles(surface.faces.size());
  parallel_for(triangles.size(), [&](std::size_t i) { triangles[i] = surface.triangle(FaceId(i)); });
  return triangles;
}

/// Where a segment that meets a triangle does so, as a fraction of the segment.
double hit_fraction(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& t) {
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const double start = dot(normal, from - t[0]), end = dot(normal, to - t[0]);
  if (start != end) return start / (start - end);
  const double length = distance(from, to);
  return length > 0 ? distance(from, nearest_point(t, from)) / length : 0.0;
}

/// Square of the distance of a point from a box. Rounded, but never greater for a box that contains another.
double squared_distance(const geometry::Box& box, const Vec3& p) {
  Vec3 d;
  for (int k = 0; k < 3; ++k) d[k] = std::max({box.low[k] - p[k], p[k] - box.high[k], 0.0});
  return squared_norm(d);
}

}  // namespace

struct WallTree::Tree {
  explicit Tree(const mesh::SurfaceMesh& surface) : triangles(triangles_of(surface)), boxes(boxes_of(triangles)) {}

  std::vector<std::array<Vec3, 3>> triangles;  ///< (n_faces), by face id
  BoxTree boxes;
};

WallTree::WallTree(const mesh::SurfaceMesh& surface) : tree_(std::make_unique<Tree>(surface)) {}
WallTree::~WallTree() = default;

WallTree::Hit WallTree::first_hit(const Vec3& from, const Vec3& to, const std::function<bool(FaceId)>& keep) const {
  const SegmentBoxes segment(from, to, 1.0);
  double best = std::numeric_limits<double>::infinity();
  Hit hit;
  const auto is_ahead = [&](const geometry::Box& box) {
    const auto interval = segment.interval(box);
    return !interval.is_empty() && interval.first <= best;
  };
  tree_->boxes.for_each(is_ahead, [&](std::size_t position) {
    const FaceId face(tree_->boxes.item(position));
    const auto& triangle = tree_->triangles[face.index()];
    if (!keep(face) || !predicates::segment_intersects_triangle(from, to, triangle)) return;
    // Within its box's interval whatever the rounding: then the order of the visits does not matter.
    const auto interval = segment.interval(tree_->boxes.box(position));
    const double t = std::clamp(hit_fraction(from, to, triangle), interval.first, interval.last);
    if (t < best || (t == best && face < hit.face)) best = t, hit.face = face;
  });
  if (hit.face.is_valid()) hit.distance = best * distance(from, to);
  return hit;
}

std::vector<FaceId> WallTree::faces_near(const geometry::Box& box) const {
  std::vector<FaceId> faces;
  tree_->boxes.for_each([&](const geometry::Box& b) { return b.intersects(box); },
                        [&](std::size_t position) { faces.emplace_back(tree_->boxes.item(position)); });
  std::sort(faces.begin(), faces.end());
  return faces;
}

std::vector<FaceId> WallTree::faces_near(const Vec3& centre, double radius) const {
  std::vector<FaceId> faces;
  tree_->boxes.for_each([&](const geometry::Box& b) { return squared_distance(b, centre) <= radius * radius; },
                        [&](std::size_t position) { faces.emplace_back(tree_->boxes.item(position)); });
  std::sort(faces.begin(), faces.end());
  return faces;
}

Vec3 WallTree::nearest_on(FaceId face, const Vec3& p) const { return nearest_point(tree_->triangles[face.index()], p); }

WallTree::Nearest WallTree::nearest(const Vec3& p) const {
  expect(tree_->boxes.size() > 0, "a surface with faces");
  double best = std::numeric_limits<double>::infinity();
  Nearest nearest;
  const auto visit = [&](std::size_t position) {
    const FaceId face(tree_->boxes.item(position));
    const Vec3 point = nearest_point(tree_->triangles[face.index()], p);
    // Not below its box's whatever the rounding: then the order of the visits does not matter.
    const double squared = std::max(squared_norm(point - p), squared_distance(tree_->boxes.box(position), p));
    if (squared < best || (squared == best && face < nearest.face)) best = squared, nearest = {face, point, 0.0};
  };
  tree_->boxes.for_each_nearer([&](const geometry::Box& box) { return squared_distance(box, p); }, best, visit);
  nearest.distance = distance(nearest.point, p);
  return nearest;
}

}  // namespace nearwall::search
