#include "nearwall/certify/mesh_certificate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "tests/support/volume_meshes.h"

// Each point of the certificate of meshes in memory, with what breaks it and what just does not.

namespace nearwall::certify {
namespace {

using namespace volume_meshes_for_tests;
using predicates::Positivity;

struct Blocks : testing::TestWithParam<std::pair<const char*, VolumeMesh (*)()>> {};

TEST_P(Blocks, AreValidAndCloseToRounding) {
  const VolumeMesh mesh = GetParam().second();
  const MeshCertificate c = certify_mesh(mesh);
  EXPECT_TRUE(c.is_valid());
  EXPECT_EQ(c.n_cells(), mesh.n_cells());
  EXPECT_NEAR(c.cells_volume, 1, 1e-14);
  EXPECT_NEAR(c.enclosed_volume, 1, 1e-14);
  EXPECT_LT(c.closure().value(), 1e-14);
}

TEST_P(Blocks, AreValidUnderAnyLinearMapThatKeepsOrientation) {
  // Boundary quads are then planar up to rounding: some exactly, most not.
  const VolumeMesh mesh = mapped(GetParam().second(), [](const Vec3& p) {
    return Vec3(0.3 * p.x() - 1.1 * p.y() + 7, 0.7 * p.x() + 0.1 * p.y() + 0.2 * p.z(), 1e-3 * p.z() - 3);
  });
  const MeshCertificate c = certify_mesh(mesh);
  EXPECT_TRUE(c.is_valid());
  EXPECT_TRUE(c.intersections->undecided.empty());
}

TEST_P(Blocks, AreNotValidInAMirror) {
  const VolumeMesh mesh = mapped(GetParam().second(), [](const Vec3& p) { return Vec3(-p.x(), p.y(), p.z()); });
  const MeshCertificate c = certify_mesh(mesh);
  EXPECT_EQ(c.n_not_positive(), mesh.n_cells());
  EXPECT_FALSE(c.is_valid());
}

TEST_P(Blocks, AreNotValidWithACellTwice) {
  VolumeMesh mesh = GetParam().second();
  const auto nodes = mesh.nodes_of(0);
  add_cell(mesh, mesh.type[0], {nodes.begin(), nodes.end()});
  const MeshCertificate c = certify_mesh(mesh);
  EXPECT_EQ(c.n_not_positive(), 0u);
  EXPECT_EQ(c.faces.nonconforming.size(), mesh::cell_faces(mesh.type[0]).size());
  EXPECT_FALSE(c.is_valid());
  EXPECT_FALSE(c.closure().has_value());
}

TEST_P(Blocks, AreNotValidTwiceOverInTheSamePlace) {
  const VolumeMesh once = GetParam().second();
  const MeshCertificate c = certify_mesh(joined(once, once));
  EXPECT_TRUE(c.cells.offenders.empty());
  EXPECT_TRUE(c.faces.nonconforming.empty());
  EXPECT_FALSE(c.intersections->meeting.empty());
  EXPECT_GT(c.n_coincident_points, 0u);
  EXPECT_FALSE(c.is_valid());
}

TEST_P(Blocks, AreNotValidIfTheyOverlapInPart) {
  const VolumeMesh once = GetParam().second();
  const VolumeMesh moved = mapped(once, [](const Vec3& p) { return p + Vec3(0.37, 0.21, 0.11); });
  const MeshCertificate c = certify_mesh(joined(once, moved));
  EXPECT_FALSE(c.intersections->meeting.empty());
  EXPECT_EQ(c.n_coincident_points, 0u);
  EXPECT_FALSE(c.is_valid());
}

TEST_P(Blocks, AreValidSideBySide) {
  const VolumeMesh once = GetParam().second();
  EXPECT_TRUE(certify_mesh(joined(once, mapped(once, [](const Vec3& p) { return p + Vec3(1.01, 0, 0); }))).is_valid());
}

TEST_P(Blocks, AreNotValidIfOneHasSwallowedTheOther) {
  const VolumeMesh once = GetParam().second();
  const VolumeMesh small = mapped(once, [](const Vec3& p) { return p * 0.01 + Vec3(0.41, 0.22, 0.83); });
  const MeshCertificate c = certify_mesh(joined(once, small));
  EXPECT_TRUE(c.cells.offenders.empty());
  EXPECT_TRUE(c.intersections->meeting.empty());
  ASSERT_EQ(c.covered_twice.value().size(), 1u);
  EXPECT_GE(c.covered_twice->front().cell(), once.n_cells()) << "behind the small one's boundary";
  EXPECT_FALSE(c.is_valid());
}

TEST_P(Blocks, AreNotValidIfNoPointsWereMadeOne) {
  const VolumeMesh mesh = GetParam().second();
  VolumeMesh apart;
  for (std::size_t c = 0; c < mesh.n_cells(); ++c) {
    std::vector<std::uint32_t> nodes;
    for (const std::uint32_t node : mesh.nodes_of(c)) {
      nodes.push_back(static_cast<std::uint32_t>(apart.points.size()));
      apart.points.push_back(mesh.points[node]);
    }
    add_cell(apart, mesh.type[c], nodes);
  }
  const MeshCertificate c = certify_mesh(apart);
  EXPECT_EQ(c.n_coincident_points, apart.points.size() - mesh.points.size());
  EXPECT_EQ(c.is_valid(), mesh.n_cells() == 1) << "one cell has no other to be joined to";
  EXPECT_EQ(c.intersections->meeting.empty(), mesh.n_cells() == 1);
  EXPECT_TRUE(certify_mesh(merged(apart)).is_valid());
}

INSTANTIATE_TEST_SUITE_P(Mesh, Blocks,
                         testing::Values(std::pair{"hexahedron", +[] { return block(1, as_hexahedron()); }},
                                         std::pair{"hexahedra", +[] { return block(3, as_hexahedron()); }},
                                         std::pair{"wedges", +[] { return block(3, as_wedges()); }},
                                         std::pair{"tetrahedra", +[] { return block(3, as_tetrahedra()); }},
                                         std::pair{"five_tetrahedra", +[] { return five_tetrahedra(); }},
                                         std::pair{"pyramids", +[] { return six_pyramids(); }}),
                         [](const auto& block) { return block.param.first; });

TEST(MeshCertificate, RefusesAMeshWithoutCells) {
  EXPECT_THROW(certify_mesh(VolumeMesh{}), InputError);
  EXPECT_THROW(certify_mesh(block(1, {})), InputError);
}

TEST(MeshCertificate, RefusesNodesThatThereAreNot) {
  VolumeMesh mesh = block(1, as_hexahedron());
  mesh.nodes[3] = 8;
  EXPECT_THROW(certify_mesh(mesh), InputError);
}

TEST(MeshCertificate, NamesTheCellsThatAreNotPositiveByType) {
  VolumeMesh mesh = joined(block(2, as_hexahedron()), block(2, as_wedges()));
  std::swap(mesh.nodes[8 * 5 + 0], mesh.nodes[8 * 5 + 1]);
  const std::size_t wedge = 8 + 3;
  std::swap(mesh.nodes[mesh.first_node[wedge]], mesh.nodes[mesh.first_node[wedge] + 1]);
  const CellVerdicts v = cell_verdicts(mesh);
  EXPECT_EQ(v.count, (std::array<std::uint64_t, 4>{0, 0, 16, 8}));
  EXPECT_EQ(v.not_positive, (std::array<std::uint64_t, 4>{0, 0, 1, 1}));
  ASSERT_EQ(v.offenders.size(), 2u);
  EXPECT_EQ(v.offenders[0].cell, 5u);
  EXPECT_EQ(v.offenders[1].cell, wedge);
  EXPECT_FALSE(v.offenders[0].has_repeated_node);
}

TEST(MeshCertificate, CountsCellsThatAreNotFiniteAsNotPositive) {
  for (const VolumeMesh& good : {block(2, as_hexahedron()), block(2, as_tetrahedra())}) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      VolumeMesh mesh = good;
      mesh.points[block_node(2, 1, 1, 1)] = Vec3(bad, 0, 0);
      const MeshCertificate inner = certify_mesh(mesh);
      EXPECT_GT(inner.n_not_positive(), 0u);
      EXPECT_FALSE(inner.is_valid());
      mesh.points[0] = Vec3(0, bad, 0);
      const MeshCertificate outer = certify_mesh(mesh);
      EXPECT_FALSE(outer.intersections.has_value());
      EXPECT_FALSE(outer.is_valid());
    }
  }
}

