#pragma once

#include "nearwall/layers/grow.h"
#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/mesh/mesh_source.h"
#include "nearwall/pipeline/report.h"
#include "nearwall/quality/coverage.h"
#include "pipeline/output_directory.h"
#include "pipeline/prepare.h"

namespace nearwall::pipeline {

/// What the files are written from.
struct Result {
  const Prepared& prepared;
  const layers::Wall& wall;
  const layers::Growth& growth;
  const mesh::LayerMesh& layers;
  const IdVector<FaceId, quality::FaceCoverage>& coverage;
};

/// The layers with columns numbered as the triangles of the input file. What it is made from must outlive it.
class LayersOfInput final : public mesh::MeshSource {
 public:
  LayersOfInput(const Prepared& prepared, const mesh::LayerMesh& layers)
      : source_(layers, prepared.surface().face_patch, prepared.surface().points.raw()),
        input_face_(prepared.input_face) {}

  NodeIndex n_points() const override { return source_.n_points(); }
  CellIndex n_cells() const override { return source_.n_cells(); }
  std::array<CellIndex, mesh::kNCellTypes> n_cells_by_type() const override { return source_.n_cells_by_type(); }
  std::size_t n_point_batches() const override { return source_.n_point_batches(); }
  void read_points(std::size_t batch, mesh::PointBatch& out) const override { source_.read_points(batch, out); }
  std::size_t n_cell_batches() const override { return source_.n_cell_batches(); }
  void read_cells(std::size_t batch, mesh::CellBatch& out) const override;

 private:
  mesh::LayerSource source_;
  const IdVector<FaceId, FaceId>& input_face_;
};

/// NAME-surface.vtp and NAME-front.vtp, aside. \throws IoError
void write_surfaces(const Result& result, const std::string& name, OutputDirectory& output);

/// The pictures, aside; where none can be made a note says so. \returns those that were made
/// \param has_volume  there is a volume beside the layers: a side of the domain is shown, too
std::vector<Picture> make_pictures(const Result& result, const std::string& name, bool has_volume,
                                   OutputDirectory& output, ProgressSink& progress);

}  // namespace nearwall::pipeline
