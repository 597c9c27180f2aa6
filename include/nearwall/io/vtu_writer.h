#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "nearwall/core/progress.h"
#include "nearwall/mesh/mesh_source.h"
#include "nearwall/mesh/volume_source.h"

namespace nearwall::io {

/// A further cell array of doubles, computed batch by batch. `fill` is called on several threads at once.
struct CellArray {
  std::string name;
  std::function<void(const mesh::CellBatch&, std::span<double>)> fill;  ///< one value for each cell of the batch
};

/// `Cell`: the numbers that the cells have in the file that they were read from. The source must outlive it.
CellArray numbers_in_file(const mesh::VolumeSource& source);

struct VtuMetadata {
  std::vector<std::string> patch_names;  ///< field data `PatchNames`; `Patch` indexes it
};

/// Writes a volume mesh as .vtu: all cells in VTK's node order, doubles, appended, compressed (zlib).
///
/// Cell arrays `Layer`, `Column`, `Patch` and those of `extra`; point arrays `Line`, `Level`. The same bytes for the
/// same mesh whatever the number of threads. The source is read once; memory: some batches, not the mesh. While it is
/// written the folder needs room for the file and, once more, for its largest arrays.
/// \throws IoError  disk full, no permission
void write_vtu(const std::filesystem::path& path, const mesh::MeshSource& mesh, std::span<const CellArray> extra,
               const VtuMetadata& metadata, ProgressSink* progress = nullptr);

}  // namespace nearwall::io
