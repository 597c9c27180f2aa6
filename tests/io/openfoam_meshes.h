#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "nearwall/io/whole_mesh.h"
#include "nearwall/mesh/volume_neighbours.h"
#include "nearwall/mesh/volume_source.h"
#include "tests/io/mesh_for_tests.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/volume_meshes.h"

/// Meshes of the unit cube with patches and layers, for tests of formats that list faces.
namespace nearwall::io::openfoam_meshes {

using mesh::BoundaryType;
using mesh::CellType;

/// A mesh with all that its writers want of it.
struct FoamMesh {
  mesh::VolumeMesh volume;
  mesh::Boundary boundary;
  std::unique_ptr<MeshForTests> source;
  std::unique_ptr<mesh::VolumeNeighbours> neighbours;

  WholeMesh whole() const {
    for (std::size_t c = 0; c < volume.n_cells(); ++c) source->cells[c].layer = volume.layer[c];
    return {*source, boundary, *neighbours, "test"};
  }
};

/// Sides of the unit cube as patches, with names that are no words, in an order of faces that is not that of patches.
inline mesh::Boundary sides(const mesh::VolumeMesh& mesh) {
  mesh::Boundary boundary;
  boundary.patches.push_back({"rest", BoundaryType::Other});
  boundary.patches.push_back({"lower wall", BoundaryType::Wall});
  boundary.patches.push_back({"nothing", BoundaryType::Wall});
  boundary.patches.push_back({"mid/plane", BoundaryType::Symmetry});
  boundary.patches.push_back({"inlet", BoundaryType::Inlet});
  boundary.patches.push_back({"rear", BoundaryType::Outlet});
  boundary.patches.push_back({"far", BoundaryType::FarField});
  mesh::fit_boundary(mesh, boundary);
  const std::vector<std::pair<int, double>> planes = {{2, 0.0}, {1, 0.0}, {0, 0.0}, {0, 1.0}, {2, 1.0}};
  const std::vector<std::size_t> patches = {1, 3, 4, 5, 6};
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    boundary.patch[f] = PatchId(0);
    for (std::size_t i = planes.size(); i-- > 0;) {
      bool is_in_plane = true;
      for (std::size_t k = 0; k < static_cast<std::size_t>(mesh::size_of(boundary.faces[f])); ++k) {
        is_in_plane = is_in_plane && mesh.points[boundary.faces[f][k]][planes[i].first] == planes[i].second;
      }
      if (is_in_plane) boundary.patch[f] = PatchId(patches[i]);
    }
  }
  return boundary;
}

/// Every second cell is one of the layers.
inline FoamMesh finished(mesh::VolumeMesh volume) {
  FoamMesh mesh;
  mesh.volume = std::move(volume);
  // Numbers with all their digits.
  for (Vec3& p : mesh.volume.points) p = Vec3(p.x(), p.y() / 3.0, p.z());
  mesh.boundary = sides(mesh.volume);
  mesh.source = std::make_unique<MeshForTests>();
  mesh.source->points = mesh.volume.points;
  for (std::size_t c = 0; c < mesh.volume.n_cells(); ++c) {
    mesh.volume.layer.push_back(c % 2 == 0 ? 1 : 0);
    MeshForTests::Cell cell{mesh.volume.type[c], {}, mesh.volume.layer[c], -1, -1};
    const auto nodes = mesh.volume.nodes_of(c);
    std::copy(nodes.begin(), nodes.end(), cell.nodes.begin());
    mesh.source->cells.push_back(cell);
  }
  mesh.neighbours = std::make_unique<mesh::VolumeNeighbours>(mesh.volume, mesh.boundary);
  return mesh;
}

inline FoamMesh tetrahedra() {
  return finished(volume_meshes_for_tests::block(2, volume_meshes_for_tests::as_tetrahedra()));
}
inline FoamMesh wedges() { return finished(volume_meshes_for_tests::block(3, volume_meshes_for_tests::as_wedges())); }
inline FoamMesh hexahedra() {
  return finished(volume_meshes_for_tests::block(3, volume_meshes_for_tests::as_hexahedron()));
}
inline FoamMesh pyramids() { return finished(volume_meshes_for_tests::six_pyramids()); }
inline FoamMesh one_tetrahedron() {
  return finished(volume_meshes_for_tests::block(1, {{CellType::Tetrahedron, {0, 1, 3, 4}}}));
}

