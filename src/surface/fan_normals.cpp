#include "surface/fan_normals.h"

#include <fmt/format.h>

#include <algorithm>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/surface/iterative_normals.h"
#include "surface/normals_cap.h"
#include "surface/normals_visible.h"

namespace nearwall::surface {

namespace {

/// Fewer normals than this tell nothing about which of them is unsuitable (Bohdal 2017, algorithm 1).
constexpr std::size_t kEnoughToJudge = 5;

/// Whether a unit normal is that of a face with an area.
bool has_area(const Vec3& normal) { return squared_norm(normal) > 0; }

}  // namespace

bool FanNormals::is_left_out(HalfedgeId h) const {
  return !is_left_out_.empty() && is_left_out_[mesh::Topology::face(h).index()] != 0;
}

template <class Body>
void FanNormals::for_each_face(VertexId v, std::span<const HalfedgeId> faces, const Body& body) const {
  // A vertex whose faces are all to be left out has nothing but them.
  const bool takes_all = std::all_of(faces.begin(), faces.end(), [&](HalfedgeId h) { return is_left_out(h); });
  const Vec3 apex = surface_.points[v];
  Vec3 q = surface_.points[topology_.target(faces.front())];
  for (const HalfedgeId h : faces) {
    const Vec3 p = q;
    q = surface_.points[topology_.origin(mesh::Topology::previous(h))];
    const Vec3& normal = features_.face_normal[mesh::Topology::face(h)];
    if (!has_area(normal) || (!takes_all && is_left_out(h))) continue;
    body(normal, [&] {
      const Vec3 b = p - apex, c = q - apex;
      return FaceCorner(q - p, b, c, cross(b, c));
    });
  }
}

Vec3 FanNormals::weighted_sum(Weight weight, VertexId v, std::span<const HalfedgeId> faces) const {
  Vec3 sum;
  const auto sum_up = [&](const auto& weight_of) {
    for_each_face(v, faces, [&](const Vec3& normal, const auto& corner) { sum += normal * weight_of(corner); });
  };
  // The two that are asked for most are compiled apart: the compiler leaves out what they do not need.
  if (weight == Weight::Uniform) {
    sum_up([](const auto&) { return 1.0; });
  } else if (weight == Weight::Angle) {
    sum_up([](const auto& corner) { return corner().angle(); });
  } else {
    sum_up([weight](const auto& corner) { return corner_weight(weight, corner()); });
  }
  return sum;
}

Vec3 FanNormals::weighted_sum_of_suitable(Weight weight, VertexId v, std::span<const HalfedgeId> faces) const {
  Vec3 sum, plain;
  std::size_t n = 0;
  for_each_face(v, faces, [&](const Vec3& normal, const auto&) { plain += normal, ++n; });
  const Vec3 average = n > 0 ? plain / static_cast<double>(n) : plain;
  double squares = 0;
  for_each_face(v, faces, [&](const Vec3& normal, const auto&) { squares += squared_norm(normal - average); });
  const double limit = 2.0 * squares / static_cast<double>(n);
  for_each_face(v, faces, [&](const Vec3& normal, const auto& corner) {
    if (n >= kEnoughToJudge && squared_norm(normal - average) > limit) return;
    sum += normal * corner_weight(weight, corner());
  });
  return sum;
}

bool FanNormals::drops_unsuitable(VertexId v) const {
  return options_.unsuitable == Unsuitable::DropEverywhere ||
         (options_.unsuitable == Unsuitable::DropAtBoundary && topology_.is_boundary(v));
}

void FanNormals::gather(std::span<const HalfedgeId> faces) {
  if (room_.size() < faces.size()) room_.resize(faces.size());
  std::size_t n = 0;
  for (const HalfedgeId h : faces) {
    const Vec3& normal = features_.face_normal[mesh::Topology::face(h)];
    room_[n] = normal;
    n += has_area(normal) ? 1 : 0;
  }
  normals_ = {room_.data(), n};
}

Vec3 FanNormals::mean(Weight weight, VertexId v, std::span<const HalfedgeId> faces) {
  if (faces.empty()) return {};
  const Vec3 sum = drops_unsuitable(v) ? weighted_sum_of_suitable(weight, v, faces) : weighted_sum(weight, v, faces);
  if (sum != Vec3{}) return unit_vector(sum);
  // Faces whose normals cancel leave no mean: any direction is as good, and none sees them all.
  gather(faces);
  return normals_.empty() ? Vec3{} : normals_.front();
}

PointNormal FanNormals::judge(const Vec3& direction, std::span<const HalfedgeId> faces) {
  gather(faces);
  if (normals_.empty()) return {{}, geometry::kPi / 2, false, true};
  return judged(direction, normals_, squared_chord_to_worst(direction, normals_));
}

PointNormal FanNormals::of(VertexId v, std::span<const HalfedgeId> faces) {
  if (faces.empty()) return judge({}, faces);
  if (weight_) return judge(mean(*weight_, v, faces), faces);
  switch (options_.method) {
    case NormalMethod::MostVisible:
    case NormalMethod::MostNormal:
      return optimal(v, faces);
    case NormalMethod::Kallinderis:
      gather(faces);
      return answer_or_most_visible(kallinderis_normal(normals_), v, faces);
    case NormalMethod::Pirzadeh:
      gather(faces);
      return judge(pirzadeh_normal(normals_).direction, faces);
    case NormalMethod::Iterative:
      gather(faces);
      return judge(iterative_normal(normals_).direction, faces);
    default:
      throw InputError(fmt::format("{}: looks at more than the faces round a vertex", method_name(options_.method)));
  }
}

PointNormal FanNormals::optimal(VertexId v, std::span<const HalfedgeId> faces) {
  const Vec3 middle = mean(Weight::Angle, v, faces);
  gather(faces);
  const double to_worst = squared_chord_to_worst(middle, normals_);
  if (1.0 - 0.5 * to_worst > kVisibilityTrigger) return judged(middle, normals_, to_worst);
  if (options_.method == NormalMethod::MostVisible) return most_visible_or(middle, false);
  const auto best = most_normal(v, faces);
  return best && best->in_visibility_cone ? judge(best->direction, faces) : most_visible_or(middle, true);
}

/// Boundary vertices have no ring, and a run of faces has ends.
std::optional<NormalNormal> FanNormals::most_normal(VertexId v, std::span<const HalfedgeId> faces) {
  if (topology_.is_boundary(v) || faces.size() < topology_.fan(v).size()) return std::nullopt;
  ring_.clear();
  for (const HalfedgeId h : faces) ring_.push_back(surface_.points[topology_.target(h)]);
  return most_normal_normal(surface_.points[v], ring_);
}

PointNormal FanNormals::answer_or_most_visible(const std::optional<VisibleNormal>& answer, VertexId v,
                                               std::span<const HalfedgeId> faces) {
  return answer ? judge(answer->direction, faces) : most_visible_or(mean(Weight::Angle, v, faces), true);
}

PointNormal FanNormals::most_visible_or(const Vec3& direction, bool is_fallback) {
  if (normals_.empty()) return {{}, geometry::kPi / 2, false, true};
  const auto best = most_visible_of(normals_, normals_);
  const Vec3& chosen = best ? best->direction : direction;
  PointNormal normal = judged(chosen, normals_, squared_chord_to_worst(chosen, normals_));
  normal.is_fallback = is_fallback || !best;
  return normal;
}

}  // namespace nearwall::surface
