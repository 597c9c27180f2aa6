#include "pipeline/mesh_files.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include <fmt/format.h>

#include "nearwall/core/expect.h"
#include "nearwall/io/boundary_file.h"
#include "nearwall/io/pending_file.h"
#include "nearwall/quality/metrics.h"
#include "pipeline/stage_clock.h"
#include "pipeline/volume_stage.h"

namespace nearwall::pipeline {

namespace {

/// In the order of PatchType.
constexpr mesh::BoundaryType kBoundaryTypes[] = {mesh::BoundaryType::Wall,     mesh::BoundaryType::Wall,
                                                 mesh::BoundaryType::Symmetry, mesh::BoundaryType::Inlet,
                                                 mesh::BoundaryType::Outlet,   mesh::BoundaryType::FarField};

io::CellArray scaled_jacobians() {
  return {"ScaledJacobian", [](const mesh::CellBatch& batch, std::span<double> values) {
            for (std::size_t i = 0; i < batch.size(); ++i) {
              const auto n = static_cast<std::size_t>(mesh::size_of(batch.type[i]));
              values[i] = quality::scaled_jacobian(batch.type[i], {batch.corners[i].data(), n});
            }
          }};
}

/// Neighbours that are found for the first format that lists faces: most do not.
class NeighboursOnDemand final : public mesh::NeighbourSource {
 public:
  NeighboursOnDemand(const mesh::LayerMesh& layers, const mesh::Boundary& boundary, const volume::FilledRest* filled)
      : layers_(layers), boundary_(boundary), filled_(filled) {}

  /// Call before such a format is written. Not left to the first `read_neighbours`: both run on several threads, and a
  /// thread that waits for parts of this might begin another batch, which would wait for this.
  void find() {
    if (!found_) found_.emplace(layers_, boundary_, filled_);
  }

  void read_neighbours(std::size_t batch, const mesh::CellBatch& cells, mesh::NeighbourBatch& out) const override {
    expect(found_.has_value(), "neighbours to be found before they are read");
    found_->read_neighbours(batch, cells, out);
  }

 private:
  const mesh::LayerMesh& layers_;
  const mesh::Boundary& boundary_;
  const volume::FilledRest* filled_;
  std::optional<volume::HybridNeighbours> found_;
};

/// With the triangle of the input file that each face is, −1 for others.
io::PolyDataFile boundary_file(const volume::DomainBoundary& faces, const mesh::Boundary& boundary,
                               const Prepared& prepared) {
  std::unordered_map<NodeIndex, std::size_t> place;
  for (std::size_t i = 0; i < faces.node.size(); ++i) place.emplace(faces.node[i], i);
  io::PolyDataFile file = io::boundary_polydata(boundary, [&](NodeIndex n) { return faces.points[place.at(n)]; });
  std::vector<std::int32_t> triangle;
  for (const int size : {3, 4}) {
    for (std::size_t f = 0; f < faces.faces.size(); ++f) {
      if (faces.size_of(f) != size) continue;
      const FaceId input = faces.wall_face[f].is_valid() ? prepared.input_face[faces.wall_face[f]] : FaceId();
      triangle.push_back(input.is_valid() ? static_cast<std::int32_t>(input.index()) : -1);
    }
  }
  file.triangle_data.push_back({"Triangle", std::move(triangle)});
  return file;
}

}  // namespace

IdVector<PatchId, mesh::BoundaryPatch> boundary_patches(const Prepared& prepared) {
  const auto& names = prepared.surface().patch_names;
  const auto types = patch_types(prepared.settings, names.raw());
  IdVector<PatchId, mesh::BoundaryPatch> patches;
  for (const PatchId p : names.ids()) {
    patches.push_back({names[p], kBoundaryTypes[static_cast<std::size_t>(types[p.index()])]});
  }
  return patches;
}

volume::DomainBoundary boundary_of_layers(const Result& result, const certify::CertifiedWall& wall,
                                          IdVector<PatchId, mesh::BoundaryPatch>& patches) {
  std::string name = "front";
  for (int i = 2; std::any_of(patches.begin(), patches.end(), [&](const auto& p) { return p.name == name; }); ++i) {
    name = fmt::format("front{}", i);
  }
  const PatchId front = patches.push_back({name, mesh::BoundaryType::Other});
  return volume::layers_boundary(result.layers, wall, front, patches_on_planes(result.prepared));
}

void write_mesh_files(const Result& result, const MeshToWrite& mesh, const std::string& name,
                      std::span<const io::MeshFormat> formats, OutputDirectory& output, ProgressSink& progress) {
  const mesh::Boundary boundary = volume::mesh_boundary(mesh.boundary, mesh.patches);
  NeighboursOnDemand neighbours(result.layers, boundary, mesh.filled);
  const io::WholeMesh whole{mesh.cells, boundary, neighbours, name};
  const io::CellArray arrays[] = {scaled_jacobians()};
  const io::MeshExtras extras{arrays, result.wall.surface.patch_names.raw()};
  for (const io::MeshFormat format : formats) {
    io::require_limits(output.path() / io::mesh_file_names(name, format).front(), format, whole);
  }
  for (const io::MeshFormat format : formats) {
    staged(progress, fmt::format("writing {}", io::name_of(format)), [&] {
      const auto files = io::mesh_file_names(name, format);
      for (const std::string& file : files) {
        const auto path = output.aside(file);
        if (file.ends_with(".foam")) io::write_text(path, "");
      }
      if (io::is_openfoam(format)) neighbours.find();
      io::write_mesh(output.scratch(files.front()), format, whole, extras, &progress);
    });
  }
  io::write_polydata(output.aside(name + "-boundary.vtp"), boundary_file(mesh.boundary, boundary, result.prepared));
}

}  // namespace nearwall::pipeline
