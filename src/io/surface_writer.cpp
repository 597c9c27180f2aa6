#include "nearwall/io/surface_writer.h"

#include <fmt/format.h>

#include "io/file_bytes.h"
#include "io/surface_endings.h"
#include "io/surface_formats.h"
#include "nearwall/io/pending_file.h"
#include "nearwall/io/polydata_writer.h"

namespace nearwall::io {
namespace {

std::string format_vtp(const mesh::SurfaceMesh& mesh) { return format_polydata(polydata_of(mesh)); }

using Format = std::string (*)(const mesh::SurfaceMesh&);

constexpr std::array<Format, kSurfaceEndings.size()> kFormats = {format_stl, format_obj, format_ply,
                                                                 format_off, format_vtp, format_legacy_vtk};

}  // namespace

void write_surface(const std::filesystem::path& path, const mesh::SurfaceMesh& mesh) {
  const std::string bytes = kFormats[surface_format(path)](mesh);
  write_text(path, is_gzip_name(path) ? gzip(bytes) : bytes);
}

}  // namespace nearwall::io
