#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "nearwall/core/vec3.h"
#include "nearwall/mesh/cell.h"

/// The map of a cell from its reference element, written down anew: nothing here is shared with predicates, measures or
/// certificate.
namespace nearwall::cells_for_tests {

/// A point of the reference element: (r, s) in the bottom face, t from it to the top or apex.
struct Reference {
  double r = 0, s = 0, t = 0;
};

class CellMap {
 public:
  /// \param corners  in the order of predicates/cells.h
  CellMap(mesh::CellType type, const std::array<Vec3, 8>& corners) : type_(type), p_(corners) {}

  Vec3 at(const Reference& q) const {
    const auto& [r, s, t] = q;
    switch (type_) {
      case mesh::CellType::Tetrahedron:
        return p_[0] * (1 - r - s - t) + p_[1] * r + p_[2] * s + p_[3] * t;
      case mesh::CellType::Pyramid:
        return quad(0, r, s) * (1 - t) + p_[4] * t;
      case mesh::CellType::Wedge:
        return triangle(0, r, s) * (1 - t) + triangle(3, r, s) * t;
      case mesh::CellType::Hexahedron:
        return quad(0, r, s) * (1 - t) + quad(4, r, s) * t;
    }
    return {};
  }

  /// Derivatives by r, s and t: the map is linear in each of them, so they are differences.
  std::array<Vec3, 3> jacobian(const Reference& q) const {
    const auto& [r, s, t] = q;
    return {at({1, s, t}) - at({0, s, t}), at({r, 1, t}) - at({r, 0, t}), at({r, s, 1}) - at({r, s, 0})};
  }

  double determinant(const Reference& q) const {
    const auto [a, b, c] = jacobian(q);
    return dot(cross(a, b), c);
  }

  /// By Gauss points in as many places as the degree of the determinant asks for: exact but for rounding.
  double volume() const {
    const double low = 0.5 - std::sqrt(1.0 / 12), high = 0.5 + std::sqrt(1.0 / 12), third = 1.0 / 3;
    if (type_ == mesh::CellType::Tetrahedron) return determinant({}) / 6;
    double sum = 0;
    for (const double t : {low, high}) {
      if (type_ == mesh::CellType::Wedge) {
        sum += determinant({third, third, t}) / 4;
        continue;
      }
      for (const double s : {low, high}) {
        for (const double r : {low, high}) sum += determinant({r, s, t}) / 8;
      }
    }
    return sum;
  }

  /// How far inside the reference element a point lies: negative outside.
  double depth(const Reference& q) const {
    const auto& [r, s, t] = q;
    switch (type_) {
      case mesh::CellType::Tetrahedron:
        return std::min({r, s, t, 1 - r - s - t});
      case mesh::CellType::Wedge:
        return std::min({r, s, 1 - r - s, t, 1 - t});
      case mesh::CellType::Pyramid:
      case mesh::CellType::Hexahedron:
        return std::min({r, s, t, 1 - r, 1 - s, 1 - t});
    }
    return -1;
  }

  /// The reference point of p, by Newton's method from the middle; nullopt if it leads nowhere.
  std::optional<Reference> inverse(const Vec3& p) const {
    constexpr int kSteps = 60;
    constexpr double kConverged = 1e-9, kFarAway = 100;
    Reference q{0.25, 0.25, 0.25};
    for (int step = 0; step < kSteps; ++step) {
      const auto [a, b, c] = jacobian(q);
      const Vec3 miss = p - at(q);
      const double det = dot(cross(a, b), c);
      const Vec3 move = Vec3(dot(cross(b, c), miss), dot(cross(c, a), miss), dot(cross(a, b), miss)) / det;
      if (!(max_norm(move) < kFarAway)) return std::nullopt;
      q = {q.r + move.x(), q.s + move.y(), q.t + move.z()};
      if (max_norm(move) < kConverged) return q;
    }
    return std::nullopt;
  }

 private:
  Vec3 triangle(std::size_t i, double r, double s) const { return p_[i] * (1 - r - s) + p_[i + 1] * r + p_[i + 2] * s; }
  Vec3 quad(std::size_t i, double r, double s) const {
    return (p_[i] * (1 - r) + p_[i + 1] * r) * (1 - s) + (p_[i + 3] * (1 - r) + p_[i + 2] * r) * s;
  }

  mesh::CellType type_;
  std::array<Vec3, 8> p_;
};

}  // namespace nearwall::cells_for_tests
