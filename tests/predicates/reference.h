#pragma once

#include <span>
#include <vector>

#include <gmpxx.h>

#include "nearwall/core/vec3.h"
#include "nearwall/predicates/cells.h"

/// Answers in GMP's integers, by other ways than those of src/predicates.
namespace nearwall::reference {

struct Point {
  mpz_class x, y, z;
};

/// The points times one power of two that makes them integers; the signs of homogeneous polynomials stay.
std::vector<Point> as_integers(std::span<const Vec3> points);

Point operator-(const Point& a, const Point& b);
Point operator+(const Point& a, const Point& b);
Point operator*(const mpz_class& s, const Point& a);
Point cross(const Point& a, const Point& b);
mpz_class dot(const Point& a, const Point& b);

/// Sign of the 4 x 4 determinant of homogeneous coordinates, by its 24 permutations.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Whether the parabola through (0, at_0), (1/2, four_at_half / 4), (1, at_1) is positive on [0, 1]: by its vertex.
bool is_parabola_positive(const mpz_class& at_0, const mpz_class& four_at_half, const mpz_class& at_1);

/// Number of different roots in (0, 1) of the same parabola, which is not zero at 0 and 1: Sturm's sequence in
/// rationals.
int roots_in_unit_interval(const mpz_class& at_0, const mpz_class& four_at_half, const mpz_class& at_1);

/// A pyramid by the values of det J at the corners of its base, over which it is bilinear.
bool is_pyramid_positive(std::span<const Vec3, 5> p);

/// A wedge by the values of det J at the ends and the middles of its three lines.
bool is_wedge_positive(std::span<const Vec3, 6> p);

/// A hexahedron between two parallel planes: det J is bilinear across and a parabola along each of the four lines.
bool is_parallel_hexahedron_positive(std::span<const Vec3, 8> p);

/// det J of a hexahedron at (u, v, w) / n, times n^6.
mpz_class hexahedron_determinant(std::span<const Vec3, 8> p, int u, int v, int w, int n);

/// A hexahedron by the values of det J on the 3 x 3 x 3 grid of each box, which give its Bernstein coefficients there
/// by interpolation; as deep as docs/theory/predicates.md says: 8 halvings, while no more than 1024 boxes are open.
predicates::Positivity hexahedron_positivity(std::span<const Vec3, 8> p);

/// Whether the convex hulls of two sets of at most three points meet: separating axes.
bool hulls_meet(std::span<const Point> a, std::span<const Point> b);

}  // namespace nearwall::reference
