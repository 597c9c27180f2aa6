#include <fmt/format.h>

#include <array>
#include <limits>
#include <span>
#include <tuple>

#include "io/batches.h"
#include "io/format_limits.h"
#include "io/msh_format.h"
#include "io/msh_output.h"
#include "io/number_text.h"
#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

/// Number, type, two tags (physical group, entity), nodes from 1.
template <class Nodes>
void append_element(std::string& text, std::uint64_t number, int code, int physical, int entity, const Nodes& nodes,
                    std::size_t n_nodes) {
  std::array<std::uint64_t, 5 + std::tuple_size_v<Nodes>> words = {number, static_cast<std::uint64_t>(code), 2,
                                                                   static_cast<std::uint64_t>(physical),
                                                                   static_cast<std::uint64_t>(entity)};
  for (std::size_t k = 0; k < n_nodes; ++k) words[5 + k] = nodes[k] + 1;
  append_integers(text, std::span<const std::uint64_t>(words.data(), 5 + n_nodes));
  text += '\n';
}

class Msh22Writer {
 public:
  explicit Msh22Writer(MshOutput& out) : out_(out) {}

  void write() {
    out_.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
    out_.write(out_.physical_names());
    write_nodes();
    out_.write(fmt::format("$Elements\n{}\n", out_.n_elements()));
    std::uint64_t next = 1;
    for (const MshFaceBlock& block : out_.face_blocks()) write_faces(block, next);
    for (const CellSection& section : out_.sections().sections()) write_cells(section);
    out_.write("$EndElements\n");
    out_.commit();
  }

 private:
  void write_nodes() {
    const mesh::MeshSource& mesh = out_.mesh().cells;
    out_.write(fmt::format("$Nodes\n{}\n", mesh.n_points()));
    in_batches(
        mesh.n_point_batches(),
        [&](std::size_t batch) {
          mesh::PointBatch points;
          mesh.read_points(batch, points);
          std::string text;
          for (std::size_t i = 0; i < points.size(); ++i) {
            const std::uint64_t number = points.first + i + 1;
            append_integers(text, std::span(&number, 1));
            text += ' ';
            append_coordinates(text, points.position[i]);
            text += '\n';
          }
          return text;
        },
        [&](std::size_t, const std::string& text) { out_.write(text); });
    out_.write("$EndNodes\n");
    out_.report(mesh.n_points());
  }

  void write_faces(const MshFaceBlock& block, std::uint64_t& next) {
    const int surface = MshOutput::surface(block.patch);
    std::string text;
    for (const std::uint32_t f : block.faces) {
      const mesh::BoundaryFace& face = out_.mesh().boundary.faces[f];
      append_element(text, next++, block.code, surface, surface, face, static_cast<std::size_t>(mesh::size_of(face)));
    }
    out_.write(text);
    out_.report(block.faces.size());
  }

  void write_cells(const CellSection& section) {
    const int code = msh_code(section.type), entity = MshOutput::volume(section.in_layers);
    const int physical = out_.physical_volume(section.in_layers);
    const auto n_nodes = static_cast<std::size_t>(mesh::size_of(section.type));
    out_.sections().stream(
        section,
        [&](const mesh::CellBatch& cells, const std::vector<std::uint32_t>& places) {
          std::string text;
          for (const std::uint32_t c : places) {
            append_element(text, out_.element_of(cells.first + c), code, physical, entity, cells.nodes[c], n_nodes);
          }
          return text;
        },
        [&](const std::string& text) { out_.write(text); });
    out_.report(section.n_cells);
  }

  MshOutput& out_;
};

}  // namespace

void write_msh22(const std::filesystem::path& path, const WholeMesh& mesh, ProgressSink& progress) {
  require_msh22_limits(path, mesh);
  MshOutput out(path, mesh, progress);
  Msh22Writer(out).write();
}

}  // namespace nearwall::io