/// 27 small cubes: hexahedra; a row of them as wedges; one as six pyramids round its middle, of which the outermost is
/// two tetrahedra.
inline FoamMesh mixed() {
  namespace meshes = volume_meshes_for_tests;
  constexpr std::uint32_t kN = 3;
  mesh::VolumeMesh mesh = meshes::block(kN, {});
  const auto add = [&](const std::array<std::uint32_t, 8>& cube, const meshes::Cells& cells) {
    for (const auto& [type, places] : cells) {
      std::vector<std::uint32_t> nodes;
      for (const std::uint32_t place : places) nodes.push_back(cube[place]);
      meshes::add_cell(mesh, type, nodes);
    }
  };
  for (std::uint32_t k = 0; k < kN; ++k) {
    for (std::uint32_t j = 0; j < kN; ++j) {
      for (std::uint32_t i = 0; i < kN; ++i) {
        const auto cube = meshes::cube_nodes(kN, i, j, k);
        if (i == 2 && j == 1 && k == 1) {
          const auto tip = static_cast<std::uint32_t>(mesh.points.size());
          mesh.points.push_back((mesh.points[cube[0]] + mesh.points[cube[6]]) / 2.0);
          for (const auto& q : std::vector<std::array<std::size_t, 4>>{
                   {0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {2, 6, 7, 3}, {3, 7, 4, 0}}) {
            meshes::add_cell(mesh, CellType::Pyramid, {cube[q[0]], cube[q[1]], cube[q[2]], cube[q[3]], tip});
          }
          meshes::add_cell(mesh, CellType::Tetrahedron, {cube[1], cube[5], cube[6], tip});
          meshes::add_cell(mesh, CellType::Tetrahedron, {cube[1], cube[6], cube[2], tip});
        } else {
          add(cube, i == 0 && j == 0 ? meshes::as_wedges() : meshes::as_hexahedron());
        }
      }
    }
  }
  return finished(mesh);
}

inline const std::vector<std::pair<std::string, FoamMesh (*)()>> kMeshes = {
    {"Tetrahedra", tetrahedra}, {"Wedges", wedges},           {"Hexahedra", hexahedra},
    {"Pyramids", pyramids},     {"OneCell", one_tetrahedron}, {"Mixed", mixed}};

using FaceNodes = std::vector<NodeIndex>;

/// The cycle from its smallest node on; the direction stays.
inline FaceNodes from_smallest(FaceNodes nodes) {
  std::rotate(nodes.begin(), std::min_element(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// Faces of a cell in an order of their own: equal for the same cell with its nodes in another admissible order.
inline std::vector<FaceNodes> oriented_faces(const mesh::VolumeMesh& mesh, std::size_t cell) {
  std::vector<FaceNodes> faces;
  for (const mesh::CellFace& face : mesh::cell_faces(mesh.type[cell])) {
    FaceNodes nodes;
    for (std::size_t k = 0; k < face.size; ++k) nodes.push_back(mesh.nodes_of(cell)[face.corners[k]]);
    faces.push_back(from_smallest(nodes));
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Faces of the patches that have some, in their order, by names given.
inline std::map<std::string, std::vector<FaceNodes>> faces_by_name(const mesh::Boundary& boundary,
                                                                   const IdVector<PatchId, std::string>& names) {
  std::map<std::string, std::vector<FaceNodes>> faces;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    const mesh::BoundaryFace& face = boundary.faces[f];
    faces[names[boundary.patch[f]]].emplace_back(face.begin(), face.begin() + mesh::size_of(face));
  }
  return faces;
}

/// The files of a folder once more as CASE/constant/polyMesh in it. \returns CASE
inline std::filesystem::path as_case(const TemporaryFolder& folder) {
  namespace fs = std::filesystem;
  const fs::path copy = folder / "case";
  fs::create_directories(copy / "constant" / "polyMesh");
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    if (entry.is_regular_file()) fs::copy_file(entry.path(), copy / "constant" / "polyMesh" / entry.path().filename());
  }
  return copy;
}

}  // namespace nearwall::io::openfoam_meshes
