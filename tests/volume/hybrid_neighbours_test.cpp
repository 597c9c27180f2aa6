#include "nearwall/volume/hybrid_neighbours.h"

#include <set>

#include <gtest/gtest.h>

#include "nearwall/mesh/volume_neighbours.h"
#include "nearwall/mesh/volume_source.h"
#include "tests/support/gallery.h"
#include "tests/support/growing.h"
#include "tests/volume/domains.h"

namespace nearwall::volume {
namespace {

using namespace domains_for_tests;
using volume_meshes_for_tests::read;

IdVector<PatchId, mesh::BoundaryPatch> numbered_patches(std::size_t n) {
  IdVector<PatchId, mesh::BoundaryPatch> patches;
  for (std::size_t i = 0; i < n; ++i) patches.push_back({std::to_string(i), mesh::BoundaryType::Other});
  return patches;
}

/// The boundary lists each face of one cell alone, seen from outside, and neighbours are those of a mesh of which
/// nothing but nodes is known.
void expect_neighbours(const mesh::MeshSource& source, const mesh::Boundary& boundary,
                       const HybridNeighbours& neighbours) {
  const mesh::VolumeMesh mesh = read(source);
  mesh::Boundary fitted = boundary;
  const mesh::BoundaryChanges changes = mesh::fit_boundary(mesh, fitted);
  EXPECT_EQ(changes.n_added, 0u);
  EXPECT_EQ(changes.n_dropped, 0u);
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    // Neither turned nor another.
    const std::set<NodeIndex> nodes(boundary.faces[f].begin(), boundary.faces[f].end());
    const auto first = std::find(fitted.faces[f].begin(), fitted.faces[f].end(), boundary.faces[f][0]);
    ASSERT_EQ(nodes, std::set<NodeIndex>(fitted.faces[f].begin(), fitted.faces[f].end()));
    const auto place = static_cast<std::size_t>(first - fitted.faces[f].begin());
    const auto n = static_cast<std::size_t>(mesh::size_of(fitted.faces[f]));
    EXPECT_EQ(fitted.faces[f][(place + 1) % n], boundary.faces[f][1]);
  }
  const mesh::VolumeNeighbours expected(mesh, boundary);
  mesh::CellBatch cells;
  mesh::NeighbourBatch found, all;
  for (std::size_t b = 0; b < source.n_cell_batches(); ++b) {
    source.read_cells(b, cells);
    neighbours.read_neighbours(b, cells, found);
    expected.read_neighbours(b, cells, all);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      for (std::size_t f = 0; f < mesh::cell_faces(cells.type[c]).size(); ++f) ASSERT_EQ(found[c][f], all[c][f]);
    }
  }
}

class NeighboursOfDomains : public testing::TestWithParam<OpenShape> {};

TEST_P(NeighboursOfDomains, AreThoseOfItsCells) {
  const Domain& d = domain_of(GetParam());
  std::size_t n_patches = d.wall.surface().patch_names.size();
  for (const PatchId patch : d.boundary.patch) n_patches = std::max<std::size_t>(n_patches, patch.index() + 1u);
  const mesh::Boundary boundary = mesh_boundary(d.boundary, numbered_patches(n_patches));
  const FilledRest filled{d.rest, d.fill, d.hybrid};
  expect_neighbours(d.hybrid, boundary, HybridNeighbours(d.layers, boundary, &filled));
}

TEST_P(NeighboursOfDomains, AreThoseOfTheLayersAlone) {
  const Domain& d = domain_of(GetParam());
  const PatchId front(d.wall.surface().patch_names.size() + d.wall.planes().planes.size());
  const DomainBoundary faces = layers_boundary(
      d.layers, d.wall.certified_wall(), front,
      [&](mesh::PlaneIndex p, const Vec3&) { return PatchId(d.wall.surface().patch_names.size() + p); });
  const mesh::Boundary boundary = mesh_boundary(faces, numbered_patches(front.index() + std::size_t{1}));
  expect_neighbours(d.source, boundary, HybridNeighbours(d.layers, boundary, nullptr));
}

INSTANTIATE_TEST_SUITE_P(All, NeighboursOfDomains, testing::ValuesIn(shapes_with_planes()),
                         [](const auto& instance) { return instance.param.name; });

/// Fans, corners, gaps, stairs: layers of every kind.
class NeighboursOfTheGallery : public testing::TestWithParam<gallery::Shape> {};

TEST_P(NeighboursOfTheGallery, AreThoseOfTheLayersAlone) {
  const mesh::SurfaceMesh surface = gallery::into_the_fluid(GetParam());
  const growing_for_tests::TestWall wall(surface, GetParam().fluid_is_inside);
  const double thickness = 0.05 * geometry::bounding_box(surface.points.raw()).diagonal();
  const auto growth = layers::grow(
      wall.wall(), growing_for_tests::options_for(surface, growing_for_tests::geometric(thickness, 1.2, 5)));
  const mesh::LayerMesh layers(growth.front, growth.lines);
  const mesh::LayerSource source(layers, surface.face_patch, surface.points.raw());
  const PatchId front(surface.patch_names.size());
  const DomainBoundary faces =
      layers_boundary(layers, wall.certified_wall(), front, [](mesh::PlaneIndex, const Vec3&) { return PatchId(0); });
  const mesh::Boundary boundary = mesh_boundary(faces, numbered_patches(front.index() + std::size_t{1}));
  expect_neighbours(source, boundary, HybridNeighbours(layers, boundary, nullptr));
}

INSTANTIATE_TEST_SUITE_P(Gallery, NeighboursOfTheGallery, testing::ValuesIn(gallery::shapes()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace nearwall::volume
