#include "nearwall/io/vtu_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "io/vtk_batches.h"
#include "io/vtk_xml_output.h"
#include "nearwall/core/markup.h"

namespace nearwall::io {
namespace {

class VtuWriter {
 public:
  VtuWriter(const std::filesystem::path& path, const mesh::MeshSource& mesh, std::span<const CellArray> extra)
      : file_(path), mesh_(mesh), extra_(extra) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::int32_t>::max();
    has_wide_ids_ = mesh.n_points() > kMost || n_connections(mesh) > kMost;
    const std::string id = has_wide_ids_ ? "Int64" : "Int32";
    const auto add = [&](std::vector<PackedArray>& to, const std::string& name, const std::string& type,
                         int components) { to.emplace_back(name, type, components, path); };
    add(points_, "Points", "Float64", 3);
    add(points_, "Line", "Int64", 1);
    add(points_, "Level", "Int32", 1);
    add(cells_, "connectivity", id, 1);
    add(cells_, "offsets", id, 1);
    add(cells_, "types", "UInt8", 1);
    add(cells_, "Layer", "Int32", 1);
    add(cells_, "Column", "Int64", 1);
    add(cells_, "Patch", "Int32", 1);
    for (const CellArray& array : extra) add(cells_, escaped_markup(array.name), "Float64", 1);
  }

  void write(const VtuMetadata& metadata, ProgressSink& progress) {
    VtkBatches(mesh_, extra_, has_wide_ids_).pack(points_, cells_, progress);
    lay_out(metadata);
    file_.commit();
  }

 private:
  void lay_out(const VtuMetadata& metadata) {
    VtkXmlOutput out("UnstructuredGrid");
    out.open("FieldData");
    out.add_strings("PatchNames", metadata.patch_names);
    out.close("FieldData");
    out.open(fmt::format("Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\"", mesh_.n_points(), mesh_.n_cells()));
    out.open("PointData");
    for (const int i : {VtkBatches::Line, VtkBatches::Level}) out.add(points_[i]);
    out.close("PointData");
    out.open("CellData");
    for (std::size_t i = VtkBatches::Layer; i < cells_.size(); ++i) out.add(cells_[i]);
    out.close("CellData");
    out.open("Points");
    out.add(points_[VtkBatches::Coordinates]);
    out.close("Points");
    out.open("Cells");
    for (const int i : {VtkBatches::Connectivity, VtkBatches::Offsets, VtkBatches::Types}) out.add(cells_[i]);
    out.close("Cells");
    out.close("Piece");
    out.write_to([&](std::string_view bytes) { file_.write(bytes); });
  }

  PendingFile file_;
  const mesh::MeshSource& mesh_;
  std::span<const CellArray> extra_;
  bool has_wide_ids_ = false;
  std::vector<PackedArray> points_;
  std::vector<PackedArray> cells_;
};

}  // namespace

CellArray numbers_in_file(const mesh::VolumeSource& source) {
  return {"Cell", [&source](const mesh::CellBatch& cells, std::span<double> out) {
            for (std::size_t i = 0; i < out.size(); ++i)
              out[i] = static_cast<double>(source.file_cell(cells.first + i));
          }};
}

void write_vtu(const std::filesystem::path& path, const mesh::MeshSource& mesh, std::span<const CellArray> extra,
               const VtuMetadata& metadata, ProgressSink* progress) {
  VtuWriter(path, mesh, extra).write(metadata, progress ? *progress : silent_progress());
}

}  // namespace nearwall::io
