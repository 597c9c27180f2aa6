#include "tests/predicates/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace nearwall::reference {

namespace {

constexpr int kMantissaBits = 53;

/// Exponent e of v = m 2^e with an integer m of 53 bits; zero imposes none.
int exponent_of(double v) {
  if (v == 0) return std::numeric_limits<int>::max();
  int e = 0;
  std::frexp(v, &e);
  return e - kMantissaBits;
}

mpz_class scaled(double v, int exponent) {
  if (v == 0) return 0;
  int e = 0;
  mpz_class m(std::ldexp(std::frexp(v, &e), kMantissaBits));
  return m << static_cast<unsigned long>(e - kMantissaBits - exponent);
}

int sign_of(const mpz_class& v) { return sgn(v); }

/// det J of a hexahedron at (u, v, w) / n, times n^6.
mpz_class determinant_at(std::span<const Point> p, int u, int v, int w, int n) {
  const auto blend = [&](const Point& a, const Point& b, int t) { return mpz_class(n - t) * a + mpz_class(t) * b; };
  const auto along = [&](int a, int b) { return p[b] - p[a]; };
  const Point du = blend(blend(along(0, 1), along(3, 2), v), blend(along(4, 5), along(7, 6), v), w);
  const Point dv = blend(blend(along(0, 3), along(1, 2), u), blend(along(4, 7), along(5, 6), u), w);
  const Point dw = blend(blend(along(0, 4), along(1, 5), u), blend(along(3, 7), along(2, 6), u), v);
  return dot(cross(du, dv), dw);
}

/// Values of a triquadratic on the 3 x 3 x 3 grid to 8 times its Bernstein coefficients: f(0), f(1/2), f(1) to 2 f(0),
/// 4 f(1/2) − f(0) − f(1), 2 f(1) along each axis.
void interpolate(std::array<mpz_class, 27>& values) {
  for (const int stride : {9, 3, 1}) {
    for (int i = 0; i < 27; ++i) {
      if (i / stride % 3 != 0) continue;
      mpz_class &first = values[i], &middle = values[i + stride], &last = values[i + 2 * stride];
      middle = 4 * middle - first - last;
      first *= 2;
      last *= 2;
    }
  }
}

}  // namespace

std::vector<Point> as_integers(std::span<const Vec3> points) {
  int exponent = std::numeric_limits<int>::max();
  for (const Vec3& p : points) {
    for (int k = 0; k < 3; ++k) exponent = std::min(exponent, exponent_of(p[k]));
  }
  std::vector<Point> result;
  for (const Vec3& p : points) {
    result.push_back({scaled(p.x(), exponent), scaled(p.y(), exponent), scaled(p.z(), exponent)});
  }
  return result;
}

Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Point operator*(const mpz_class& s, const Point& a) { return {s * a.x, s * a.y, s * a.z}; }

Point cross(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

mpz_class dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto p = as_integers(std::array{a, b, c, d});
  std::array<int, 4> column{0, 1, 2, 3};
  mpz_class sum = 0;
  do {
    int inversions = 0;
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) inversions += column[i] > column[j] ? 1 : 0;
    }
    mpz_class term = inversions % 2 == 0 ? 1 : -1;
    for (int i = 0; i < 4; ++i) {
      if (column[i] < 3) term *= column[i] == 0 ? p[i].x : column[i] == 1 ? p[i].y : p[i].z;
    }
    sum += term;
  } while (std::next_permutation(column.begin(), column.end()));
  return -sign_of(sum);  // the column of ones stands last
}

bool is_parabola_positive(const mpz_class& at_0, const mpz_class& four_at_half, const mpz_class& at_1) {
  const mpz_class a = 2 * at_0 + 2 * at_1 - four_at_half, b = four_at_half - 3 * at_0 - at_1;
  if (at_0 <= 0 || at_1 <= 0) return false;
  const bool has_vertex_inside = a > 0 && b < 0 && -b < 2 * a;
  return !has_vertex_inside || 4 * a * at_0 > b * b;
}

int roots_in_unit_interval(const mpz_class& at_0, const mpz_class& four_at_half, const mpz_class& at_1) {
  const mpq_class a = 2 * at_0 + 2 * at_1 - four_at_half, b = four_at_half - 3 * at_0 - at_1, c = at_0;
  // The polynomial, its derivative 2 a t + b, minus the remainder of their division.
  const auto changes = [&](const mpq_class& t) {
    const mpq_class last = a == 0 ? mpq_class(0) : mpq_class(b * b / (4 * a) - c);
    int n = 0, before = 0;
    for (const mpq_class& value : {mpq_class((a * t + b) * t + c), mpq_class(2 * a * t + b), last}) {
      if (value == 0) continue;
      n += before != 0 && sgn(value) != before ? 1 : 0;
      before = sgn(value);
    }
    return n;
  };
  return changes(0) - changes(1);
}

