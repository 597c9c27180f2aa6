#include "surface/fan_normals.h"

#include <algorithm>

#include "nearwall/geometry/angles.h"
#include "surface/corner_weight.h"
#include "surface/normals_cap.h"
#include "surface/normals_visible.h"

namespace nearwall::surface {

namespace {

/// Fewer normals than this tell nothing about which of them is unsuitable (Bohdal 2017, algorithm 1).
constexpr std::size_t kEnoughToJudge = 5;

bool is_near(const Vec3& mean, std::span<const Vec3> normals) {
  return 1.0 - 0.5 * squared_chord_to_worst(mean, normals) > kVisibilityTrigger;
}

}  // namespace

void FanNormals::gather(std::span<const HalfedgeId> faces) {
  normals_.clear();
  for (const HalfedgeId h : faces) {
    const Vec3& normal = features_.face_normal[mesh::Topology::face(h)];
    if (normal != Vec3{}) normals_.push_back(normal);
  }
}

void FanNormals::weigh(Weight weight, VertexId v, std::span<const HalfedgeId> faces) {
  terms_.clear();
  weights_.clear();
  const Vec3 apex = surface_.points[v];
  Vec3 q = surface_.points[topology_.target(faces.front())];
  for (const HalfedgeId h : faces) {
    const Vec3 p = q;
    q = surface_.points[topology_.origin(mesh::Topology::previous(h))];
    const FaceId f = mesh::Topology::face(h);
    const Vec3& normal = features_.face_normal[f];
    if (normal == Vec3{} || (!is_left_out_.empty() && is_left_out_[f.index()])) continue;
    const Vec3 b = p - apex, c = q - apex;
    terms_.push_back(normal);
    weights_.push_back(corner_weight(weight, corner_between(b, c, q - p, cross(b, c))));
  }
}

void FanNormals::drop_unsuitable(VertexId v) {
  if (options_.unsuitable == Unsuitable::Keep || terms_.size() < kEnoughToJudge) return;
  if (options_.unsuitable == Unsuitable::DropAtBoundary && !topology_.is_boundary(v)) return;
  Vec3 sum;
  for (const Vec3& normal : terms_) sum += normal;
  const Vec3 average = sum / static_cast<double>(terms_.size());
  double sum_of_squares = 0;
  for (const Vec3& normal : terms_) sum_of_squares += squared_norm(normal - average);
  const double limit = 2.0 * sum_of_squares / static_cast<double>(terms_.size());
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    if (squared_norm(terms_[k] - average) > limit) weights_[k] = 0;
  }
}

Vec3 FanNormals::mean(Weight weight, VertexId v, std::span<const HalfedgeId> faces) {
  weigh(weight, v, faces);
  drop_unsuitable(v);
  Vec3 sum;
  for (std::size_t k = 0; k < terms_.size(); ++k) sum += terms_[k] * weights_[k];
  if (sum != Vec3{}) return unit_vector(sum);
  // Faces whose normals cancel leave no mean: any direction is as good, and none sees them all.
  gather(faces);
  return normals_.empty() ? Vec3{} : normals_.front();
}

PointNormal FanNormals::judge(const Vec3& direction, std::span<const HalfedgeId> faces) {
  gather(faces);
  return judged(direction, normals_, squared_chord_to_worst(direction, normals_));
}

PointNormal FanNormals::of(VertexId v, std::span<const HalfedgeId> faces) {
  gather(faces);
  if (normals_.empty()) return {{}, geometry::kPi / 2, false, true};
  if (const auto weight = weight_of(options_.method)) return judge(mean(*weight, v, faces), faces);
  return optimal(v, faces);
}

PointNormal FanNormals::optimal(VertexId v, std::span<const HalfedgeId> faces) {
  const Vec3 middle = mean(Weight::Angle, v, faces);
  gather(faces);
  if (is_near(middle, normals_)) return judge(middle, faces);
  return most_visible_or(middle, false);
}

PointNormal FanNormals::most_visible_or(const Vec3& direction, bool is_fallback) {
  if (const auto best = most_visible_of(normals_, normals_)) {
    PointNormal normal = judged(best->direction, normals_, squared_chord_to_worst(best->direction, normals_));
    normal.is_fallback = is_fallback;
    return normal;
  }
  PointNormal normal = judged(direction, normals_, squared_chord_to_worst(direction, normals_));
  normal.is_fallback = true;
  return normal;
}

}  // namespace nearwall::surface
