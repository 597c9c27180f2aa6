#include "nearwall/io/su2_writer.h"

#include <fmt/format.h>

#include "io/batches.h"
#include "io/boundary_output.h"
#include "io/number_text.h"
#include "io/vtk_cells.h"
#include "nearwall/io/pending_file.h"

namespace nearwall::io {
namespace {

// Elements have VTK's codes and node order, wedges, too: their first triangle looks out of the cell. Faces of markers
// look into the mesh. SU2 would turn those that stand otherwise.
constexpr int kTriangleCode = 5;
constexpr int kQuadCode = 9;

/// What SU2's configuration file, which names the markers, takes for the end of a word or more than a word.
constexpr std::string_view kForbidden = "%()[]{}|;,=:'\"\\";
constexpr std::array<std::string_view, 2> kReserved = {"SEND_RECEIVE", "NONE"};

std::string points_text(const mesh::MeshSource& source, std::size_t batch) {
  mesh::PointBatch points;
  source.read_points(batch, points);
  std::string text;
  for (const Vec3& p : points.position) {
    append_coordinates(text, p);
    text += '\n';
  }
  return text;
}

std::string cells_text(const mesh::MeshSource& source, std::size_t batch) {
  mesh::CellBatch cells;
  source.read_cells(batch, cells);
  std::string text;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const VtkCell& vtk = kVtkCells[static_cast<std::size_t>(cells.type[c])];
    std::array<NodeIndex, 9> line{vtk.code};
    const auto n = static_cast<std::size_t>(mesh::size_of(cells.type[c]));
    for (std::size_t k = 0; k < n; ++k) line[1 + k] = cells.nodes[c][vtk.node[k]];
    append_integers(text, std::span<const NodeIndex>(line.data(), 1 + n));
    text += '\n';
  }
  return text;
}

std::string marker_text(const std::string& tag, const mesh::Boundary& boundary,
                        const std::vector<std::uint32_t>& faces) {
  std::string text = fmt::format("MARKER_TAG= {}\nMARKER_ELEMS= {}\n", tag, faces.size());
  for (const std::uint32_t f : faces) {
    const mesh::BoundaryFace face = seen_from_inside(boundary.faces[f]);
    const auto n = static_cast<std::size_t>(mesh::size_of(face));
    text += fmt::format_int(n == 3 ? kTriangleCode : kQuadCode).c_str();
    text += ' ';
    append_integers(text, std::span<const NodeIndex>(face.data(), n));
    text += '\n';
  }
  return text;
}

void write_markers(PendingFile& file, const mesh::Boundary& boundary) {
  const auto faces = mesh::faces_by_patch(boundary);
  const auto tags = patch_words(boundary.patches, kForbidden, kReserved);
  std::size_t n_markers = 0;
  for (const auto& of_patch : faces) n_markers += of_patch.empty() ? 0 : 1;
  file.write(fmt::format("NMARK= {}\n", n_markers));
  for (const PatchId patch : boundary.patches.ids()) {
    if (!faces[patch].empty()) file.write(marker_text(tags[patch], boundary, faces[patch]));
  }
}

}  // namespace

// Points, elements, markers in this order: so SU2 reads the file in one pass.
void write_su2(const std::filesystem::path& path, const WholeMesh& mesh, ProgressSink* progress) {
  ProgressSink& sink = progress ? *progress : silent_progress();
  const mesh::MeshSource& source = mesh.cells;
  PendingFile file(path);
  const std::size_t n_point_batches = source.n_point_batches();
  const std::size_t n_batches = n_point_batches + source.n_cell_batches();
  const auto write = [&](std::size_t batch, const std::string& text) {
    file.write(text);
    sink.update(static_cast<double>(batch + 1) / static_cast<double>(n_batches));
  };
  file.write(fmt::format("NDIME= 3\nNPOIN= {}\n", source.n_points()));
  in_batches(
      n_point_batches, [&](std::size_t batch) { return points_text(source, batch); }, write);
  file.write(fmt::format("NELEM= {}\n", source.n_cells()));
  in_batches(
      source.n_cell_batches(), [&](std::size_t batch) { return cells_text(source, batch); },
      [&](std::size_t batch, const std::string& text) { write(n_point_batches + batch, text); });
  write_markers(file, mesh.boundary);
  file.commit();
}

}  // namespace nearwall::io
