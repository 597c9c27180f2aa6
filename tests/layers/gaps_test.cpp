#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/geometry/angles.h"
#include "tests/layers/asked.h"

// Limits by gaps against what geometry says of plates, spheres, notches and edges: fronts keep a tenth of the gap free.

namespace nearwall::layers {
namespace {

using mesh::LimitReason;

bool is_of_first(const std::string& patch) { return patch.rfind("first", 0) == 0; }

/// Calls body(v) for the vertices inside of the faces by which two boxes look at each other.
template <class Body>
void for_each_in_gap(const Asked& a, double gap, const Body& body) {
  std::size_t n = 0;
  for (const VertexId v : a.wall.surface().points.ids()) {
    const Vec3& p = a.wall.surface().points[v];
    const bool is_inside = std::abs(p.y()) < 0.4 && std::abs(p.z()) < 0.4;
    const double from_middle = std::min(std::abs(p.x() - gap / 2), std::abs(p.x() + gap / 2));
    if (a.wall.wall().features.kind[v] != surface::PointKind::Smooth || !is_inside || from_middle > 1e-9) continue;
    ++n;
    body(v, p.x() < 0);
  }
  EXPECT_GE(n, 2u * 4u) << "vertices in the gap";
}

/// Two boxes, moved so that the gap lies round x = 0.
mesh::SurfaceMesh boxes(double gap) {
  mesh::SurfaceMesh surface = gallery::catalogued("two-boxes", {{"gap", gap}}, 0.25);
  const geometry::Box box = geometry::bounding_box(surface.points.raw());
  return shapes_for_tests::translated(surface, {-0.5 * (box.low.x() + box.high.x()), 0, 0});
}

TEST(LimitByGaps, GivesEachFrontHalfAndWhatTheOtherDoesNotAskFor) {
  const double gap = 0.1;
  for (const double a : {0.02, 0.05, 0.3}) {
    for (const double b : {0.0, 0.01, 0.044, 0.046, 0.2}) {
      Asked asked(boxes(gap), [&](const std::string& patch) { return is_of_first(patch) ? a : b; });
      limit_by_gaps(asked.wall.wall(), asked.plan, asked.field);
      double sum = 0;
      for_each_in_gap(asked, gap, [&](VertexId v, bool is_first) {
        const double mine = is_first ? a : b, other = is_first ? b : a;
        const double expected = std::min(mine, std::max(0.45 * gap, 0.9 * gap - other));
        EXPECT_NEAR(asked.field.thickness[v], expected, 1e-12) << a << " beside " << b;
        EXPECT_EQ(asked.field.reason[v], expected < mine ? LimitReason::Gap : LimitReason::None);
        sum = expected + std::min(other, std::max(0.45 * gap, 0.9 * gap - mine));
      });
      EXPECT_LE(sum, 0.9 * gap + 1e-12) << "a tenth of the gap is free";
    }
  }
}

TEST(LimitByGaps, SharesTheSpaceBetweenSpheres) {
  // Lines are radial, the gap 0.5 wide all over; facets are a little nearer to each other than the spheres.
  for (const double outer : {0.1, 0.8}) {
    Asked a(
        shapes_for_tests::flipped(gallery::catalogued("concentric-spheres", {}, 0.15)),
        [&](const std::string& patch) { return patch == "inner" ? 0.8 : outer; }, true);
    limit_by_gaps(a.wall.wall(), a.plan, a.field);
    for (const VertexId v : a.wall.surface().points.ids()) {
      const bool is_inner = norm(a.wall.surface().points[v]) < 0.75;
      const double mine = is_inner ? 0.8 : outer, other = is_inner ? outer : 0.8;
      const double expected = std::min(mine, std::max(0.225, 0.45 - other));
      EXPECT_NEAR(a.field.thickness[v], expected, 0.02 * expected);
    }
  }
}

TEST(LimitByGaps, KeepsToTheBisectorOfAnObliqueGap) {
  // At the distance s from the bottom line of a notch the other side is s sin(angle) away, and the plane between the
  // two s tan(angle / 2): less than half of the way along the line.
  const double angle = geometry::to_radians(60), asked = 0.25;
  Asked a(gallery::catalogued("notch", {}, 0.1), asked);
  const mesh::SurfaceMesh& surface = a.wall.surface();
  const auto is_in_notch = [&](VertexId v) {
    const auto fan = a.wall.topology().fan(v);
    return std::all_of(fan.begin(), fan.end(), [&](HalfedgeId h) {
      return surface.patch_names[surface.face_patch[mesh::Topology::face(h)]] == "notch";
    });
  };
  double bottom = 1e300;
  for (const VertexId v : surface.points.ids()) {
    if (is_in_notch(v)) bottom = std::min(bottom, surface.points[v].z());
  }
  limit_by_gaps(a.wall.wall(), a.plan, a.field);
  std::size_t n_limited = 0;
  for (const VertexId v : surface.points.ids()) {
    if (!is_in_notch(v) || a.wall.wall().features.kind[v] != surface::PointKind::Smooth) continue;
    const double s = (surface.points[v].z() - bottom) / std::cos(angle / 2);
    if (std::abs(surface.points[v].y()) > 0.3 || s < 0.1) continue;  // beside the ends, or a triangle from the bottom
    const double expected = std::min(asked, 0.9 * s * std::tan(angle / 2));
    EXPECT_NEAR(a.field.thickness[v], expected, 0.01 * expected) << s << ": two balls come that near";
    n_limited += expected < asked;
  }
  EXPECT_GT(n_limited, 20u);
}

TEST(LimitByGaps, SeesABodyBetweenTheRays) {
  // A slab 0.02 wide hangs 0.2 above a plate, half way between two rows of its vertices. A ball on the plate that
  // touches the slab's edge from l aside has the radius (l² + g²) / (2 g); for l > g its centre is above the edge, and
  // what the front there may have is for grading to say.
  const double g = 0.2, asked = 0.4, half_width = 0.01;
  mesh::SurfaceMesh plate = shapes_for_tests::mapped(gallery::catalogued("cube", {}, 0.25),
                                                     [](const Vec3& p) { return Vec3(p.x(), p.y(), p.z() - 0.5); });
  // The row of vertices nearest to the middle, and half of the way to its neighbours.
  std::vector<double> rows;
  for (const Vec3& p : plate.points) {
    if (std::abs(p.z()) < 1e-9 && std::abs(p.x()) < 0.3 && std::abs(p.y()) < 0.3) rows.push_back(p.x());
  }
  ASSERT_GT(rows.size(), 3u);
  std::sort(rows.begin(), rows.end());
  double widest = 0, middle = 0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    if (rows[k] - rows[k - 1] > widest) widest = rows[k] - rows[k - 1], middle = 0.5 * (rows[k] + rows[k - 1]);
  }
  ASSERT_GT(widest, 3 * half_width) << "rays miss the slab";
  const mesh::SurfaceMesh slab = shapes_for_tests::mapped(shapes_for_tests::cube(), [&](const Vec3& p) {
    return Vec3(middle + 2 * half_width * p.x(), 2 * p.y(), g + 0.5 + p.z());
  });
  Asked a(shapes_for_tests::joined(plate, slab), asked);
  limit_by_gaps(a.wall.wall(), a.plan, a.field);
  std::size_t n_limited = 0;
  for (const VertexId v : a.wall.surface().points.ids()) {
    const Vec3& p = a.wall.surface().points[v];
    if (std::abs(p.z()) > 1e-9 || a.wall.wall().features.kind[v] != surface::PointKind::Smooth) continue;
    const double l = std::max(0.0, std::abs(p.x() - middle) - half_width);
    const double expected = l < g ? std::min(asked, 0.9 * (l * l + g * g) / (2 * g)) : asked;
    EXPECT_NEAR(a.field.thickness[v], expected, 1e-9);
    n_limited += expected < asked;
  }
  EXPECT_GT(n_limited, 3u);
}

TEST(LimitByGaps, SeesWhatTheFacesOfACornerLookAt) {
  // Corner lines of two aligned cubes run along the diagonal, past the other cube.
  Asked a(shapes_for_tests::joined(shapes_for_tests::cube(), shapes_for_tests::cube(0.5, {1.001, 0, 0})), 0.3);
  limit_by_gaps(a.wall.wall(), a.plan, a.field);
  for (const VertexId v : a.wall.surface().points.ids()) {
    const double x = a.wall.surface().points[v].x();
    const bool at_the_gap = x > 0.4 && x < 0.6;
    EXPECT_NEAR(a.field.thickness[v], at_the_gap ? 0.45 * 0.001 : 0.3, 1e-12);
  }
}

TEST(LimitByGaps, TakesNoNoticeOfTheWallBesideAConcaveCorner) {
  // However thick, and wherever it is put: rounding must not tell that a square corner's sides face each other.
  const auto turned = [](const Vec3& p) {
    const double c = std::cos(0.3), s = std::sin(0.3);
    const Vec3 q(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
    return Vec3(q.x(), c * q.y() - s * q.z(), s * q.y() + c * q.z());
  };
  const mesh::SurfaceMesh block = gallery::catalogued("block-on-floor", {}, 0.25);
  for (const mesh::SurfaceMesh& surface : {block, shapes_for_tests::mapped(block, turned)}) {
    for (const double thickness : {0.05, 0.5}) {
      Asked a(surface, thickness);
      limit_by_gaps(a.wall.wall(), a.plan, a.field);
      for (const VertexId v : surface.points.ids()) {
        if (a.wall.wall().features.kind[v] != surface::PointKind::Smooth) continue;  // their lines lean
        EXPECT_EQ(a.field.reason[v], LimitReason::None) << thickness;
      }
    }
  }
}

}  // namespace
}  // namespace nearwall::layers
