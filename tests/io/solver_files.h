#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "nearwall/core/errors.h"
#include "nearwall/io/volume_reader.h"
#include "nearwall/mesh/volume_neighbours.h"
#include "tests/io/mutator.h"
#include "tests/support/whole_meshes.h"

/// What tests of the readers and writers of solver formats share.
namespace nearwall::io {

using Parse = std::function<VolumeFile(std::string_view bytes, const std::string& file)>;

/// Cells as formats have them that list them by type: within a type those of the layers first.
inline std::vector<std::size_t> cells_by_type(const mesh::VolumeMesh& mesh) {
  std::vector<std::size_t> order(mesh.n_cells());
  for (std::size_t c = 0; c < order.size(); ++c) order[c] = c;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(mesh.type[a], mesh.layer[a] == 0) < std::pair(mesh.type[b], mesh.layer[b] == 0);
  });
  return order;
}

/// Points and cells bit for bit. \param order  cell of the mesh that each cell of the file is
inline void expect_same_cells(const mesh::VolumeMesh& found, const mesh::VolumeMesh& mesh,
                              const std::vector<std::size_t>& order) {
  EXPECT_EQ(found.points, mesh.points);
  ASSERT_EQ(found.n_cells(), mesh.n_cells());
  for (std::size_t c = 0; c < order.size(); ++c) {
    ASSERT_EQ(found.type[c], mesh.type[order[c]]);
    ASSERT_TRUE(std::ranges::equal(found.nodes_of(c), mesh.nodes_of(order[c]))) << "cell " << c;
  }
}

/// The faces of one patch in an order of their own.
inline std::vector<mesh::BoundaryFace> sorted_faces(const mesh::Boundary& boundary, PatchId patch) {
  std::vector<mesh::BoundaryFace> faces;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    if (boundary.patch[f] != patch) continue;
    mesh::BoundaryFace face = boundary.faces[f];
    std::rotate(face.begin(), std::min_element(face.begin(), face.begin() + mesh::size_of(face)),
                face.begin() + mesh::size_of(face));
    faces.push_back(face);
  }
  std::ranges::sort(faces);
  return faces;
}

/// The patches that have faces, in their order, with the same faces, also in direction.
/// \param names  that the file is to have, of all patches of the mesh
inline void expect_same_patches(const mesh::Boundary& found, const mesh::Boundary& boundary,
                                const std::vector<std::string>& names) {
  std::size_t next = 0;
  for (const PatchId patch : boundary.patches.ids()) {
    const auto faces = sorted_faces(boundary, patch);
    if (faces.empty()) continue;
    ASSERT_LT(next, found.patches.size());
    EXPECT_EQ(found.patches[PatchId(next)].name, names[patch.index()]);
    EXPECT_EQ(sorted_faces(found, PatchId(next)), faces) << names[patch.index()];
    ++next;
  }
  EXPECT_EQ(next, found.patches.size());
}

/// A boundary from a file whose faces look into the mesh, turned.
inline mesh::Boundary turned(mesh::Boundary boundary) {
  for (mesh::BoundaryFace& face : boundary.faces) std::reverse(face.begin(), face.begin() + mesh::size_of(face));
  return boundary;
}

/// Whether the bytes were read, and then to a mesh whose parts fit together.
inline bool is_read_or_refused(const Parse& parse, std::string_view bytes) {
  try {
    const VolumeFile file = parse(bytes, "file");
    EXPECT_EQ(file.mesh.first_node.size(), file.mesh.n_cells() + 1);
    EXPECT_EQ(file.mesh.first_node.back(), file.mesh.nodes.size());
    for (const std::uint32_t node : file.mesh.nodes) EXPECT_LT(node, file.mesh.points.size());
    EXPECT_EQ(file.boundary.patch.size(), file.boundary.faces.size());
    for (const mesh::BoundaryFace& face : file.boundary.faces) {
      for (std::size_t k = 0; k < static_cast<std::size_t>(mesh::size_of(face)); ++k) {
        EXPECT_LT(face[k], file.mesh.points.size());
      }
    }
    for (const PatchId patch : file.boundary.patch) EXPECT_LT(patch.index(), file.boundary.patches.size());
    for (const Vec3& p : file.mesh.points) EXPECT_TRUE(is_finite(p));
    return true;
  } catch (const GeometryError& error) {
    EXPECT_TRUE(std::string_view(error.what()).starts_with("file:")) << error.what();
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string_view(error.what()).starts_with("file:")) << error.what();
  }
  return false;
}

/// Damages a good file in many ways and expects a mesh or a clear error.
/// \param n_spare  bytes at its end that it can do without
inline void expect_withstands_damage(const Parse& parse, const std::string& seed, std::size_t n_spare) {
  ASSERT_TRUE(is_read_or_refused(parse, seed)) << "the file is good to begin with";
  for (std::size_t n = 0; n + n_spare < seed.size(); ++n) {
    EXPECT_FALSE(is_read_or_refused(parse, std::string_view(seed).substr(0, n))) << "cut off behind byte " << n;
  }
  std::string bytes = seed;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    const char mask = static_cast<char>(1 << (bit % 8));
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ mask);
    is_read_or_refused(parse, bytes);
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ mask);
  }
  constexpr int kRounds = 3000;
  Mutator mutator(31);
  int n_refused = 0;
  for (int round = 0; round < kRounds; ++round) {
    n_refused += is_read_or_refused(parse, mutator.mutated(seed)) ? 0 : 1;
  }
  EXPECT_GT(n_refused, kRounds / 4) << "the changes do reach the reader";
}

}  // namespace nearwall::io
