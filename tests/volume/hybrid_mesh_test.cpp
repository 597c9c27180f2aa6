// Layers and tetrahedra as one mesh, its boundary and its certificate.
#include "nearwall/volume/hybrid_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/certify/mesh_certificate.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/mesh/cell_faces.h"
#include "nearwall/volume/domain_boundary.h"
#include "nearwall/volume/fill_quality.h"
#include "tests/support/volume_meshes.h"
#include "tests/volume/domains.h"

namespace nearwall::volume {
namespace {

using namespace domains_for_tests;
using mesh::FaceNodes;
using volume_meshes_for_tests::read;

class WholeMesh : public testing::TestWithParam<OpenShape> {
 protected:
  const Domain& domain() const { return domain_of(GetParam()); }
};

TEST_P(WholeMesh, IsCertifiedByOneThatKnowsNothingOfItsMaking) {
  const mesh::VolumeMesh mesh = read(domain().hybrid);
  EXPECT_EQ(mesh.points.size(), domain().hybrid.n_points());
  EXPECT_EQ(mesh.n_cells(), domain().hybrid.n_cells());
  const auto by_type = domain().hybrid.n_cells_by_type();
  for (std::size_t type = 0; type < mesh::kNCellTypes; ++type) {
    EXPECT_EQ(std::count(mesh.type.begin(), mesh.type.end(), static_cast<mesh::CellType>(type)), by_type[type]);
  }
  const certify::MeshCertificate certificate = certify::certify_mesh(mesh);
  EXPECT_TRUE(certificate.is_valid());
  EXPECT_EQ(certificate.n_not_positive(), 0u);
  EXPECT_TRUE(certificate.closes());
  ASSERT_TRUE(certificate.closure());
  EXPECT_LT(*certificate.closure(), 1e-12);
}

/// Key of a face and the side it is seen from.
using SeenFace = std::pair<FaceNodes, bool>;

SeenFace seen(const FaceNodes& face) {
  const mesh::FaceKey key = mesh::key_of(face);
  return {key.nodes, key.is_turned};
}

TEST_P(WholeMesh, HasTheBoundaryThatItSays) {
  const mesh::VolumeMesh mesh = read(domain().hybrid);
  std::set<SeenFace> expected, found;
  for (const mesh::FaceName face : certify::conformity(mesh).boundary) expected.insert(seen(nodes_of(mesh, face)));
  const DomainBoundary& boundary = domain().boundary;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    FaceNodes nodes = boundary.faces[f];
    for (std::uint32_t& node : nodes) {
      if (node == mesh::kNoNode) continue;
      ASSERT_EQ(boundary.points[node], mesh.points[boundary.node[node]]);
      node = static_cast<std::uint32_t>(boundary.node[node]);
    }
    EXPECT_TRUE(found.insert(seen(nodes)).second) << "each face once";
  }
  EXPECT_EQ(found, expected);
}

TEST_P(WholeMesh, KeepsTheWallTriangleForTriangle) {
  const mesh::SurfaceMesh& wall = domain().wall.surface();
  const DomainBoundary& boundary = domain().boundary;
  ASSERT_GE(boundary.faces.size(), wall.faces.size());
  for (const FaceId f : wall.faces.ids()) {
    EXPECT_EQ(boundary.wall_face[f.index()], f);
    EXPECT_EQ(boundary.patch[f.index()], wall.face_patch[f]);
    EXPECT_EQ(boundary.plane[f.index()], mesh::kNoPlane);
    ASSERT_EQ(boundary.size_of(f.index()), 3);
    const auto& [a, b, c, none] = boundary.faces[f.index()];
    const auto triangle = wall.triangle(f);
    // Out of the domain, while the wall's normals look into it.
    EXPECT_EQ((std::array{boundary.points[a], boundary.points[c], boundary.points[b]}), triangle);
  }
  for (std::size_t f = wall.faces.size(); f < boundary.faces.size(); ++f) {
    EXPECT_NE(boundary.plane[f], mesh::kNoPlane);
    EXPECT_FALSE(boundary.wall_face[f].is_valid());
  }
}

TEST_P(WholeMesh, CoversItsPlanesOnce) {
  const Domain& d = domain();
  // The planes as they are before any layer.
  mesh::Lines lines = d.growth.lines;
  lines.windows.assign(lines.windows.size(), {});
  certify::FrontSurface bare = certify::front_surface(d.growth.front, lines);
  ASSERT_TRUE(certify::close_front(d.growth.front, d.wall.planes(), bare).empty());
  const std::size_t n_planes = d.wall.planes().planes.size();
  std::vector<double> expected(n_planes, 0), found(n_planes, 0);
  for (std::size_t i = 0; i < bare.rest_plane.size(); ++i) {
    const auto& [a, b, c] = bare.triangles[bare.face.size() + i];
    expected[bare.rest_plane[i]] += geometry::triangle_area(bare.points[a], bare.points[b], bare.points[c]);
  }
  std::size_t n_quads = 0;
  for (std::size_t f = 0; f < d.boundary.faces.size(); ++f) {
    if (d.boundary.plane[f] == mesh::kNoPlane) continue;
    found[d.boundary.plane[f]] += d.face_area(f);
    EXPECT_EQ(d.boundary.patch[f], d.wall.open().patch[d.boundary.plane[f]]);
    n_quads += d.boundary.size_of(f) == 4;
  }
  for (std::size_t p = 0; p < n_planes; ++p) EXPECT_NEAR(found[p], expected[p], 1e-12 * expected[p]);
  const bool is_landed_on = std::any_of(lines.windows.ids().begin(), lines.windows.ids().end(), [&](LineId line) {
    return d.growth.lines.windows[line].moves() && d.wall.planes().is_on_plane(d.growth.front.line_vertex[line]);
  });
  EXPECT_EQ(n_quads > 0, is_landed_on);
}

TEST_P(WholeMesh, ClosesToRounding) {
  const DomainCertificate certificate = domain().certificate();
  EXPECT_TRUE(certificate.is_valid());
  EXPECT_LT(certificate.closure(), 1e-12);
  EXPECT_EQ(certificate.n_side_faces, domain().boundary.faces.size() - domain().wall.surface().faces.size());
  // Sum of the cells by the mesh that is written.
  const mesh::VolumeMesh mesh = read(domain().hybrid);
  geometry::CompensatedSum sum;
  for (std::size_t c = 0; c < mesh.n_cells(); ++c) {
    const auto corners = mesh.corners_of(c);
    sum.add(mesh::cell_volume(mesh.type[c], std::span(corners).first(static_cast<std::size_t>(size_of(mesh.type[c])))));
  }
  EXPECT_NEAR(certificate.cells_volume, sum.value(), 1e-13 * sum.value());
}

INSTANTIATE_TEST_SUITE_P(All, WholeMesh, testing::ValuesIn(shapes_with_planes()),
                         [](const auto& instance) { return instance.param.name; });

TEST(CertifyDomain, CountsSidesThatAreTurnedOver) {
  const Domain d({"room", [] { return room(2); }, {"wall"}});
  const double layers_volume = certify::certify_layers(d.layers, d.wall.certified_wall()).cells_volume;
  ASSERT_EQ(certify_domain(d.boundary, &d.wall.planes(), layers_volume, d.fill).n_bad_side_faces, 0u);
  int n_tried = 0;
  for (std::size_t f = d.wall.surface().faces.size(); f < d.boundary.faces.size(); f += 3) {
    ++n_tried;
    DomainBoundary turned = d.boundary;
    std::swap(turned.faces[f][0], turned.faces[f][2]);
    EXPECT_EQ(certify_domain(turned, &d.wall.planes(), layers_volume, d.fill).n_bad_side_faces, 1u);
    if (d.boundary.size_of(f) == 3) continue;
    DomainBoundary crossed = d.boundary;
    std::swap(crossed.faces[f][0], crossed.faces[f][1]);
    EXPECT_EQ(certify_domain(crossed, &d.wall.planes(), layers_volume, d.fill).n_bad_side_faces, 1u);
  }
  EXPECT_GT(n_tried, 20);
}

TEST(CertifyDomain, SeesACellThatIsMissing) {
  const Domain d({"room", [] { return room(2); }, {"wall"}});
  const double layers_volume = certify::certify_layers(d.layers, d.wall.certified_wall()).cells_volume;
  Fill fill = d.fill;
  fill.tetrahedra.pop_back();
  EXPECT_GT(certify_domain(d.boundary, &d.wall.planes(), layers_volume, fill).closure(), 1e-9);
  EXPECT_GT(certify_domain(d.boundary, &d.wall.planes(), 0.999 * layers_volume, d.fill).closure(), 1e-9);
}

/// Faces on planes ask for their patch by their middle.
TEST(DomainBoundary, TakesPatchesFromWhatLiesThere) {
  const Domain d({"room", [] { return room(2); }, {"wall"}});
  const auto boundary = domain_boundary(
      d.layers, d.wall.certified_wall(), d.rest, d.hybrid,
      [](mesh::PlaneIndex p, const Vec3& middle) { return PatchId(10 * std::size_t{p} + (middle.z() > 0.5 ? 1 : 0)); });
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    if (boundary.plane[f] == mesh::kNoPlane) continue;
    double z = 0;
    for (int k = 0; k < boundary.size_of(f); ++k)
      z += boundary.points[boundary.faces[f][static_cast<std::size_t>(k)]].z();
    const bool is_high = z / boundary.size_of(f) > 0.5;
    EXPECT_EQ(boundary.patch[f], PatchId(10 * std::size_t{boundary.plane[f]} + (is_high ? 1 : 0)));
  }
}