bool is_pyramid_positive(std::span<const Vec3, 5> points) {
  const auto p = as_integers(points);
  for (const int u : {0, 1}) {
    for (const int v : {0, 1}) {
      const Point du = v == 0 ? p[1] - p[0] : p[2] - p[3], dv = u == 0 ? p[3] - p[0] : p[2] - p[1];
      const Point at = p[static_cast<std::size_t>(v == 0 ? u : 3 - u)];
      if (dot(cross(du, dv), p[4] - at) <= 0) return false;
    }
  }
  return true;
}

bool is_wedge_positive(std::span<const Vec3, 6> points) {
  const auto p = as_integers(points);
  for (int i = 0; i < 3; ++i) {
    const Point rise = p[3 + i] - p[i];
    const auto value = [&](int bottom, int top) {  // (bottom + top)^2 det J
      const auto edge = [&](int k) { return mpz_class(bottom) * (p[k] - p[0]) + mpz_class(top) * (p[3 + k] - p[3]); };
      return dot(cross(edge(1), edge(2)), rise);
    };
    if (!is_parabola_positive(value(1, 0), value(1, 1), value(0, 1))) return false;
  }
  return true;
}

mpz_class hexahedron_determinant(std::span<const Vec3, 8> points, int u, int v, int w, int n) {
  return determinant_at(as_integers(points), u, v, w, n);
}

predicates::Positivity hexahedron_positivity(std::span<const Vec3, 8> points) {
  using predicates::Positivity;
  constexpr int kHalvings = 8;
  constexpr std::size_t kMostOpen = 1024;
  const auto p = as_integers(points);
  std::vector<std::array<int, 3>> boxes{{0, 0, 0}};
  for (int level = 0; level <= kHalvings; ++level) {
    std::vector<std::array<int, 3>> open;
    for (const auto& [u, v, w] : boxes) {
      std::array<mpz_class, 27> values;
      for (int i = 0; i < 27; ++i) {
        values[i] = determinant_at(p, 2 * u + i / 9, 2 * v + i / 3 % 3, 2 * w + i % 3, 2 << level);
        const bool is_corner = i / 9 != 1 && i / 3 % 3 != 1 && i % 3 != 1;
        if (is_corner && values[i] <= 0) return Positivity::NotPositive;
      }
      interpolate(values);
      if (std::any_of(values.begin(), values.end(), [](const mpz_class& c) { return c <= 0; }))
        open.push_back({u, v, w});
    }
    if (open.empty()) return Positivity::Positive;
    if (open.size() > kMostOpen) break;
    boxes.clear();
    for (const auto& [u, v, w] : open) {
      for (int k = 0; k < 8; ++k) boxes.push_back({2 * u + (k & 1), 2 * v + (k >> 1 & 1), 2 * w + (k >> 2)});
    }
  }
  return Positivity::Undecided;
}

bool is_parallel_hexahedron_positive(std::span<const Vec3, 8> p) {
  for (int corner = 0; corner < 4; ++corner) {
    // With n = 2 all values carry the factor 64.
    const auto value = [&](int w) { return hexahedron_determinant(p, 2 * (corner & 1), 2 * (corner >> 1), w, 2); };
    if (!is_parabola_positive(value(0), 4 * value(1), value(2))) return false;
  }
  return true;
}

bool hulls_meet(std::span<const Point> a, std::span<const Point> b) {
  std::vector<Point> edges, axes;
  const auto add_edges = [&](std::span<const Point> s) {
    for (std::size_t i = 0; i < s.size(); ++i) edges.push_back(s[(i + 1) % s.size()] - s[i]);
  };
  add_edges(a);
  add_edges(b);
  edges.push_back(b[0] - a[0]);  // for points and segments
  for (const Point& e : edges) {
    axes.push_back(e);
    for (const Point& f : edges) {
      const Point n = cross(e, f);
      axes.push_back(n);
      axes.push_back(cross(n, e));
      axes.push_back(cross(n, f));
    }
  }
  const auto range = [](const Point& axis, std::span<const Point> s) {
    std::vector<mpz_class> values;
    for (const Point& p : s) values.push_back(dot(axis, p));
    return std::pair(*std::min_element(values.begin(), values.end()), *std::max_element(values.begin(), values.end()));
  };
  return std::none_of(axes.begin(), axes.end(), [&](const Point& axis) {
    const auto [low_a, high_a] = range(axis, a);
    const auto [low_b, high_b] = range(axis, b);
    return high_a < low_b || high_b < low_a;
  });
}

}  // namespace nearwall::reference