TEST(MeshCertificate, DoesNotCallAHexahedronValidThatStaysUndecided) {
  // Its top is the bottom times −2: det J = (1 − 3 w)², zero where no cut comes.
  VolumeMesh mesh = block(1, as_hexahedron());
  for (std::size_t i = 4; i < 8; ++i) mesh.points[i] = Vec3(-2 * mesh.points[i].x(), -2 * mesh.points[i].y(), 1);
  const MeshCertificate c = certify_mesh(mesh);
  EXPECT_EQ(c.n_not_positive(), 0u);
  EXPECT_EQ(c.cells.undecided, (std::array<std::uint64_t, 4>{0, 0, 0, 1}));
  EXPECT_EQ(c.cells.offenders.at(0).verdict, Positivity::Undecided);
  EXPECT_FALSE(c.is_valid());
}

TEST(MeshCertificate, FindsFacesOfThreeCells) {
  // Three tetrahedra over one triangle: two of them on one side.
  VolumeMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 1}, {0.3, 0.3, 2}, {0.2, 0.2, -1}};
  add_cell(mesh, CellType::Tetrahedron, {0, 1, 2, 3});
  add_cell(mesh, CellType::Tetrahedron, {0, 1, 2, 4});
  add_cell(mesh, CellType::Tetrahedron, {0, 2, 1, 5});
  const MeshCertificate c = certify_mesh(mesh);
  EXPECT_EQ(c.n_not_positive(), 0u);
  ASSERT_EQ(c.faces.nonconforming.size(), 1u);
  EXPECT_EQ(c.faces.nonconforming[0].fault, FaceFault::ManyCells);
  EXPECT_FALSE(c.covered_twice.has_value());
  EXPECT_FALSE(c.is_valid());
}

