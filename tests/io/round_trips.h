#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "nearwall/core/errors.h"
#include "nearwall/io/volume_reader.h"
#include "tests/io/mutator.h"
#include "tests/io/temporary_folder.h"

/// Comparing meshes whose cells and faces may stand in another order, and damaging files.
namespace nearwall::io {

/// Type, layer (0 or more: 1), nodes of each cell.
using CellRecord = std::pair<std::pair<mesh::CellType, bool>, std::vector<std::uint32_t>>;

inline std::multiset<CellRecord> cells_with_layers(const mesh::VolumeMesh& mesh) {
  std::multiset<CellRecord> cells;
  for (std::size_t c = 0; c < mesh.n_cells(); ++c) {
    const auto nodes = mesh.nodes_of(c);
    const bool is_layer = !mesh.layer.empty() && mesh.layer[c] > 0;
    cells.insert({{mesh.type[c], is_layer}, {nodes.begin(), nodes.end()}});
  }
  return cells;
}

inline std::multimap<std::string, mesh::BoundaryFace> faces_by_name(const mesh::Boundary& boundary) {
  std::vector<std::pair<std::string, mesh::BoundaryFace>> faces;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    faces.emplace_back(boundary.patches[boundary.patch[f]].name, boundary.faces[f]);
  }
  std::sort(faces.begin(), faces.end());
  return {faces.begin(), faces.end()};
}

/// Changes the bytes of a file in many ways and reads it. \returns how many were refused: by errors of ours that name
/// the file
inline int damage(const std::string& seed, const char* name, VolumeFile (*read)(const std::filesystem::path&)) {
  constexpr int kRounds = 300;
  constexpr std::size_t kCuts = 100;
  const TemporaryFolder folder;
  const auto is_refused = [&](std::string_view bytes) {
    try {
      const mesh::VolumeMesh mesh = read(folder.file(name, bytes)).mesh;
      for (const std::uint32_t node : mesh.nodes) EXPECT_LT(node, mesh.points.size());
      return false;
    } catch (const GeometryError& error) {
      EXPECT_TRUE(std::string_view(error.what()).find(name) != std::string_view::npos) << error.what();
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string_view(error.what()).find(name) != std::string_view::npos) << error.what();
    }
    return true;
  };
  EXPECT_FALSE(is_refused(seed)) << "the file is good to begin with";
  Mutator mutator(29);
  int n_refused = 0;
  for (int round = 0; round < kRounds; ++round) n_refused += is_refused(mutator.mutated(seed)) ? 1 : 0;
  // Single bytes in place, too: what is inserted or cut moves all that is behind it.
  for (std::size_t at = 0; at < seed.size(); at += std::max<std::size_t>(1, seed.size() / kRounds)) {
    std::string bytes = seed;
    bytes[at] = static_cast<char>(bytes[at] ^ (at % 2 == 0 ? 0xff : 1 << at % 8));
    n_refused += is_refused(bytes) ? 1 : 0;
  }
  for (std::size_t cut = 0; cut < kCuts; ++cut) {
    EXPECT_TRUE(is_refused(std::string_view(seed).substr(0, seed.size() * cut / kCuts))) << cut;
  }
  return n_refused;
}

}  // namespace nearwall::io
