#pragma once

#include <memory>
#include <utility>

#include "nearwall/io/whole_mesh.h"
#include "nearwall/mesh/volume_neighbours.h"
#include "nearwall/mesh/volume_source.h"
#include "tests/support/volume_meshes.h"

/// Meshes with all that writers of solver formats read.
namespace nearwall::whole_meshes_for_tests {

using mesh::Boundary;
using mesh::BoundaryPatch;
using mesh::BoundaryType;
using mesh::CellType;
using mesh::VolumeMesh;

/// A mesh in memory, with its boundary and its neighbours.
class Stored {
 public:
  Stored(VolumeMesh mesh, Boundary boundary)
      : mesh_(std::make_unique<VolumeMesh>(std::move(mesh))),
        boundary_(std::make_unique<Boundary>(std::move(boundary))) {
    mesh::fit_boundary(*mesh_, *boundary_);
    source_ = std::make_unique<mesh::VolumeSource>(*mesh_);
    neighbours_ = std::make_unique<mesh::VolumeNeighbours>(*mesh_, *boundary_);
  }
  const VolumeMesh& mesh() const { return *mesh_; }
  const Boundary& boundary() const { return *boundary_; }
  io::WholeMesh whole() const { return {*source_, *boundary_, *neighbours_, "test"}; }

 private:
  std::unique_ptr<VolumeMesh> mesh_;
  std::unique_ptr<Boundary> boundary_;
  std::unique_ptr<mesh::VolumeSource> source_;
  std::unique_ptr<mesh::VolumeNeighbours> neighbours_;
};

/// Blocks of hexahedra, wedges, tetrahedra and pyramids beside each other that share nothing, coordinates without short
/// decimals; the lower half of each of the first three is layers. Patches: what lies at z = 0, at the top, the sides.
inline Stored blocks_of_all_types(std::uint32_t n) {
  using namespace volume_meshes_for_tests;
  const auto moved = [](VolumeMesh mesh, double x) {
    return mapped(std::move(mesh), [x](const Vec3& p) { return p + Vec3(x, 0, 0); });
  };
  VolumeMesh all = joined(block(n, as_hexahedron()), moved(block(n, as_wedges()), 2));
  all = joined(joined(std::move(all), moved(block(n, as_tetrahedra()), 4)), moved(six_pyramids(), 6));
  for (std::size_t c = 0; c < all.n_cells(); ++c) {
    double z = 0;
    for (const std::uint32_t node : all.nodes_of(c)) z += all.points[node].z();
    const bool is_low = all.type[c] != CellType::Pyramid && z < 0.5 * mesh::size_of(all.type[c]);
    all.layer.push_back(is_low ? 1 : 0);
  }
  Boundary boundary;
  mesh::fit_boundary(all, boundary);
  boundary.patches = {};
  const PatchId wall = boundary.patches.push_back({"wall \"one\"", BoundaryType::Wall});
  const PatchId top = boundary.patches.push_back({"top", BoundaryType::FarField});
  boundary.patches.push_back({"no faces", BoundaryType::Other});
  const PatchId sides = boundary.patches.push_back({"sides", BoundaryType::Symmetry});
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    double low = 1, high = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(mesh::size_of(boundary.faces[f])); ++k) {
      const double z = all.points[boundary.faces[f][k]].z();
      low = std::min(low, z), high = std::max(high, z);
    }
    boundary.patch[f] = high == 0 ? wall : low == 1 ? top : sides;
  }
  all = mapped(std::move(all), [](const Vec3& p) { return Vec3(p.x() / 3, p.y() / 7, p.z() * 1e-5 / 11); });
  return {std::move(all), std::move(boundary)};
}

}  // namespace nearwall::whole_meshes_for_tests