TEST(HybridMesh, NumbersThePointsOfTheLayersAsTheyAre) {
  const Domain d({"room", [] { return room(3); }, {"wall"}});
  const mesh::VolumeMesh layers = read(d.source), whole = read(d.hybrid);
  ASSERT_GT(whole.points.size(), layers.points.size());
  EXPECT_TRUE(std::equal(layers.points.begin(), layers.points.end(), whole.points.begin()));
  EXPECT_TRUE(std::equal(layers.nodes.begin(), layers.nodes.end(), whole.nodes.begin()));
  mesh::CellBatch batch;
  std::size_t n_tetrahedra = 0;
  for (std::size_t b = 0; b < d.hybrid.n_cell_batches(); ++b) {
    d.hybrid.read_cells(b, batch);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (batch.first + i < d.source.n_cells()) continue;
      ++n_tetrahedra;
      EXPECT_EQ(batch.layer[i], 0);
      EXPECT_EQ(batch.column[i], -1);
      EXPECT_EQ(batch.patch[i], -1);
      for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(batch.corners[i][k], whole.points[batch.nodes[i][k]]);
    }
  }
  EXPECT_EQ(n_tetrahedra, d.fill.tetrahedra.size());
}

TEST(HybridMesh, IsTheSameAtAnyNumberOfThreads) {
  const auto all = [] {
    const Domain d({"quarter",
                    [] {
                      return cut_body("quarter-cylinder", {}, 0.2, {"symmetry-y", "symmetry-z"});
                    },
                    {"front", "side", "base"}});
    return std::pair(read(d.hybrid), d.boundary.faces);
  };
  const auto many = all();
  const ThreadLimit one(1);
  const auto single = all();
  EXPECT_EQ(many.first.points, single.first.points);
  EXPECT_EQ(many.first.nodes, single.first.nodes);
  EXPECT_EQ(many.second, single.second);
}

