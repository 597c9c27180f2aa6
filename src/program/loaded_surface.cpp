#include "program/loaded_surface.h"

#include "nearwall/io/surface_reader.h"
#include "nearwall/surface/weld.h"
#include "program/console.h"

namespace nearwall::program {

LoadedSurface load_surface(const std::filesystem::path& file, double tolerance, ProgressSink& progress) {
  const mesh::SurfaceMesh read = staged(progress, "reading", [&] { return io::read_surface(file); });
  return {staged(progress, "welding", [&] { return surface::weld(read, tolerance); }), read.points.size()};
}

}  // namespace nearwall::program
