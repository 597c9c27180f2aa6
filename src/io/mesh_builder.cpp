#include "io/mesh_builder.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "io/surface_builder.h"
#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"
#include "nearwall/mesh/volume_neighbours.h"

namespace nearwall::io {
namespace {

constexpr std::size_t kMostPoints = std::numeric_limits<std::uint32_t>::max();

}  // namespace

MeshBuilder::MeshBuilder(std::string file) : file_(std::move(file)) { volume_.mesh.first_node.push_back(0); }

void MeshBuilder::expect_points(std::size_t n) { volume_.mesh.points.reserve(n); }

void MeshBuilder::expect_cells(std::size_t n_cells, std::size_t n_nodes) {
  mesh::VolumeMesh& mesh = volume_.mesh;
  mesh.type.reserve(n_cells);
  mesh.first_node.reserve(n_cells + 1);
  mesh.file_cell.reserve(n_cells);
  mesh.layer.reserve(n_cells);
  mesh.nodes.reserve(n_nodes);
}

void MeshBuilder::add_point(const Vec3& point, const FilePosition& where) {
  if (!std::isfinite(point.x()) || !std::isfinite(point.y()) || !std::isfinite(point.z())) {
    fail_at(where, fmt::format("point {}: expected finite coordinates, found a NaN or an infinity", n_points()));
  }
  if (n_points() >= kMostPoints) fail_at(where, fmt::format("more than {} points", kMostPoints));
  volume_.mesh.points.push_back(point);
}

NodeIndex MeshBuilder::checked_node(std::int64_t node, const FilePosition& where) const {
  if (node < 0 || static_cast<std::uint64_t>(node) >= kMostPoints) {
    fail_at(where, fmt::format("{} is no number of a point (counted from 0)", node));
  }
  return static_cast<NodeIndex>(node);
}

void MeshBuilder::add_cell(mesh::CellType type, std::span<const std::int64_t> nodes, std::uint64_t file_cell,
                           std::int32_t layer, const FilePosition& where) {
  mesh::VolumeMesh& mesh = volume_.mesh;
  for (std::size_t k = 0; k < static_cast<std::size_t>(mesh::size_of(type)); ++k) {
    mesh.nodes.push_back(static_cast<std::uint32_t>(checked_node(nodes[k], where)));
  }
  mesh.type.push_back(type);
  mesh.first_node.push_back(mesh.nodes.size());
  mesh.file_cell.push_back(file_cell);
  mesh.layer.push_back(layer);
}

PatchId MeshBuilder::patch(std::string_view name, mesh::BoundaryType type) {
  const auto found = patch_of_name_.find(name);
  if (found != patch_of_name_.end()) return found->second;
  const PatchId patch = volume_.boundary.patches.push_back({std::string(name), type});
  patch_of_name_.emplace(name, patch);
  return patch;
}

void MeshBuilder::add_face(PatchId patch, std::span<const std::int64_t> nodes, const FilePosition& where) {
  expect(nodes.size() == 3 || nodes.size() == 4, "a triangle or a quad");
  mesh::BoundaryFace face{0, 0, 0, mesh::kNoFourthNode};
  for (std::size_t k = 0; k < nodes.size(); ++k) face[k] = checked_node(nodes[k], where);
  volume_.boundary.faces.push_back(face);
  volume_.boundary.patch.push_back(patch);
}

VolumeFile MeshBuilder::finish() {
  mesh::VolumeMesh& mesh = volume_.mesh;
  const auto fail = [&](const char* what, std::uint64_t number, std::uint64_t node) {
    throw GeometryError(fmt::format("{}: {} {} uses point {} (counted from 0), but there are {} points", file_, what,
                                    number, node, n_points()));
  };
  for (std::size_t c = 0; c < mesh.n_cells(); ++c) {
    for (const std::uint32_t node : mesh.nodes_of(c)) {
      if (node >= n_points()) fail("cell", mesh.file_cell[c], node);
    }
  }
  for (std::size_t f = 0; f < volume_.boundary.faces.size(); ++f) {
    const mesh::BoundaryFace& face = volume_.boundary.faces[f];
    for (std::size_t k = 0; k < static_cast<std::size_t>(mesh::size_of(face)); ++k) {
      if (face[k] >= n_points()) fail("boundary face", f, face[k]);
    }
  }
  for (const mesh::BoundaryPatch& patch : volume_.boundary.patches) volume_.patch_names.push_back(patch.name);
  return std::move(volume_);
}

mesh::SurfaceMesh surface_of(const VolumeFile& volume, const std::string& file) {
  const FilePosition where{file, true, 0};
  mesh::Boundary boundary = volume.boundary;
  if (volume.mesh.n_cells() > 0) mesh::fit_boundary(volume.mesh, boundary);
  SurfaceBuilder builder;
  std::vector<std::int64_t> number(volume.mesh.points.size(), -1);
  const auto faces = mesh::faces_by_patch(boundary);
  for (const PatchId patch : boundary.patches.ids()) {
    builder.begin_patch(boundary.patches[patch].name);
    for (const std::uint32_t f : faces[patch]) {
      std::array<std::int64_t, 4> corners{};
      const auto n = static_cast<std::size_t>(mesh::size_of(boundary.faces[f]));
      for (std::size_t k = 0; k < n; ++k) {
        std::int64_t& own = number[boundary.faces[f][k]];
        if (own < 0) own = builder.add_point(volume.mesh.points[boundary.faces[f][k]], where).index();
        corners[k] = own;
      }
      builder.add_face({corners.data(), n}, where);
    }
  }
  return builder.finish(where);
}

}  // namespace nearwall::io
