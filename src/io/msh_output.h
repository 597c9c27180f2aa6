#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/cell_sections.h"
#include "nearwall/core/progress.h"
#include "nearwall/io/pending_file.h"
#include "nearwall/io/whole_mesh.h"

namespace nearwall::io {

/// Faces of one patch that have the same number of corners.
struct MshFaceBlock {
  PatchId patch;
  int code = 0;                      ///< Gmsh's element type
  std::vector<std::uint32_t> faces;  ///< places in the boundary
};

/// What the writers of both versions of Gmsh's format share: groups and their numbers, and the order of elements, which
/// is faces patch by patch, then cells section by section.
///
/// Elements of patch i are on surface i + 1, layers on volume 1, other cells on volume 2. Physical groups of surfaces
/// have the number of the surface, those of volumes follow, so that no number has two meanings: gmshToFoam keeps the
/// names of all dimensions in one table.
class MshOutput {
 public:
  MshOutput(const std::filesystem::path& path, const WholeMesh& mesh, ProgressSink& progress);

  const WholeMesh& mesh() const { return mesh_; }
  const CellSections& sections() const { return sections_; }
  const std::vector<MshFaceBlock>& face_blocks() const { return face_blocks_; }
  std::uint64_t n_elements() const { return mesh_.boundary.faces.size() + mesh_.cells.n_cells(); }

  /// Number of a cell in the file, by its number in the source. Faces come first, from 1.
  std::uint64_t element_of(CellIndex cell) const { return mesh_.boundary.faces.size() + cell + 1; }

  static int surface(PatchId patch) { return static_cast<int>(patch.index()) + 1; }
  static int volume(bool in_layers) { return in_layers ? 1 : 2; }
  int physical_volume(bool in_layers) const {
    return static_cast<int>(mesh_.boundary.patches.size()) + volume(in_layers);
  }
  /// Volumes that have cells, those of the layers first; that of the rest if none has.
  std::vector<bool> volumes_in_layers() const;

  /// The section $PhysicalNames. The format knows no escapes: double quotes in names become single ones, control
  /// characters blanks; names that are then equal get a number.
  std::string physical_names() const;

  void write(std::string_view bytes) { file_.write(bytes); }
  /// So many points, faces or cells more are written.
  void report(std::uint64_t n);
  void commit() { file_.commit(); }

 private:
  PendingFile file_;
  const WholeMesh& mesh_;
  ProgressSink& progress_;
  std::uint64_t n_written_ = 0;
  CellSections sections_;
  std::vector<MshFaceBlock> face_blocks_;
};

void write_msh22(const std::filesystem::path& path, const WholeMesh& mesh, ProgressSink& progress);
void write_msh41(const std::filesystem::path& path, const WholeMesh& mesh, ProgressSink& progress);

}  // namespace nearwall::io
