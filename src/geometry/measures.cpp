#include "nearwall/geometry/measures.h"

#include <algorithm>
#include <cmath>

#include "nearwall/geometry/angles.h"

namespace nearwall::geometry {

namespace {

double det(const Vec3& a, const Vec3& b, const Vec3& c) { return dot(cross(a, b), c); }

}  // namespace

double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) { return norm(triangle_area_vector(a, b, c)); }

Vec3 triangle_normal(const Vec3& a, const Vec3& b, const Vec3& c) { return normalized(cross(b - a, c - a)); }

double widest_corner(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::max({corner_angle(a, b, c), corner_angle(b, c, a), corner_angle(c, a, b)});
}

double tetrahedron_volume(std::span<const Vec3, 4> p) { return det(p[1] - p[0], p[2] - p[0], p[3] - p[0]) / 6; }

double pyramid_volume(std::span<const Vec3, 5> p) {
  // det J is bilinear over the base: its mean is the mean of the four corner values, each a determinant.
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    sum += det(p[(k + 1) % 4] - p[k], p[(k + 3) % 4] - p[k], p[4] - p[k]);
  }
  return sum / 12;
}

double wedge_volume(std::span<const Vec3, 6> p) {
  // det J = sum of lambda_i q_i(zeta); each q_i in Bernstein form (c0, c1, c2) has the mean (c0 + c1 + c2) / 3.
  const Vec3 e1 = p[1] - p[0], e2 = p[2] - p[0], f1 = p[4] - p[3], f2 = p[5] - p[3];
  const Vec3 bottom_and_top = cross(e1, e2) + cross(f1, f2);
  const Vec3 mixed = (cross(e1, f2) + cross(f1, e2)) * 0.5;
  const Vec3 heights = (p[3] - p[0]) + (p[4] - p[1]) + (p[5] - p[2]);
  return dot(bottom_and_top + mixed, heights) / 18;
}

double hexahedron_volume(std::span<const Vec3, 8> p) {
  // Boundary integral over the six bilinear faces about p0: exact for the trilinear map.
  static constexpr int kFaces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                       {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  double sum = 0;
  for (const auto& face : kFaces) {
    const Vec3 a = p[face[0]] - p[0], b = p[face[1]] - p[0], c = p[face[2]] - p[0], d = p[face[3]] - p[0];
    // A bilinear face's flux equals the mean over both ways of cutting it into two triangles.
    sum += det(a, b, c) + det(a, c, d) + det(a, b, d) + det(b, c, d);
  }
  return sum / 12;
}

void CompensatedSum::add(double v) {
  const double t = sum_ + v;
  compensation_ += std::abs(sum_) >= std::abs(v) ? (sum_ - t) + v : (v - t) + sum_;
  sum_ = t;
}

}  // namespace nearwall::geometry