TEST(MeshCertificate, FindsFacesThatTwoCellsSeeFromTheSameSide) {
  VolumeMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 1}, {0.3, 0.3, 2}};
  add_cell(mesh, CellType::Tetrahedron, {0, 1, 2, 3});
  add_cell(mesh, CellType::Tetrahedron, {0, 1, 2, 4});
  const MeshCertificate c = certify_mesh(mesh);
  ASSERT_EQ(c.faces.nonconforming.size(), 1u);
  EXPECT_EQ(c.faces.nonconforming[0].fault, FaceFault::SameSide);
  EXPECT_FALSE(c.is_valid());
}

TEST(MeshCertificate, FindsAQuadOnTwoTriangles) {
  // A cube of one hexahedron with a pyramid's worth of two tetrahedra on its top.
  for (const double lift : {0.0, 0.05}) {
    VolumeMesh mesh = block(1, as_hexahedron());
    mesh.points.push_back(Vec3(0.5, 0.5, 2));
    mesh.points[block_node(1, 1, 1, 1)] += Vec3(0, 0, lift);  // then the quad is warped
    const auto c = cube_nodes(1, 0, 0, 0);
    add_cell(mesh, CellType::Tetrahedron, {c[4], c[5], c[6], 8});
    add_cell(mesh, CellType::Tetrahedron, {c[4], c[6], c[7], 8});
    const MeshCertificate certificate = certify_mesh(mesh);
    EXPECT_EQ(certificate.n_not_positive(), 0u);
    ASSERT_EQ(certificate.faces.nonconforming.size(), 1u);
    EXPECT_EQ(certificate.faces.nonconforming[0].fault, FaceFault::QuadOnTriangles);
    EXPECT_EQ(certificate.faces.nonconforming[0].face.cell(), 0u);
    EXPECT_FALSE(certificate.is_valid());
  }
  // One pyramid in their place is right.
  VolumeMesh mesh = block(1, as_hexahedron());
  mesh.points.push_back(Vec3(0.5, 0.5, 2));
  const auto c = cube_nodes(1, 0, 0, 0);
  add_cell(mesh, CellType::Pyramid, {c[4], c[5], c[6], c[7], 8});
  EXPECT_TRUE(certify_mesh(mesh).is_valid());
}

