#include "nearwall/predicates/cells.h"

#include <array>
#include <cmath>
#include <limits>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

#include "tests/predicates/points.h"
#include "tests/predicates/reference.h"

namespace nearwall::predicates {

void PrintTo(Positivity p, std::ostream* out) {
  *out << (p == Positivity::Positive ? "Positive" : p == Positivity::NotPositive ? "NotPositive" : "Undecided");
}

namespace {

using points_for_tests::Kind;
using points_for_tests::Points;
using Tetrahedron = std::array<Vec3, 4>;
using Pyramid = std::array<Vec3, 5>;
using Wedge = std::array<Vec3, 6>;
using Hexahedron = std::array<Vec3, 8>;

constexpr double kUlp = std::numeric_limits<double>::epsilon();
constexpr int kRounds = 12000;

Positivity positive_if(bool holds) { return holds ? Positivity::Positive : Positivity::NotPositive; }

class CellsOverAllKinds : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(, CellsOverAllKinds, testing::ValuesIn(points_for_tests::kAllKinds),
                         [](const auto& kind) { return points_for_tests::name_of(kind.param); });

/// Wedge between z = 0 and z = 1 over the unit right triangle, its top spanned by two edges from (0, 0, 1). Its three
/// quadratics are one: (1 − t)² + t (1 − t) (e.x + f.y) + t² e × f.
Wedge wedge_with_top(const Vec3& e, const Vec3& f) {
  const Vec3 up(0, 0, 1);
  return {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), up, up + e, up + f};
}

Hexahedron hexahedron_with_top(const std::array<Vec3, 4>& top) {
  return {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), top[0], top[1], top[2], top[3]};
}

/// Between z = 0 and z = 1, its top the unit square turned and stretched by (x, y) -> (c x − s y, s x + c y).
Hexahedron turned_hexahedron(double c, double s) {
  return hexahedron_with_top({Vec3(0, 0, 1), Vec3(c, s, 1), Vec3(c - s, s + c, 1), Vec3(-s, c, 1)});
}

TEST(Tetrahedron, IsPositiveInItsNodeOrder) {
  const Tetrahedron t{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  EXPECT_EQ(tetrahedron(t), Positivity::Positive);
  EXPECT_EQ(tetrahedron(Tetrahedron{t[1], t[0], t[2], t[3]}), Positivity::NotPositive);
  EXPECT_EQ(tetrahedron(Tetrahedron{t[0], t[1], t[2], Vec3(1, 1, 0)}), Positivity::NotPositive);
}

TEST(Pyramid, IsPositiveInItsNodeOrder) {
  const Pyramid p{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(9, -7, 1e-9)};
  EXPECT_EQ(pyramid(p), Positivity::Positive);
  EXPECT_EQ(pyramid(Pyramid{p[3], p[2], p[1], p[0], p[4]}), Positivity::NotPositive);
  EXPECT_EQ(pyramid(Pyramid{p[0], p[1], p[2], p[3], Vec3(0.5, 0.5, 0)}), Positivity::NotPositive);
  for (int turn = 1; turn < 4; ++turn) {
    EXPECT_EQ(pyramid(Pyramid{p[turn], p[(turn + 1) % 4], p[(turn + 2) % 4], p[(turn + 3) % 4], p[4]}),
              Positivity::Positive);
  }
}

TEST(Pyramid, NeedsAllFourCornersOfItsBase) {
  const Vec3 apex(0.5, 0.5, 1);
  // A dart: the corner in the middle turns the other way.
  EXPECT_EQ(pyramid(Pyramid{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.3, 0.3, 0), Vec3(0, 1, 0), apex}),
            Positivity::NotPositive);
  // Three corners on one line.
  EXPECT_EQ(pyramid(Pyramid{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0.5, 0), Vec3(0, 1, 0), apex}),
            Positivity::NotPositive);
  // A saddle with the apex just above and just below the plane of one corner.
  const std::array<Vec3, 4> base{Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(1, 1, 1),
                                 Vec3(0, 1, 0)};  // x + y − z = 1 at p1 ...
  EXPECT_EQ(pyramid(Pyramid{base[0], base[1], base[2], base[3], Vec3(0.5, 0.5, 1 + kUlp)}), Positivity::Positive);
  EXPECT_EQ(pyramid(Pyramid{base[0], base[1], base[2], base[3], Vec3(0.5, 0.5, 1)}), Positivity::NotPositive);
}

