#pragma once

#include <array>
#include <span>

#include "nearwall/core/vec3.h"

/// The polynomials behind the predicates, each written once, for any number type that adds and multiplies: double (with
/// a static error bound beside it), Bounded, and the exact numbers of exact_cgal.cpp.
namespace nearwall::predicates {

template <class T>
struct Vector {
  T x, y, z;

  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
};

template <class T>
Vector<T> as_vector(const Vec3& a) {
  return {T(a.x()), T(a.y()), T(a.z())};
}

/// b − a.
template <class T>
Vector<T> edge(const Vec3& a, const Vec3& b) {
  return {T(b.x()) - T(a.x()), T(b.y()) - T(a.y()), T(b.z()) - T(a.z())};
}

template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
T orientation_determinant(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return dot(cross(edge<T>(a, b), edge<T>(a, c)), edge<T>(a, d));
}

/// Positive if c and d lie on one side of the line (a, b) of their common plane, zero if one of them is on it.
template <class T>
T same_side_product(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vector<T> ab = edge<T>(a, b);
  return dot(cross(ab, edge<T>(a, c)), cross(ab, edge<T>(a, d)));
}

/// Edge vectors of a wedge a0 a1 a2 | b0 b1 b2.
template <class T>
struct WedgeEdges {
  Vector<T> a1, a2;               ///< a1 − a0, a2 − a0
  Vector<T> b1, b2;               ///< b1 − b0, b2 − b0
  std::array<Vector<T>, 3> rise;  ///< b_i − a_i
};

template <class T>
WedgeEdges<T> wedge_edges(std::span<const Vec3, 6> p) {
  return {edge<T>(p[0], p[1]),
          edge<T>(p[0], p[2]),
          edge<T>(p[3], p[4]),
          edge<T>(p[3], p[5]),
          {edge<T>(p[0], p[3]), edge<T>(p[1], p[4]), edge<T>(p[2], p[5])}};
}

/// c0 (1 − s)² + twice_c1 s (1 − s) + c2 s² on [0, 1].
template <class T>
struct Quadratic {
  T c0, twice_c1, c2;
};

/// det J of a wedge is the sum of its barycentric coordinates times these. docs/theory/predicates.md, Eq. (7).
template <class T>
std::array<Quadratic<T>, 3> wedge_quadratics(const WedgeEdges<T>& e) {
  const Vector<T> bottom = cross(e.a1, e.a2);
  const Vector<T> mixed = cross(e.a1, e.b2) + cross(e.b1, e.a2);
  const Vector<T> top = cross(e.b1, e.b2);
  const auto along = [&](const Vector<T>& h) { return Quadratic<T>{dot(bottom, h), dot(mixed, h), dot(top, h)}; };
  return {along(e.rise[0]), along(e.rise[1]), along(e.rise[2])};
}

/// Edge vectors of a hexahedron by direction and by the places, 0 or 1, of the edge along the two other ones.
template <class T>
struct HexahedronEdges {
  std::array<std::array<Vector<T>, 2>, 2> u;  ///< [v][w]
  std::array<std::array<Vector<T>, 2>, 2> v;  ///< [u][w]
  std::array<std::array<Vector<T>, 2>, 2> w;  ///< [u][v]
};

template <class T>
HexahedronEdges<T> hexahedron_edges(std::span<const Vec3, 8> p) {
  const auto node = [&](int u, int v, int w) -> const Vec3& { return p[4 * w + (v == 0 ? u : 3 - u)]; };
  HexahedronEdges<T> e;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      e.u[i][j] = edge<T>(node(0, i, j), node(1, i, j));
      e.v[i][j] = edge<T>(node(i, 0, j), node(i, 1, j));
      e.w[i][j] = edge<T>(node(i, j, 0), node(i, j, 1));
    }
  }
  return e;
}

/// Bernstein coefficients of a polynomial of degree 2 in each of three variables, at 9 i + 3 j + k, all times one
/// factor.
template <class T>
using Triquadratic = std::array<T, 27>;

/// 8 / (C(2,i) C(2,j) C(2,k)) at 9 i + 3 j + k.
inline constexpr std::array<double, 27> kEightOverBinomials = [] {
  std::array<double, 27> weights{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) weights[9 * i + 3 * j + k] = 8.0 / ((1 + i % 2) * (1 + j % 2) * (1 + k % 2));
    }
  }
  return weights;
}();

/// 8 det J of a hexahedron. docs/theory/predicates.md, Eq. (10).
template <class T>
Triquadratic<T> hexahedron_coefficients(const HexahedronEdges<T>& e) {
  Triquadratic<T> sum;
  sum.fill(T(0.0));
  // u of X_v, v of X_u; what differs along w is summed before the product with X_w.
  for (int u = 0; u < 2; ++u) {
    for (int v = 0; v < 2; ++v) {
      const Vector<T> area0 = cross(e.u[v][0], e.v[u][0]), area2 = cross(e.u[v][1], e.v[u][1]);
      const Vector<T> area1 = cross(e.u[v][0], e.v[u][1]) + cross(e.u[v][1], e.v[u][0]);
      const auto add = [&](int i, int j, const Vector<T>& along) {
        T* const c = sum.data() + 9 * i + 3 * j;
        c[0] = c[0] + dot(area0, along);
        c[1] = c[1] + dot(area1, along);
        c[2] = c[2] + dot(area2, along);
      };
      add(u, v, e.w[0][0]);
      add(u, v + 1, e.w[0][1]);
      add(u + 1, v, e.w[1][0]);
      add(u + 1, v + 1, e.w[1][1]);
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = sum[i] * T(kEightOverBinomials[i]);
  return sum;
}

}  // namespace nearwall::predicates