TEST(MeshCertificate, FindsHangingNodes) {
  // Four small cubes beside a large one: all nodes of the large face are there, and five more.
  const VolumeMesh large = mapped(block(1, as_hexahedron()), [](const Vec3& p) { return p - Vec3(1, 0, 0); });
  const MeshCertificate c = certify_mesh(merged(joined(large, block(2, as_hexahedron()))));
  EXPECT_FALSE(c.intersections->meeting.empty());
  EXPECT_FALSE(c.is_valid());
}

TEST(MeshCertificate, FindsCollapsedCells) {
  VolumeMesh mesh = block(1, as_hexahedron());
  mesh.nodes[6] = mesh.nodes[7];  // a wedge and a bit, written as a hexahedron
  const MeshCertificate c = certify_mesh(mesh);
  ASSERT_EQ(c.cells.offenders.size(), 1u);
  EXPECT_TRUE(c.cells.offenders[0].has_repeated_node);
  EXPECT_EQ(c.faces.nonconforming.size(), 2u);
  EXPECT_EQ(c.faces.nonconforming[0].fault, FaceFault::RepeatedNode);
  EXPECT_FALSE(c.is_valid());
}

TEST(MeshCertificate, AcceptsCellsThatShareAnEdgeOrACornerOnly) {
  for (const Cells* cells : {&as_hexahedron(), &as_wedges(), &as_tetrahedra()}) {
    const VolumeMesh cube = block(1, *cells);
    for (const Vec3& by : {Vec3(1, 1, 0), Vec3(1, 1, 1)}) {
      const VolumeMesh both = joined(cube, mapped(cube, [&](const Vec3& p) { return p + by; }));
      EXPECT_TRUE(certify_mesh(merged(both)).is_valid());
      // The same with points of their own: the boundary meets itself.
      const MeshCertificate apart = certify_mesh(both);
      EXPECT_FALSE(apart.is_valid());
      EXPECT_GT(apart.n_coincident_points, 0u);
    }
  }
}

TEST(MeshCertificate, AcceptsARingOfCubesThatClosesAtAnEdge) {
  // Boundary edges with four faces, inside which a hole goes through.
  VolumeMesh block3 = block(3, as_hexahedron());
  VolumeMesh mesh;
  mesh.points = block3.points;
  for (const auto& [i, j] : std::vector<std::array<std::uint32_t, 2>>{{0, 0}, {1, 0}, {2, 1}, {1, 2}, {0, 1}}) {
    const auto nodes = cube_nodes(3, i, j, 0);
    add_cell(mesh, CellType::Hexahedron, {nodes.begin(), nodes.end()});
  }
  EXPECT_TRUE(certify_mesh(mesh).is_valid());
}

TEST(MeshCertificate, AcceptsBentBoundaries) {
  // Points moved at random by up to a fifth of an edge, and the block twisted: no quad is planar any more.
  for (const Cells* cells : {&as_hexahedron(), &as_wedges()}) {
    VolumeMesh mesh = block(8, *cells);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> move(-0.2 / 8, 0.2 / 8);
    for (Vec3& p : mesh.points) {
      const double x = p.x() + move(random), y = p.y() + move(random), z = p.z() + move(random);
      p = Vec3(x * std::cos(z) - y * std::sin(z), x * std::sin(z) + y * std::cos(z), z);
    }
    const MeshCertificate c = certify_mesh(mesh);
    EXPECT_TRUE(c.is_valid());
    EXPECT_TRUE(c.cells.offenders.empty());
    EXPECT_TRUE(c.intersections->undecided.empty());
    EXPECT_LT(c.closure().value(), 1e-14);
  }
}

