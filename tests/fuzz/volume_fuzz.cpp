// Fuzz target of one reader of volume meshes: NEARWALL_PARSE names it. Bytes are read or refused with an error of ours;
// what is read fits together.

#include <cstdint>
#include <cstdlib>

#include "io/volume_formats.h"
#include "nearwall/core/errors.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto file = nearwall::io::NEARWALL_PARSE({reinterpret_cast<const char*>(data), size}, "file");
    for (const std::uint32_t node : file.mesh.nodes) {
      if (node >= file.mesh.points.size()) std::abort();
    }
    if (file.mesh.first_node.back() != file.mesh.nodes.size()) std::abort();
    for (const auto& face : file.boundary.faces) {
      for (int k = 0; k < nearwall::mesh::size_of(face); ++k) {
        if (face[k] >= file.mesh.points.size()) std::abort();
      }
    }
  } catch (const nearwall::GeometryError&) {
  } catch (const nearwall::InputError&) {
  }
  return 0;
}
