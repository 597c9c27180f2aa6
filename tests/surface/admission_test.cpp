#include "nearwall/surface/admission.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "nearwall/predicates/intersection.h"
#include "nearwall/surface/weld.h"
#include "tests/support/shapes.h"

namespace nearwall::surface {
namespace {

namespace shapes = shapes_for_tests;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Admission inspected(const mesh::SurfaceMesh& surface, Repair repair = Repair::None,
                    FluidSide fluid = FluidSide::Outside) {
  return inspect(surface, {fluid, repair});
}

/// Kinds found, each once, with their numbers over all patches.
std::vector<std::pair<FaultKind, std::size_t>> counts(const Admission& admission) {
  std::vector<std::pair<FaultKind, std::size_t>> result;
  for (const Fault& fault : admission.faults) {
    if (result.empty() || result.back().first != fault.kind) result.emplace_back(fault.kind, 0);
    result.back().second += fault.count;
  }
  return result;
}

std::vector<std::size_t> ids(const std::vector<FaceId>& faces) {
  std::vector<std::size_t> result;
  for (const FaceId f : faces) result.push_back(f.index());
  return result;
}

/// Volume within the triangles of one component, by the orientation they have now.
double volume(const Admission& admission, ComponentId component) {
  double six_volumes = 0;
  for (const FaceId f : admission.surface.faces.ids()) {
    const auto [a, b, c] = admission.surface.triangle(f);
    if (admission.face_component[f] == component) six_volumes += dot(a, cross(b, c));
  }
  return six_volumes / 6;
}

TEST(Admission, TakesASoundSurfaceAsItIs) {
  const mesh::SurfaceMesh cube = shapes::cube();
  const Admission admission = inspected(cube);
  EXPECT_TRUE(admission.is_usable());
  EXPECT_EQ(admission.surface.faces, cube.faces);
  EXPECT_EQ(admission.surface.points, cube.points);
  ASSERT_EQ(admission.components.size(), 1u);
  EXPECT_EQ(admission.components[ComponentId(0)].n_faces, 12u);
  EXPECT_DOUBLE_EQ(admission.components[ComponentId(0)].volume, 1.0);
  EXPECT_TRUE(admission.components[ComponentId(0)].is_wetted);
  EXPECT_EQ(admission.input_face[FaceId(7)], FaceId(7));
}

TEST(Admission, FindsPointsThatAreNotFinite) {
  mesh::SurfaceMesh cube = shapes::cube();
  cube.points[VertexId(6)] = {0, kNan, 0};
  cube.points[VertexId(1)] = {std::numeric_limits<double>::infinity(), 0, 0};
  const Admission admission = inspected(cube);
  EXPECT_THAT(counts(admission), ElementsAre(std::pair(FaultKind::NotFinite, 2)));
  EXPECT_THAT(ids(admission.faults.front().triangles), ElementsAre(1, 3, 4, 6, 8, 9, 10, 11));
  for (const Vec3& p : admission.faults.front().where) EXPECT_TRUE(is_finite(p));
}

TEST(Admission, RefusesSizesWhoseVolumesDoNotFitADouble) {
  for (const double size : {1e-310, 1e-150, 1e-100, 1e100, 1e150, 1e307}) {
    const Admission admission = inspected(shapes::cube(size));
    ASSERT_FALSE(admission.faults.empty()) << size;
    EXPECT_EQ(admission.faults.front().kind, FaultKind::OutOfRange) << size;
    EXPECT_EQ(admission.faults.front().triangles.size(), admission.surface.faces.size()) << size;
  }
  for (const double size : {1e-60, 1.0, 1e60}) EXPECT_TRUE(inspected(shapes::cube(size)).is_usable()) << size;
}

TEST(Admission, NamesTheOnePointThatIsTooFarOut) {
  mesh::SurfaceMesh cube = shapes::cube();
  cube.points[VertexId(6)] = {1e150, 0, 0};
  const Admission admission = inspected(cube);
  ASSERT_FALSE(admission.faults.empty());
  EXPECT_EQ(admission.faults.front().kind, FaultKind::OutOfRange);
  EXPECT_EQ(admission.faults.front().count, 1u);
  EXPECT_EQ(admission.faults.front().where.front(), Vec3(1e150, 0, 0));
}

/// Cube with a point in the middle of one edge that the triangle on one side does not know: a triangle without area
/// between the three points closes the gap.
mesh::SurfaceMesh cube_with_flat_triangle() {
  mesh::SurfaceMesh cube = shapes::cube();
  const auto [a, b, c] = cube.faces[FaceId(0)];
  const VertexId m = cube.points.push_back((cube.points[b] + cube.points[c]) * 0.5);
  cube.faces[FaceId(0)] = {a, b, m};
  shapes::add_face(cube, {a.index(), m.index(), c.index()});
  shapes::add_face(cube, {b.index(), c.index(), m.index()});
  return cube;
}

TEST(Admission, FindsTrianglesWithoutArea) {
  for (const Repair repair : {Repair::None, Repair::Safe}) {
    const Admission admission = inspected(cube_with_flat_triangle(), repair);
    // The two halves of the split side lie along the whole side of their neighbour, with which they share one point
    // each.
    EXPECT_THAT(counts(admission),
                ElementsAre(std::pair(FaultKind::DegenerateTriangle, 1), std::pair(FaultKind::SelfIntersection, 2)));
    EXPECT_THAT(ids(admission.faults.front().triangles), ElementsAre(13));
  }
}

TEST(Admission, FindsTrianglesWithARepeatedCornerAndDropsThemSafely) {
  mesh::SurfaceMesh cube = shapes::cube();
  shapes::add_face(cube, {3, 5, 3});
  shapes::add_face(cube, {2, 2, 2});
  EXPECT_THAT(counts(inspected(cube)), ElementsAre(std::pair(FaultKind::DegenerateTriangle, 2)));
  const Admission repaired = inspected(cube, Repair::Safe);
  EXPECT_TRUE(repaired.is_usable());
  EXPECT_EQ(repaired.surface.faces, shapes::cube().faces);
  EXPECT_EQ(repaired.repairs.size(), 1u);
}

TEST(Admission, TellsOfPartsThatEncloseNothingOnce) {
  const mesh::SurfaceMesh speck = shapes::make_surface({{5, 5, 5}, {6, 5, 5}}, {{0, 0, 1}});
  const mesh::SurfaceMesh pillow = shapes::make_surface({{5, 5, 5}, {6, 5, 5}, {5, 6, 5}}, {{0, 1, 2}, {0, 2, 1}});
  EXPECT_THAT(counts(inspected(shapes::joined(shapes::cube(), speck))),
              ElementsAre(std::pair(FaultKind::DegenerateTriangle, 1)));
  EXPECT_THAT(counts(inspected(shapes::joined(shapes::cube(), pillow))),
              ElementsAre(std::pair(FaultKind::DuplicateTriangle, 1)));
}

TEST(Admission, FindsCopiesOfTrianglesAndDropsThemSafely) {
  mesh::SurfaceMesh cube = shapes::cube();
  const auto face = cube.faces[FaceId(4)];
  cube.faces.raw().insert(cube.faces.begin() + 6, {face[1], face[2], face[0]});
  cube.face_patch.push_back(PatchId(0));
  const Admission refused = inspected(cube);
  EXPECT_THAT(counts(refused), ElementsAre(std::pair(FaultKind::DuplicateTriangle, 1)));
  EXPECT_THAT(ids(refused.faults.front().triangles), ElementsAre(4, 6));
  const Admission repaired = inspected(cube, Repair::Safe);
  EXPECT_TRUE(repaired.is_usable());
  EXPECT_EQ(repaired.surface.faces, shapes::cube().faces);
  EXPECT_EQ(repaired.input_face[FaceId(5)], FaceId(5));
  EXPECT_EQ(repaired.input_face[FaceId(6)], FaceId(7));
}

TEST(Admission, DoesNotDropACopyThatRunsTheOtherWayRound) {
  mesh::SurfaceMesh cube = shapes::cube();
  const auto face = cube.faces[FaceId(4)];
  shapes::add_face(cube, {face[0].index(), face[2].index(), face[1].index()});
  const Admission admission = inspected(cube, Repair::Safe);
  EXPECT_THAT(counts(admission),
              ElementsAre(std::pair(FaultKind::DuplicateTriangle, 1), std::pair(FaultKind::NonManifoldEdge, 3)));
}

TEST(Admission, FindsEdgesOfMoreThanTwoTriangles) {
  const Admission admission = inspected(shapes::cubes_sharing_an_edge());
  EXPECT_THAT(counts(admission), ElementsAre(std::pair(FaultKind::NonManifoldEdge, 1)));
  EXPECT_EQ(admission.faults.front().triangles.size(), 4u);
  EXPECT_THAT(admission.faults.front().where, ElementsAre(Vec3(1, 1, 0.5)));
  EXPECT_TRUE(admission.face_component.empty());
}

TEST(Admission, FindsPointsWhereBodiesTouch) {
  const Admission admission = inspected(shapes::pinched_vertex());
  EXPECT_THAT(counts(admission), ElementsAre(std::pair(FaultKind::NonManifoldVertex, 1)));
  EXPECT_EQ(admission.faults.front().triangles.size(), 6u);
  EXPECT_THAT(admission.faults.front().where, ElementsAre(Vec3(0, 0, 0)));
}

TEST(Admission, FindsNeighboursThatDisagreeAndTurnsThemSafely) {
  mesh::SurfaceMesh cube = shapes::cube();
  shapes::flip(cube, FaceId(3));
  EXPECT_THAT(counts(inspected(cube)), ElementsAre(std::pair(FaultKind::InconsistentOrientation, 3)));
  const Admission repaired = inspected(cube, Repair::Safe);
  EXPECT_TRUE(repaired.is_usable());
  EXPECT_EQ(repaired.surface.faces, shapes::cube().faces);
  EXPECT_THAT(repaired.repairs, ElementsAre("Turned round 1 triangle to agree with its neighbours."));
}

TEST(Admission, PutsAShuffledOrientationRight) {
  const mesh::SurfaceMesh spheres = shapes::joined(shapes::sphere(3), shapes::sphere(2, 0.5, {3, 0, 0}));
  mesh::SurfaceMesh shuffled = spheres;
  for (const FaceId f : shuffled.faces.ids()) {
    if (std::sin(f.index() * 12.9898) > -0.5) shapes::flip(shuffled, f);
  }
  EXPECT_FALSE(inspected(shuffled).is_usable());
  const Admission repaired = inspected(shuffled, Repair::Safe);
  ASSERT_TRUE(repaired.is_usable());
  EXPECT_EQ(repaired.repairs.size(), 2u);
  for (const ComponentId c : repaired.components.ids()) EXPECT_GT(volume(repaired, c), 0);
}

TEST(Admission, KnowsThatAMoebiusStripHasOneSide) {
  for (const Repair repair : {Repair::None, Repair::Safe}) {
    const Admission admission = inspected(shapes::moebius_strip(20), repair);
    EXPECT_THAT(counts(admission),
                ElementsAre(std::pair(FaultKind::InconsistentOrientation, 1), std::pair(FaultKind::OpenEdge, 40)));
  }
}

TEST(Admission, FindsOpenEdgesAndKnowsThatNoWeldClosesAHole) {
  const Admission admission = inspected(shapes::without_face(shapes::cube(), FaceId(5)));
  EXPECT_THAT(counts(admission), ElementsAre(std::pair(FaultKind::OpenEdge, 3)));
  EXPECT_EQ(admission.n_open_edges, 3u);
  EXPECT_EQ(admission.closing_tolerance, 0.0);
  EXPECT_THAT(admission.faults.front().advice, HasSubstr("Close the hole"));
}

/// The sphere cut along its equator, its upper half moved up by `width`.
mesh::SurfaceMesh cracked_sphere(double width) {
  mesh::SurfaceMesh soup = shapes::as_soup(shapes::sphere(4));
  for (const FaceId f : soup.faces.ids()) {
    double z = 0;
    for (const VertexId v : soup.faces[f]) z += soup.points[v].z();
    if (z < 0) continue;
    for (const VertexId v : soup.faces[f]) soup.points[v] += Vec3(0, 0, width);
  }
  return weld(soup, 0);
}

TEST(Admission, NamesTheWeldLengthThatClosesACrack) {
  for (const double width : {1e-2, 1e-5, 3e-13}) {
    const mesh::SurfaceMesh cracked = cracked_sphere(width);
    const Admission admission = inspected(cracked);
    EXPECT_EQ(admission.n_open_edges, 2u * 64u);
    EXPECT_GE(admission.closing_tolerance, width * (1 - 1e-3));
    EXPECT_LE(admission.closing_tolerance, width * 1.02);
    EXPECT_THAT(admission.faults.front().advice, HasSubstr("weld = "));
    EXPECT_TRUE(inspected(weld(cracked, admission.closing_tolerance)).is_usable());
  }
}

TEST(Admission, NamesAWeldLengthForASoupThatWasNotWelded) {
  const mesh::SurfaceMesh soup = shapes::as_soup(shapes::sphere(2));
  const Admission admission = inspected(soup);
  ASSERT_GT(admission.closing_tolerance, 0.0);
  EXPECT_TRUE(inspected(weld(soup, admission.closing_tolerance)).is_usable());
}

TEST(Admission, NamesNoWeldLengthThatWouldCollapseTriangles) {
  EXPECT_EQ(inspected(cracked_sphere(0.5)).closing_tolerance, 0.0);
}

TEST(Admission, FindsEveryPairOfIntersectingTriangles) {
  const mesh::SurfaceMesh a = shapes::cube(), b = shapes::sphere(2, 0.6, {0.3, 0.4, 0.5});
  std::size_t n_pairs = 0;
  for (const FaceId f : a.faces.ids()) {
    for (const FaceId g : b.faces.ids())
      n_pairs += predicates::triangles_intersect(a.triangle(f), b.triangle(g)) ? 1 : 0;
  }
  ASSERT_GT(n_pairs, 0u);
  const Admission admission = inspected(shapes::joined(a, b));
  EXPECT_THAT(counts(admission), ElementsAre(std::pair(FaultKind::SelfIntersection, n_pairs)));
}

TEST(Admission, FindsBodiesThatTouchWithoutSharingPoints) {
  const Admission admission =
      inspected(shapes::joined(shapes::cube(), shapes::translated(shapes::octahedron(), {1.5, 0, 0.1})));
  ASSERT_EQ(admission.faults.size(), 1u);
  EXPECT_EQ(admission.faults.front().kind, FaultKind::SelfIntersection);
}

TEST(Admission, FindsABodyThatIsInsideOutAndTurnsItSafely) {
  const mesh::SurfaceMesh sphere = shapes::sphere(2);
  const Admission refused = inspected(shapes::flipped(sphere));
  EXPECT_THAT(counts(refused), ElementsAre(std::pair(FaultKind::InsideOut, 1)));
  EXPECT_EQ(refused.faults.front().triangles.size(), sphere.faces.size());
  EXPECT_LT(refused.components[ComponentId(0)].volume, 0);
  const Admission repaired = inspected(shapes::flipped(sphere), Repair::Safe);
  EXPECT_TRUE(repaired.is_usable());
  EXPECT_EQ(repaired.repairs.size(), 1u);
  EXPECT_GT(volume(repaired, ComponentId(0)), 0);
}

/// Spheres of radius 1, 3 and 2, as a solid ball in a hollow ball: each as the boundary of what it bounds.
mesh::SurfaceMesh three_deep(bool hollow_is_inside_out = false) {
  const mesh::SurfaceMesh hollow = shapes::sphere(2, 2);
  return shapes::joined(shapes::joined(shapes::sphere(2, 1), shapes::sphere(2, 3)),
                        hollow_is_inside_out ? hollow : shapes::flipped(hollow));
}

TEST(Nesting, GivesConcentricSpheresTheirDepth) {
  const Admission admission = inspected(three_deep());
  ASSERT_EQ(admission.components.size(), 3u);
  EXPECT_EQ(admission.components[ComponentId(0)].depth, 2);
  EXPECT_EQ(admission.components[ComponentId(1)].depth, 0);
  EXPECT_EQ(admission.components[ComponentId(2)].depth, 1);
}

TEST(Nesting, WetsTheOutermostWallsOfAFluidOutside) {
  const mesh::SurfaceMesh spheres = three_deep();
  const Admission admission = inspected(spheres);
  ASSERT_TRUE(admission.is_usable());
  EXPECT_FALSE(admission.components[ComponentId(0)].is_wetted);
  EXPECT_TRUE(admission.components[ComponentId(1)].is_wetted);
  EXPECT_FALSE(admission.components[ComponentId(2)].is_wetted);
  EXPECT_EQ(admission.surface.faces, spheres.faces);
}

TEST(Nesting, WetsTheOuterWallAndTheBodiesInItOfAFluidInside) {
  const Admission admission = inspected(three_deep(), Repair::None, FluidSide::Inside);
  ASSERT_TRUE(admission.is_usable());
  EXPECT_FALSE(admission.components[ComponentId(0)].is_wetted);
  EXPECT_TRUE(admission.components[ComponentId(1)].is_wetted);
  EXPECT_TRUE(admission.components[ComponentId(2)].is_wetted);
  // Into the fluid between radius 2 and 3: inward on the outer wall, outward on the inner one. What is dry stays.
  EXPECT_GT(volume(admission, ComponentId(0)), 0);
  EXPECT_LT(volume(admission, ComponentId(1)), 0);
  EXPECT_GT(volume(admission, ComponentId(2)), 0);
}

TEST(Nesting, MindsTheOrientationOfWettedWallsOnly) {
  const mesh::SurfaceMesh spheres = three_deep(true);
  EXPECT_TRUE(inspected(spheres).is_usable());
  const Admission refused = inspected(spheres, Repair::None, FluidSide::Inside);
  EXPECT_THAT(counts(refused), ElementsAre(std::pair(FaultKind::InsideOut, 1)));
  EXPECT_EQ(refused.faults.front().triangles.front(), FaceId(256));
  const Admission repaired = inspected(spheres, Repair::Safe, FluidSide::Inside);
  ASSERT_TRUE(repaired.is_usable());
  EXPECT_GT(volume(repaired, ComponentId(2)), 0);
}

TEST(Nesting, SeesManyBodiesInALargeOne) {
  mesh::SurfaceMesh surface = shapes::cube(10);
  for (int i = 0; i < 27; ++i) {
    const Vec3 centre((i % 3 - 1) * 4, (i / 3 % 3 - 1) * 4, (i / 9 - 1) * 4);
    surface = shapes::joined(surface, shapes::flipped(shapes::cube(1, centre)));
  }
  const Admission admission = inspected(surface, Repair::None, FluidSide::Inside);
  ASSERT_TRUE(admission.is_usable());
  for (const ComponentId c : admission.components.ids()) {
    EXPECT_EQ(admission.components[c].depth, c.index() == 0 ? 0 : 1);
    EXPECT_TRUE(admission.components[c].is_wetted);
  }
}

TEST(Nesting, DoesNotTakeABodyInANotchForOneInside) {
  const mesh::SurfaceMesh notch = shapes::l_step();
  const Admission admission = inspected(shapes::joined(notch, shapes::cube(0.25, {1.5, 1.5, 0.5})));
  ASSERT_TRUE(admission.is_usable());
  EXPECT_EQ(admission.components[ComponentId(0)].depth, 0);
  EXPECT_EQ(admission.components[ComponentId(1)].depth, 0);
}

TEST(Nesting, IsFoundForSpecksFarFromTheOrigin) {
  // A few units in the last place across, and every ray along an axis meets an edge.
  const double unit = 0x1p-33;
  const mesh::SurfaceMesh shell = shapes::joined(shapes::scaled(shapes::octahedron(), 8 * unit),
                                                 shapes::flipped(shapes::scaled(shapes::octahedron(), 4 * unit)));
  const Admission admission = inspected(shapes::translated(shell, {0x1p+19, 0x1p+19, 0x1p+19}));
  ASSERT_TRUE(admission.is_usable());
  EXPECT_EQ(admission.components[ComponentId(0)].depth, 0);
  EXPECT_EQ(admission.components[ComponentId(1)].depth, 1);
}

TEST(Nesting, IsTheSameAtEveryScaleAndWithAxesPermuted) {
  for (const double scale : {0x1p-200, 0x1p-20, 1.0, 0x1p+200}) {
    const auto map = [&](const Vec3& p) { return Vec3(p.z(), p.x(), p.y()) * scale; };
    const Admission admission = inspected(shapes::mapped(three_deep(), map), Repair::None, FluidSide::Inside);
    ASSERT_TRUE(admission.is_usable()) << scale;
    EXPECT_EQ(admission.components[ComponentId(0)].depth, 2);
  }
}

TEST(Admission, TellsFaultsByPatch) {
  mesh::SurfaceMesh cube = shapes::cube();
  cube.patch_names.raw() = {"hull", "deck"};
  cube.face_patch[FaceId(2)] = cube.face_patch[FaceId(3)] = PatchId(1);
  cube = shapes::without_face(shapes::without_face(cube, FaceId(3)), FaceId(0));
  const Admission admission = inspected(cube);
  ASSERT_EQ(admission.faults.size(), 2u);
  EXPECT_EQ(admission.faults[0].patch, "hull");
  EXPECT_EQ(admission.faults[0].count, 5u);
  EXPECT_EQ(admission.faults[1].patch, "deck");
  EXPECT_EQ(admission.faults[1].count, 1u);
}

TEST(Admission, SaysWhatHowManyWhereAndWhatToDo) {
  mesh::SurfaceMesh cube = shapes::without_face(shapes::cube(), FaceId(5));
  shapes::add_face(cube, {4, 4, 5});
  try {
    admit(cube, {});
    FAIL() << "accepted";
  } catch (const SurfaceRejected& rejected) {
    const std::string message = rejected.what();
    EXPECT_THAT(message, HasSubstr("1 triangle without area near (-0.166667, -0.5, 0.5), triangle 11, patch 'wall'"));
    EXPECT_THAT(message, HasSubstr("3 open edges near ("));
    EXPECT_THAT(message, HasSubstr("Close the hole"));
    EXPECT_LE(std::count(message.begin(), message.end(), '\n'), 12);
    EXPECT_EQ(rejected.admission.faults.size(), 2u);
  }
}

TEST(Admission, KeepsTheMessageShortHoweverMuchIsWrong) {
  mesh::SurfaceMesh heap = shapes::joined(shapes::joined(shapes::cubes_sharing_an_edge(), shapes::pinched_vertex()),
                                          shapes::joined(shapes::moebius_strip(20), shapes::cube(0.3)));
  heap.points.push_back({kNan, 0, 0});
  shapes::add_face(heap, {0, 1, heap.points.size() - 1});
  shapes::add_face(heap, {0, 0, 1});
  shapes::add_face(heap, {0, 2, 3});
  const Admission admission = inspected(heap);
  EXPECT_GT(counts(admission).size(), 6u);
  try {
    admit(heap, {});
    FAIL() << "accepted";
  } catch (const SurfaceRejected& rejected) {
    const std::string message = rejected.what();
    EXPECT_LE(std::count(message.begin(), message.end(), '\n'), 12);
    EXPECT_THAT(message, HasSubstr("moreover"));
  }
}

TEST(Admission, RefusesASurfaceWithoutTriangles) {
  EXPECT_THAT(counts(inspected({})), ElementsAre(std::pair(FaultKind::Empty, 1)));
  const mesh::SurfaceMesh only_flat = shapes::make_surface({{0, 0, 0}}, {{0, 0, 0}});
  EXPECT_THAT(counts(inspected(only_flat, Repair::Safe)), ElementsAre(std::pair(FaultKind::Empty, 1)));
}

TEST(Admission, SurvivesGarbage) {
  constexpr std::size_t n = 10000;
  const auto garbage = [](auto&& point) {
    std::vector<Vec3> points;
    std::vector<shapes::Corners> faces;
    for (std::size_t i = 0; i < n; ++i) points.push_back(point(i));
    for (std::size_t i = 0; i < n; ++i) faces.push_back({i, (i * 7919 + 13) % n, (i * 104729 + 7) % n});
    return shapes::make_surface(points, faces);
  };
  const auto same = garbage([](std::size_t) { return Vec3(1, 2, 3); });
  const auto undefined = garbage([](std::size_t) { return Vec3(kNan, kNan, kNan); });
  const auto scattered = garbage([](std::size_t i) {
    const double t = static_cast<double>(i);
    return Vec3(std::sin(t * 12.9898), std::sin(t * 78.233), std::sin(t * 37.719));
  });
  for (const mesh::SurfaceMesh& surface : {same, undefined, scattered, weld(same, 0), weld(scattered, 0.5)}) {
    for (const Repair repair : {Repair::None, Repair::Safe}) {
      for (const FluidSide fluid : {FluidSide::Outside, FluidSide::Inside}) {
        EXPECT_FALSE(inspected(surface, repair, fluid).is_usable());
      }
    }
  }
}

TEST(Admission, SurvivesAStarOfManyTrianglesRoundOneEdge) {
  std::vector<Vec3> points = {{0, 0, 0}, {0, 0, 1}};
  std::vector<shapes::Corners> faces;
  for (std::size_t i = 0; i < 2000; ++i) {
    points.emplace_back(std::cos(0.003 * static_cast<double>(i)), std::sin(0.003 * static_cast<double>(i)), 0.5);
    faces.push_back({0, 1, 2 + i});
  }
  const Admission admission = inspected(shapes::make_surface(points, faces));
  EXPECT_THAT(counts(admission),
              ElementsAre(std::pair(FaultKind::NonManifoldEdge, 1), std::pair(FaultKind::OpenEdge, 4000)));
}

TEST(FaultName, IsThatOfTheJson) {
  EXPECT_EQ(fault_name(FaultKind::NotFinite), "not-finite");
  EXPECT_EQ(fault_name(FaultKind::OutOfRange), "out-of-range");
  EXPECT_EQ(fault_name(FaultKind::DegenerateTriangle), "degenerate-triangle");
  EXPECT_EQ(fault_name(FaultKind::DuplicateTriangle), "duplicate-triangle");
  EXPECT_EQ(fault_name(FaultKind::NonManifoldEdge), "non-manifold-edge");
  EXPECT_EQ(fault_name(FaultKind::NonManifoldVertex), "non-manifold-vertex");
  EXPECT_EQ(fault_name(FaultKind::InconsistentOrientation), "inconsistent-orientation");
  EXPECT_EQ(fault_name(FaultKind::OpenEdge), "open-edge");
  EXPECT_EQ(fault_name(FaultKind::SelfIntersection), "self-intersection");
  EXPECT_EQ(fault_name(FaultKind::InsideOut), "inside-out");
  EXPECT_EQ(fault_name(FaultKind::Empty), "empty");
}

}  // namespace
}  // namespace nearwall::surface
