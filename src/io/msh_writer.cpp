#include "nearwall/io/msh_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "io/boundary_output.h"
#include "io/msh_format.h"
#include "io/msh_output.h"

namespace nearwall::io {
namespace {

std::vector<MshFaceBlock> blocks_of_faces(const mesh::Boundary& boundary) {
  std::vector<MshFaceBlock> blocks;
  const auto faces = mesh::faces_by_patch(boundary);
  for (const PatchId patch : boundary.patches.ids()) {
    std::array<MshFaceBlock, 2> of_patch = {MshFaceBlock{patch, kMshTriangle, {}}, MshFaceBlock{patch, kMshQuad, {}}};
    for (const std::uint32_t face : faces[patch]) {
      of_patch[mesh::size_of(boundary.faces[face]) == 4 ? 1 : 0].faces.push_back(face);
    }
    for (MshFaceBlock& block : of_patch) {
      if (!block.faces.empty()) blocks.push_back(std::move(block));
    }
  }
  return blocks;
}

/// Longer names are cut by Gmsh 4.
constexpr std::size_t kLongestName = 120;

std::string fit_name(std::string_view name) {
  std::string fit(name.substr(0, kLongestName));
  std::ranges::replace(fit, '"', '\'');
  std::ranges::replace_if(
      fit, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return fit;
}

}  // namespace

MshOutput::MshOutput(const std::filesystem::path& path, const WholeMesh& mesh, ProgressSink& progress)
    : file_(path),
      mesh_(mesh),
      progress_(progress),
      sections_(mesh.cells),
      face_blocks_(blocks_of_faces(mesh.boundary)) {}

std::vector<bool> MshOutput::volumes_in_layers() const {
  std::vector<bool> volumes;
  for (const CellSection& section : sections_.sections()) {
    if (volumes.empty() || volumes.back() != section.in_layers) volumes.push_back(section.in_layers);
  }
  if (volumes.empty()) volumes.push_back(false);
  return volumes;
}

std::string MshOutput::physical_names() const {
  const std::vector<bool> volumes = volumes_in_layers();
  std::string out = fmt::format("$PhysicalNames\n{}\n", mesh_.boundary.patches.size() + volumes.size());
  const auto names = unique_names(mesh_.boundary.patches, fit_name, {});
  for (const PatchId patch : names.ids()) out += fmt::format("2 {} \"{}\"\n", surface(patch), names[patch]);
  for (const bool in_layers : volumes) {
    out += fmt::format("3 {} \"{}\"\n", physical_volume(in_layers), in_layers ? kLayersGroup : kRestGroup);
  }
  return out + "$EndPhysicalNames\n";
}

void MshOutput::report(std::uint64_t n) {
  n_written_ += n;
  progress_.update(static_cast<double>(n_written_) / static_cast<double>(mesh_.cells.n_points() + n_elements()));
}

void write_msh(const std::filesystem::path& path, const WholeMesh& mesh, MshVersion version, ProgressSink* progress) {
  const auto write = version == MshVersion::V41 ? write_msh41 : write_msh22;
  write(path, mesh, progress ? *progress : silent_progress());
}

}  // namespace nearwall::io