TEST(MeshCertificate, AcceptsALayerThinnerThanItsQuadsAreBent) {
  // One hexahedron between z = x y and the same a little above.
  const auto certify_layer = [](double thickness) {
    VolumeMesh mesh = block(1, as_hexahedron());
    for (Vec3& p : mesh.points) p = Vec3(p.x(), p.y(), p.x() * p.y() + thickness * p.z());
    return certify_mesh(mesh);
  };
  EXPECT_TRUE(certify_layer(0.1).is_valid());
  EXPECT_TRUE(certify_layer(1e-3).is_valid());
  // As thin as that it is not called valid without proof, nor said to meet itself.
  const MeshCertificate thin = certify_layer(1e-9);
  EXPECT_TRUE(thin.cells.offenders.empty());
  EXPECT_TRUE(thin.intersections->meeting.empty());
  EXPECT_EQ(thin.intersections->undecided.size(), 1u);
  EXPECT_FALSE(thin.is_valid());
}

TEST(MeshCertificate, TakesAHoleAsACavity) {
  // Its middle cell missing, a mesh is still a valid mesh, of less.
  for (const Cells* cells : {&as_hexahedron(), &as_wedges(), &as_tetrahedra()}) {
    const VolumeMesh mesh = block(3, *cells);
    const std::size_t middle = 13 * cells->size();
    const MeshCertificate c = certify_mesh(without_cell(mesh, middle));
    EXPECT_TRUE(c.is_valid());
    const double missing = mesh::cell_volume(mesh.type[middle], mesh.corners_of(middle));
    EXPECT_NEAR(c.enclosed_volume, 1 - missing, 1e-14);
  }
}

TEST(MeshCertificate, CountsTheCoversOfConcentricShells) {
  // Cubes hollowed out: the inner one's shell reaches to |x| = 3, the outer one's from 2.
  const auto shell = [](double inner, double outer) {
    const VolumeMesh cube = block(3, as_hexahedron());
    return mapped(without_cell(cube, 13), [&](const Vec3& p) {
      const auto coordinate = [&](double x) { return (x < 0.5 ? -1 : 1) * (std::abs(x - 0.5) > 0.3 ? outer : inner); };
      return Vec3(coordinate(p.x()), coordinate(p.y()), coordinate(p.z()));
    });
  };
  for (const double bend : {0.0, 0.03}) {  // bent, their quads are warped
    const auto certify = [&](const VolumeMesh& mesh) {
      return certify_mesh(mapped(mesh, [&](const Vec3& p) {
        return Vec3(p.x() + bend * p.y() * p.z(), p.y() + 0.5 * bend * p.z() * p.x(), p.z());
      }));
    };
    EXPECT_TRUE(certify(joined(shell(1, 2), shell(3, 4))).is_valid());
    const MeshCertificate twice = certify(joined(shell(1, 3), shell(2, 4)));
    EXPECT_TRUE(twice.cells.offenders.empty());
    EXPECT_TRUE(twice.intersections->meeting.empty());
    EXPECT_EQ(twice.covered_twice.value().size(), 2u) << "at 2 and at 3";
    EXPECT_LT(twice.closure().value(), 1e-14) << "volumes do not tell";
    EXPECT_FALSE(twice.is_valid());
  }
}

TEST(MeshCertificate, GivesTheSameAnswerOnAnyNumberOfThreads) {
  VolumeMesh mesh = block(12, as_wedges());
  for (std::size_t i = 0; i < mesh.points.size(); i += 7) mesh.points[i] += Vec3(0.1, 0, 0);
  std::array<MeshCertificate, 2> c;
  for (std::size_t k = 0; k < 2; ++k) {
    const ThreadLimit limit(static_cast<int>(3 * k + 1));
    c[k] = certify_mesh(mesh);
  }
  EXPECT_GT(c[0].n_not_positive(), 0u);
  EXPECT_EQ(c[0].cells_volume, c[1].cells_volume);
  EXPECT_EQ(c[0].enclosed_volume, c[1].enclosed_volume);
  EXPECT_EQ(c[0].faces.boundary, c[1].faces.boundary);
  EXPECT_EQ(c[0].intersections->meeting, c[1].intersections->meeting);
  EXPECT_EQ(c[0].intersections->undecided, c[1].intersections->undecided);
}

}  // namespace
}  // namespace nearwall::certify