TEST(Wedge, IsPositiveInItsNodeOrder) {
  const Wedge w = wedge_with_top({1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(wedge(w), Positivity::Positive);
  EXPECT_EQ(wedge(Wedge{w[0], w[2], w[1], w[3], w[5], w[4]}), Positivity::NotPositive);
  EXPECT_EQ(wedge(Wedge{w[3], w[4], w[5], w[0], w[1], w[2]}), Positivity::NotPositive);
}

TEST(Wedge, MayBeNegativeInsideWithPositiveCorners) {
  // c0 = 1, c2 = 4, c1 = −5/2.
  EXPECT_EQ(wedge(wedge_with_top({-1, 0, 0}, {0, -4, 0})), Positivity::NotPositive);
}

TEST(Wedge, MayBePositiveWithANegativeMiddleCoefficient) {
  // c0 = 1, c2 = 25, c1 = −4 > −5.
  EXPECT_EQ(wedge(wedge_with_top({-4, 3, 0}, {-3, -4, 0})), Positivity::Positive);
}

TEST(Wedge, IsDecidedWhereTheQuadraticTouchesZero) {
  for (const double s : {1.0, 2.0, 3.0}) {  // c1 = −s, c2 = s²
    EXPECT_EQ(wedge(wedge_with_top({-s, 0, 0}, {0, -s, 0})), Positivity::NotPositive);
  }
  // c1 = −1, c2 = 1 ± 2^-104: no double can tell.
  EXPECT_EQ(wedge(wedge_with_top({-1, kUlp, 0}, {-kUlp, -1, 0})), Positivity::Positive);
  EXPECT_EQ(wedge(wedge_with_top({-1, kUlp, 0}, {kUlp, -1, 0})), Positivity::NotPositive);
}

TEST(Wedge, WithoutThicknessIsNotPositive) {
  const Wedge w = wedge_with_top({1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(wedge(Wedge{w[0], w[1], w[2], w[0], w[1], w[2]}), Positivity::NotPositive);
  EXPECT_EQ(wedge(Wedge{w[0], w[1], w[2], w[0], w[4], w[5]}), Positivity::NotPositive);
}

TEST(Cells, WithCoordinatesThatAreNotFiniteAreNotPositive) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (int node = 0; node < 6; ++node) {
      for (int axis = 0; axis < 3; ++axis) {
        Wedge w = wedge_with_top({1, 0, 0}, {0, 1, 0});
        w[node][axis] = bad;
        EXPECT_EQ(wedge(w), Positivity::NotPositive);
        std::array<std::array<std::array<double, 3>, 3>, 3> c;  // coordinate, line, level: two equal layers
        for (int i = 0; i < 9; ++i) {
          for (int k = 0; k < 3; ++k) c[k][i % 3][i / 3] = i < 6 ? w[i][k] : 2 * w[i - 3][k] - w[i - 6][k];
        }
        const WedgeColumn column{{c[0][0].data(), c[0][1].data(), c[0][2].data()},
                                 {c[1][0].data(), c[1][1].data(), c[1][2].data()},
                                 {c[2][0].data(), c[2][1].data(), c[2][2].data()}};
        EXPECT_EQ(first_bad_wedge(column, 2), 0);
      }
    }
    Hexahedron h = turned_hexahedron(1, 0);
    h[6][1] = bad;
    EXPECT_EQ(hexahedron(h), Positivity::NotPositive);
  }
}

/// A wedge of the kinds that occur: any six points, thin over one triangle, or with a slightly or wholly turned top.
Wedge random_wedge(Points& points, int round) {
  Wedge w = points.next_array<6>();
  if (round % 4 == 0) return w;
  const Vec3 normal = cross(w[1] - w[0], w[2] - w[0]);
  const Vec3 rise =
      (max_norm(normal) > 0 && is_finite(normal)) ? normal / max_norm(normal) * max_norm(w[1] - w[0]) : w[3];
  const double thickness = round % 4 == 1 ? 1e-6 : round % 4 == 2 ? 1e-12 : 1.0;
  const double lean = round % 3 == 0 ? 1e-15 : 0.5;
  for (int k = 0; k < 3; ++k) {
    const Vec3 base = round % 4 == 3 && k > 0 ? 2.0 * w[0] - w[k] : w[k];
    w[3 + k] = base + thickness * (rise + lean * (w[3 + k] - w[0]));
  }
  return w;
}

TEST_P(CellsOverAllKinds, WedgeAgreesWithIntegers) {
  Points points(GetParam(), 11);
  int n_positive = 0;
  for (int i = 0; i < kRounds; ++i) {
    const Wedge w = random_wedge(points, i);
    const bool expected = reference::is_wedge_positive(w);
    ASSERT_EQ(wedge(w), positive_if(expected)) << "round " << i;
    n_positive += expected ? 1 : 0;
  }
  EXPECT_GT(n_positive, kRounds / 200);
  EXPECT_LT(n_positive, kRounds * 99 / 100);
}

TEST(Wedge, OfCoplanarPointsIsNotPositiveWhateverRoundingAndUnderflowSay) {
  Points points(Kind::Uniform, 17);
  constexpr int kMillion = 1000000;
  for (const double scale : {1.0, 0x1p-360, 0x1p-375}) {  // products of three keep 53 bits, about 35, few
    for (int i = 0; i < 20000; ++i) {
      // The three upper corners are the lower ones, shifted within the plane.
      const int shift_x = points.integer(-kMillion, kMillion), shift_y = points.integer(-kMillion, kMillion);
      Wedge w;
      for (int k = 0; k < 3; ++k) {
        const int x = points.integer(-kMillion, kMillion), y = points.integer(-kMillion, kMillion);
        w[k] = scale * Vec3(x, y, x + 3 * y);
        w[3 + k] = scale * Vec3(x + shift_x, y + shift_y, x + shift_x + 3 * (y + shift_y));
      }
      ASSERT_EQ(wedge(w), Positivity::NotPositive) << "round " << i << " at scale " << scale;
    }
  }
}

TEST(Hexahedron, OfCoplanarPointsIsNotPositiveWhateverRoundingAndUnderflowSay) {
  Points points(Kind::Uniform, 18);
  constexpr int kMillion = 1000000;
  const auto in_plane = [&] {
    const int x = points.integer(-kMillion, kMillion), y = points.integer(-kMillion, kMillion);
    return Vec3(x, y, x + 3 * y);
  };
  for (const double scale : {1.0, 0x1p-360, 0x1p-375}) {
    for (int i = 0; i < 5000; ++i) {
      // All four edges of a direction are one vector, so rounding errs in the same way in all 27 coefficients.
      const Vec3 p = in_plane(), u = in_plane(), v = in_plane(), w = in_plane();
      Hexahedron h{p, p + u, p + u + v, p + v, p + w, p + u + w, p + u + v + w, p + v + w};
      for (Vec3& corner : h) corner *= scale;
      ASSERT_EQ(hexahedron(h), Positivity::NotPositive) << "round " << i << " at scale " << scale;
    }
  }
}

TEST_P(CellsOverAllKinds, WedgeDoesNotDependOnTheNumbering) {
  Points points(GetParam(), 12);
  for (int i = 0; i < kRounds / 4; ++i) {
    const Wedge w = random_wedge(points, i);
    const Positivity p = wedge(w);
    ASSERT_EQ(wedge(Wedge{w[1], w[2], w[0], w[4], w[5], w[3]}), p);
    ASSERT_EQ(wedge(Wedge{w[3], w[5], w[4], w[0], w[2], w[1]}), p);  // upside down
  }
}

TEST_P(CellsOverAllKinds, TetrahedronAndPyramidAgreeWithIntegers) {
  Points points(GetParam(), 13);
  int n_positive = 0;
  for (int i = 0; i < kRounds; ++i) {
    const auto p = points.next_array<5>();
    ASSERT_EQ(tetrahedron(Tetrahedron{p[0], p[1], p[2], p[3]}),
              positive_if(reference::orientation(p[0], p[1], p[2], p[3]) > 0));
    // det J over the base is bilinear: its corners, from the map's derivatives in integers.
    const auto q = reference::as_integers(p);
    bool expected = true;
    for (const auto& [corner, next, last] : {std::array{0, 1, 3}, {1, 2, 0}, {2, 3, 1}, {3, 0, 2}}) {
      const auto normal = reference::cross(q[next] - q[corner], q[last] - q[corner]);
      expected = expected && reference::dot(normal, q[4] - q[corner]) > 0;
    }
    ASSERT_EQ(pyramid(p), positive_if(expected)) << "round " << i;
    n_positive += expected ? 1 : 0;
  }
  EXPECT_GT(n_positive, 0);
}

TEST(Hexahedron, IsPositiveInItsNodeOrder) {
  const Hexahedron h = turned_hexahedron(1, 0);
  EXPECT_EQ(hexahedron(h), Positivity::Positive);
  EXPECT_EQ(hexahedron(Hexahedron{h[4], h[5], h[6], h[7], h[0], h[1], h[2], h[3]}), Positivity::NotPositive);
  EXPECT_EQ(hexahedron(Hexahedron{h[3], h[2], h[1], h[0], h[7], h[6], h[5], h[4]}), Positivity::NotPositive);
}

TEST(Hexahedron, MayBePositiveWithCoefficientsThatAreNot) {
  // det J = (1 − w)² + 2 c w (1 − w) + (c² + s²) w².
  EXPECT_EQ(hexahedron(turned_hexahedron(0, 1)), Positivity::Positive);      // a zero coefficient
  EXPECT_EQ(hexahedron(turned_hexahedron(-4, 3)), Positivity::Positive);     // −4 < 0, yet 16 < 25
  EXPECT_EQ(hexahedron(turned_hexahedron(-1, 0)), Positivity::NotPositive);  // zero at w = 1/2
  EXPECT_EQ(hexahedron(turned_hexahedron(-3, 0)), Positivity::NotPositive);  // zero at w = 1/4
}

TEST(Hexahedron, StaysUndecidedWhereZeroIsTouchedOffEveryCut) {
  EXPECT_EQ(hexahedron(turned_hexahedron(-2, 0)), Positivity::Undecided);  // zero at w = 1/3
}

TEST(Hexahedron, MayBeNegativeInsideWithPositiveCorners) {
  Hexahedron h = turned_hexahedron(-1, 0);
  h[5] = {-4, 0, 1};  // as for the wedge: negative between the planes, positive at all eight corners
  h[6] = {-4, -1, 1};
  EXPECT_GT(reference::hexahedron_determinant(h, 0, 0, 0, 1), 0);
  EXPECT_GT(reference::hexahedron_determinant(h, 1, 1, 1, 1), 0);
  EXPECT_EQ(hexahedron(h), Positivity::NotPositive);
}

TEST_P(CellsOverAllKinds, HexahedronBetweenParallelPlanesAgreesWithIntegers) {
  Points points(GetParam(), 14);
  int n_positive = 0, n_undecided = 0;
  for (int i = 0; i < kRounds / 40; ++i) {
    // Two random quadrilaterals in the planes z = low and z = high, the upper one often like the lower one.
    Hexahedron h = points.next_array<8>();
    const double low = points.next().z(), high = points.next().z();
    const double size = max_norm(h[0] - h[2]);
    const std::array<Vec3, 4> square{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0)};
    for (int k = 0; k < 8; ++k) {
      if (i % 4 != 0) h[k] = size * square[k % 4] + (i % 4 == 1 ? 0.9 : 0.25) * h[k];
      h[k] = {h[k].x(), h[k].y(), k < 4 ? low : high};
    }
    const bool expected = reference::is_parallel_hexahedron_positive(h);
    const Positivity found = hexahedron(h);
    if (found == Positivity::Undecided) {
      ++n_undecided;
    } else {
      ASSERT_EQ(found, positive_if(expected)) << "round " << i;
    }
    n_positive += expected ? 1 : 0;
  }
  EXPECT_GT(n_positive, 10);
  EXPECT_LT(n_undecided, 10);
}

TEST(Hexahedron, AgreesWithItsDeterminantOnAGrid) {
  constexpr int kSteps = 8;
  Points points(Kind::Uniform, 15);
  std::array<int, 3> seen{};
  for (int i = 0; i < 500; ++i) {
    Hexahedron h = turned_hexahedron(1, 0);
    for (Vec3& p : h) p += (i % 3 == 0 ? 1.0 : 0.6) * points.next();
    bool has_bad_point = false;
    for (int at = 0; at < (kSteps + 1) * (kSteps + 1) * (kSteps + 1) && !has_bad_point; ++at) {
      const int u = at % (kSteps + 1), v = at / (kSteps + 1) % (kSteps + 1), w = at / (kSteps + 1) / (kSteps + 1);
      has_bad_point = reference::hexahedron_determinant(h, u, v, w, kSteps) <= 0;
    }
    const Positivity p = hexahedron(h);
    ++seen[static_cast<std::size_t>(p)];
    if (has_bad_point) {
      ASSERT_EQ(p, Positivity::NotPositive) << "round " << i;
    }
    // Numbered from another corner, or with other axes, it is the same cell.
    ASSERT_EQ(hexahedron(Hexahedron{h[1], h[2], h[3], h[0], h[5], h[6], h[7], h[4]}), p);
    ASSERT_EQ(hexahedron(Hexahedron{h[0], h[4], h[5], h[1], h[3], h[7], h[6], h[2]}), p);
  }
  EXPECT_GT(seen[0], 10);
  EXPECT_GT(seen[1], 100);
  EXPECT_EQ(seen[2], 0);
}

/// Coordinates of three lines as a column wants them.
struct Lines {
  std::array<std::array<std::vector<double>, 3>, 3> c;  ///< axis, line, level
  void append(int line, const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis) c[axis][line].push_back(p[axis]);
  }
  Vec3 at(int line, int level) const { return {c[0][line][level], c[1][line][level], c[2][line][level]}; }
  WedgeColumn view() const {
    return {{c[0][0].data(), c[0][1].data(), c[0][2].data()},
            {c[1][0].data(), c[1][1].data(), c[1][2].data()},
            {c[2][0].data(), c[2][1].data(), c[2][2].data()}};
  }
};