/// The unit cube in Kuhn's six tetrahedra: each has edges 1, √2 and √3, right angles and such of 45 and 60 degrees, and
/// the cube's sphere round it.
TEST(FillQuality, KnowsTheTetrahedraOfACube) {
  const growing_for_tests::TestWall wall(shapes_for_tests::flipped(shapes_for_tests::cube()), true);
  auto options = growing_for_tests::options_for(wall.surface(), {0.1});
  for (auto& schedule : options.schedules) schedule = {false, {}, layers::OnConflict::Auto, {}, {}, {}, false};
  const auto growth = layers::grow(wall.wall(), options);
  const mesh::LayerMesh layers(growth.front, growth.lines);
  const mesh::VolumeMesh cube = volume_meshes_for_tests::block(1, volume_meshes_for_tests::as_tetrahedra());
  Fill fill;
  fill.points = cube.points;
  for (std::size_t c = 0; c < cube.n_cells(); ++c) {
    const auto nodes = cube.nodes_of(c);
    fill.tetrahedra.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
  }
  RestBoundary rest;
  rest.surface.points = cube.points;
  for (const mesh::FaceName face : certify::conformity(cube).boundary) {
    const FaceNodes nodes = nodes_of(cube, face);
    rest.surface.triangles.push_back({nodes[0], nodes[1], nodes[2]});
  }
  const FillQuality quality = fill_quality(layers, rest, fill);
  EXPECT_EQ(quality.smallest_dihedral.count, 6u);
  EXPECT_NEAR(quality.smallest_dihedral.min, 45, 1e-9);
  EXPECT_NEAR(quality.smallest_dihedral.max, 45, 1e-9);
  EXPECT_NEAR(quality.radius_edge.min, std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(quality.radius_edge.max, std::sqrt(0.75), 1e-12);
  EXPECT_EQ(quality.size_ratio.count, 6u) << "all six go round one diagonal";
  EXPECT_NEAR(quality.size_ratio.max, 1, 1e-12);
  EXPECT_EQ(quality.interface_ratio.count, 0u) << "nothing moves";
}

/// Against a search of all tetrahedra for the one on each triangle.
TEST(FillQuality, ComparesTheLastLayerWithWhatStandsOnIt) {
  const Domain d({"room", [] { return room(2); }, {"wall"}});
  const FillQuality quality = fill_quality(d.layers, d.rest, d.fill);
  const double last = geometric(1, 1.2, 6).back() * 0.02 * std::sqrt(2.0);
  double least = std::numeric_limits<double>::infinity(), most = 0;
  std::size_t n = 0;
  for (std::size_t t = 0; t < d.rest.n_front; ++t) {
    const auto& [a, b, c] = d.rest.surface.triangles[t];
    if (d.rest.surface.points[a].z() > 0.5) continue;  // the ceiling has no layers
    ++n;
    for (const auto& corners : d.fill.tetrahedra) {
      const std::set<std::uint32_t> of(corners.begin(), corners.end());
      if (!of.contains(a) || !of.contains(b) || !of.contains(c)) continue;
      for (const std::uint32_t apex : of) {
        if (apex == a || apex == b || apex == c) continue;
        // The front is level.
        const double height = d.fill.points[apex].z() - d.fill.points[a].z();
        least = std::min(least, height / last);
        most = std::max(most, height / last);
      }
    }
  }
  EXPECT_EQ(quality.interface_ratio.count, n);
  EXPECT_NEAR(quality.interface_ratio.min, least, 1e-9 * least);
  EXPECT_NEAR(quality.interface_ratio.max, most, 1e-9 * most);
}

}  // namespace
}  // namespace nearwall::volume
