#include "nearwall/search/winding.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/angles.h"
#include "tests/search/soups.h"
#include "tests/support/shapes.h"

namespace nearwall::search {
namespace {

using soups_for_tests::Soup;
using soups_for_tests::soup_of;

/// Sum of the solid angles of the triangles over 4 pi (Van Oosterom and Strackee 1983).
double winding_by_solid_angles(const Soup& soup, const Vec3& point) {
  double sum = 0;
  for (const auto& t : soup.triangles) {
    const Vec3 a = soup.points[t[0]] - point, b = soup.points[t[1]] - point, c = soup.points[t[2]] - point;
    const double la = norm(a), lb = norm(b), lc = norm(c);
    sum += 2.0 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / (4.0 * geometry::kPi);
}

TEST(WindingNumber, CountsNestedSpheres) {
  using namespace shapes_for_tests;
  const Soup soup = soup_of(joined(joined(sphere(3, 4), sphere(3, 3)), flipped(sphere(3, 2))));
  EXPECT_EQ(winding_number(soup.view(), {0, 0, 0}), 1);  // 1 + 1 − 1
  EXPECT_EQ(winding_number(soup.view(), {2.5, 0, 0}), 2);
  EXPECT_EQ(winding_number(soup.view(), {0, 0, 3.5}), 1);
  EXPECT_EQ(winding_number(soup.view(), {0, -5, 0}), 0);
  EXPECT_EQ(winding_number(soup_of(flipped(cube())).view(), {0, 0, 0}), -1);
}

TEST(WindingNumber, CountsIncludedTrianglesOnly) {
  using namespace shapes_for_tests;
  const mesh::SurfaceMesh one = sphere(2, 1);
  const Soup soup = soup_of(joined(one, sphere(2, 2)));
  std::vector<char> include(soup.triangles.size(), 1);
  std::fill_n(include.begin(), one.faces.size(), char{0});
  EXPECT_EQ(winding_number(soup.view(), {0, 0, 0}), 2);
  EXPECT_EQ(winding_number(soup.view(), {0, 0, 0}, include), 1);
}

TEST(WindingNumber, IsNotMisledByRaysThroughCornersAndEdges) {
  using namespace shapes_for_tests;
  // From these points the axes run through corners, along edges and in the planes of sides.
  const Soup box = soup_of(subdivided(cube(1.0)));
  for (const double x : {-2.0, -0.5, 0.0, 0.5, 2.0}) {
    for (const double y : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      for (const double z : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        const double reach = std::max({std::abs(x), std::abs(y), std::abs(z)});
        if (reach == 1.0) continue;  // on the surface
        EXPECT_EQ(winding_number(box.view(), {x, y, z}), reach < 1 ? 1 : 0) << x << ' ' << y << ' ' << z;
      }
    }
  }
  EXPECT_EQ(winding_number(soup_of(octahedron()).view(), {0, 0, 0}), 1);
  EXPECT_EQ(winding_number(soup_of(octahedron()).view(), {-3, 0, 0}), 0);
  EXPECT_EQ(winding_number(soup_of(cone(8, 2)).view(), {0, 0, 3}), 0);
}

TEST(WindingNumber, AgreesWithSolidAngles) {
  using namespace shapes_for_tests;
  // Overlapping and entangled bodies: any whole number may come out.
  mesh::SurfaceMesh bodies = sphere(2, 1);
  bodies = joined(bodies, sphere(2, 0.8, {0.5, 0.1, 0}));
  bodies = joined(bodies, flipped(cube(0.4, {0.1, 0.7, 0.3})));
  bodies = joined(bodies, cone(7, 2));
  const Soup soup = soup_of(bodies);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1.2, 1.2);
  int n_nonzero = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p(coordinate(random), coordinate(random), coordinate(random));
    const int winding = winding_number(soup.view(), p);
    ASSERT_NEAR(winding, winding_by_solid_angles(soup, p), 1e-6) << p.x() << ' ' << p.y() << ' ' << p.z();
    n_nonzero += winding != 0 ? 1 : 0;
  }
  EXPECT_GT(n_nonzero, 200);
}

TEST(WindingNumber, DecidesNextToTheSurface) {
  const Soup box = soup_of(shapes_for_tests::cube(1.0));
  const double inside = std::nextafter(1.0, 0.0), outside = std::nextafter(1.0, 2.0);
  EXPECT_EQ(winding_number(box.view(), {0.3, inside, 0.1}), 1);
  EXPECT_EQ(winding_number(box.view(), {0.3, outside, 0.1}), 0);
  EXPECT_EQ(winding_number(box.view(), {-inside, inside, inside}), 1);
  EXPECT_EQ(winding_number(box.view(), {-inside, inside, outside}), 0);
}

TEST(WindingNumber, RefusesPointsOnTheSurface) {
  const Soup box = soup_of(shapes_for_tests::cube(1.0));
  EXPECT_THROW(winding_number(box.view(), {0.3, 1.0, 0.1}), GeometryError);
  EXPECT_THROW(winding_number(box.view(), {1.0, 1.0, 1.0}), GeometryError);
}

TEST(WindingNumber, IsTheSameAtAnyScale) {
  using namespace shapes_for_tests;
  for (const double scale : {0x1p-400, 0x1p-30, 0x1p300}) {
    const Soup soup = soup_of(scaled(sphere(2), scale));
    EXPECT_EQ(winding_number(soup.view(), scale * Vec3(0.1, 0.2, 0.3)), 1);
    EXPECT_EQ(winding_number(soup.view(), scale * Vec3(0.1, 0.2, 1.3)), 0);
  }
}

TEST(WindingNumber, OfNothingIsZero) { EXPECT_EQ(winding_number(Soup().view(), {1, 2, 3}), 0); }

}  // namespace
}  // namespace nearwall::search