int first_bad_by_single_wedges(const Lines& lines, int n_levels) {
  for (int j = 0; j < n_levels; ++j) {
    const Wedge w{lines.at(0, j),     lines.at(1, j),     lines.at(2, j),
                  lines.at(0, j + 1), lines.at(1, j + 1), lines.at(2, j + 1)};
    if (wedge(w) != Positivity::Positive) return j;
  }
  return n_levels;
}

TEST(FirstBadWedge, FindsWhatSingleWedgesFind) {
  Points points(Kind::Uniform, 16);
  std::array<int, 3> outcomes{};
  for (int round = 0; round < 20000; ++round) {
    const int n_levels = points.integer(0, 40);
    const std::array<Vec3, 3> base = points.next_array<3>();
    const Vec3 normal = normalized(cross(base[1] - base[0], base[2] - base[0]));
    const double first_step = std::pow(10.0, points.integer(-7, 0));
    Lines lines;
    for (int line = 0; line < 3; ++line) {
      const Vec3 along = normal + 0.7 * points.next();
      double height = 0, step = first_step;
      for (int j = 0; j <= n_levels; ++j, height += step, step *= 1.5) lines.append(line, base[line] + height * along);
    }
    const int found = first_bad_wedge(lines.view(), n_levels);
    ASSERT_EQ(found, first_bad_by_single_wedges(lines, n_levels)) << "round " << round;
    ++outcomes[found == n_levels ? 0 : found == 0 ? 1 : 2];
  }
  for (const int n : outcomes) EXPECT_GT(n, 100);
}

TEST(FirstBadWedge, FindsTheOneBadLevelOfAnyColumn) {
  for (const int n_levels : {1, 2, 3, 7, 30, 65535}) {
    Lines lines;
    for (int j = 0; j <= n_levels; ++j) {
      lines.append(0, Vec3(0, 0, j));
      lines.append(1, Vec3(1, 0, j));
      lines.append(2, Vec3(0, 1, j));
    }
    EXPECT_EQ(first_bad_wedge(lines.view(), n_levels), n_levels);
    for (const int bad : {0, n_levels / 2, n_levels - 1}) {
      Lines broken = lines;
      for (int line = 0; line < 3; ++line) broken.c[2][line][bad + 1] = bad;  // without thickness
      EXPECT_EQ(first_bad_wedge(broken.view(), n_levels), bad);
    }
  }
}

}  // namespace
}  // namespace nearwall::predicates
