#include "surface/fan_normals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/box.h"
#include "nearwall/surface/iterative_normals.h"
#include "surface/normals_cap.h"
#include "surface/normals_visible.h"
#include "surface/thin_faces.h"

namespace nearwall::surface {

namespace {

/// Fewer normals than this tell nothing about which of them is unsuitable (Bohdal 2017, algorithm 1).
constexpr std::size_t kEnoughToJudge = 5;

/// The normal of a vertex whose faces have no area, or that has none.
PointNormal without_faces() { return {{}, geometry::kPi / 2, false, true}; }

/// Power of two that brings the extent of the points near 1, so that no weight leaves the range of doubles.
double scale_of(std::span<const Vec3> points) {
  const geometry::Box box = geometry::bounding_box(points);
  if (box.is_empty()) return 1.0;
  int exponent = 0;
  std::frexp(max_norm(box.high - box.low), &exponent);
  return std::ldexp(1.0, -exponent);
}

}  // namespace

FanSource::FanSource(const mesh::SurfaceMesh& mesh, const mesh::Topology& adjacency, const Features& found,
                     const NormalOptions& asked)
    : surface(mesh), topology(adjacency), features(found), options(asked), scale(scale_of(mesh.points.raw())) {
  if (!(options.thin_angle > 0 && options.thin_angle <= geometry::kPi)) {
    throw InputError(fmt::format("thin_angle: expected more than 0 and at most 180 degrees, found {}",
                                 geometry::to_degrees(options.thin_angle)));
  }
  is_left_out = thin_boundary_faces(surface, topology, options.thin_angle);
}

bool FanNormals::is_left_out(HalfedgeId h) const {
  return !source_.is_left_out.empty() && source_.is_left_out[mesh::Topology::face(h).index()] != 0;
}

template <class Body>
void FanNormals::for_each_face(VertexId v, std::span<const HalfedgeId> faces, const Body& body) const {
  // A vertex whose faces are all to be left out has nothing but them.
  const bool takes_all = std::all_of(faces.begin(), faces.end(), [&](HalfedgeId h) { return is_left_out(h); });
  const Vec3 apex = source_.surface.points[v];
  Vec3 q = source_.surface.points[source_.topology.target(faces.front())];
  for (const HalfedgeId h : faces) {
    const Vec3 p = q;
    q = source_.surface.points[source_.topology.origin(mesh::Topology::previous(h))];
    const Vec3& normal = source_.features.face_normal[mesh::Topology::face(h)];
    if (!FaceNormals::has_area(normal) || (!takes_all && is_left_out(h))) continue;
    body(normal, [&] {
      const Vec3 b = (p - apex) * source_.scale, c = (q - apex) * source_.scale;
      return FaceCorner((q - p) * source_.scale, b, c, cross(b, c));
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
  return source_.options.unsuitable == Unsuitable::DropEverywhere ||
         (source_.options.unsuitable == Unsuitable::DropAtBoundary && source_.topology.is_boundary(v));
}

Vec3 FanNormals::mean(Weight weight, VertexId v, std::span<const HalfedgeId> faces) {
  if (faces.empty()) return {};
  const Vec3 sum = drops_unsuitable(v) ? weighted_sum_of_suitable(weight, v, faces) : weighted_sum(weight, v, faces);
  if (sum != Vec3{}) return unit_vector(sum);
  // Faces whose normals cancel leave no mean: any direction is as good, and none sees them all.
  const auto normals = face_normals_.of(faces);
  return normals.empty() ? Vec3{} : normals.front();
}

PointNormal FanNormals::judge(const Vec3& direction, std::span<const HalfedgeId> faces) {
  const auto normals = face_normals_.of(faces);
  if (normals.empty()) return without_faces();
  return judged(direction, normals, squared_chord_to_worst(direction, normals));
}

PointNormal FanNormals::of(VertexId v, std::span<const HalfedgeId> faces) {
  if (weight_) return judge(mean(*weight_, v, faces), faces);
  switch (source_.options.method) {
    case NormalMethod::MostVisible:
    case NormalMethod::MostNormal:
      return optimal(v, faces);
    case NormalMethod::Kallinderis:
      return kallinderis(v, faces);
    case NormalMethod::Pirzadeh:
      return judge(pirzadeh_normal(face_normals_.of(faces)).direction, faces);
    case NormalMethod::Iterative:
      return judge(iterative_normal(face_normals_.of(faces)).direction, faces);
    default:
      throw InputError(
          fmt::format("{}: looks at more than the faces round a vertex", method_name(source_.options.method)));
  }
}

PointNormal FanNormals::optimal(VertexId v, std::span<const HalfedgeId> faces) {
  const Vec3 middle = mean(Weight::Angle, v, faces);
  const auto normals = face_normals_.of(faces);
  if (normals.empty()) return without_faces();
  const double to_worst = squared_chord_to_worst(middle, normals);
  if (1.0 - 0.5 * to_worst > kVisibilityTrigger) return judged(middle, normals, to_worst);
  if (source_.options.method == NormalMethod::MostVisible) return most_visible_or(middle, normals, false);
  const auto best = most_normal(v, faces);
  return best && best->in_visibility_cone ? judge(best->direction, faces) : most_visible_or(middle, normals, true);
}

/// Boundary vertices have no ring, and a run of faces has ends.
std::optional<NormalNormal> FanNormals::most_normal(VertexId v, std::span<const HalfedgeId> faces) {
  if (source_.topology.is_boundary(v) || faces.size() < source_.topology.fan(v).size()) return std::nullopt;
  ring_.clear();
  source_.topology.for_each_neighbour(v, [&](VertexId w) { ring_.push_back(source_.surface.points[w]); });
  return most_normal_normal(source_.surface.points[v], ring_);
}

PointNormal FanNormals::kallinderis(VertexId v, std::span<const HalfedgeId> faces) {
  if (const auto answer = kallinderis_normal(face_normals_.of(faces))) return judge(answer->direction, faces);
  const Vec3 middle = mean(Weight::Angle, v, faces);
  return most_visible_or(middle, face_normals_.of(faces), true);
}

PointNormal FanNormals::most_visible_or(const Vec3& direction, std::span<const Vec3> normals, bool is_fallback) const {
  if (normals.empty()) return without_faces();
  const auto best = most_visible_of(normals, normals);
  const Vec3& chosen = best ? best->direction : direction;
  PointNormal normal = judged(chosen, normals, squared_chord_to_worst(chosen, normals));
  normal.is_fallback = is_fallback || !best;
  return normal;
}

}  // namespace nearwall::surface
