// Fuzz target of the reader of polyMesh: the bytes are its files one after the other, with a record separator between
// them. They are read or refused with an error of ours; what is read fits together.

#include <array>
#include <cstdint>
#include <cstdlib>

#include "io/openfoam_folder.h"
#include "nearwall/core/errors.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array<std::string_view, 6> kNames = {"points", "faces", "owner", "neighbour", "boundary", "cellZones"};
  constexpr char kSeparator = 0x1e;
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  std::array<std::string_view, kNames.size()> bytes;
  for (std::string_view& file : bytes) {
    file = rest.substr(0, rest.find(kSeparator));
    rest.remove_prefix(file.size() < rest.size() ? file.size() + 1 : file.size());
  }
  const nearwall::io::FoamSource open = [&](std::string_view name) -> nearwall::io::FoamFile {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      if (kNames[i] == name) return {std::string(name), std::string(bytes[i])};
    }
    std::abort();
  };
  try {
    const auto file = nearwall::io::parse_openfoam(open, "folder");
    for (const std::uint32_t node : file.mesh.nodes) {
      if (node >= file.mesh.points.size()) std::abort();
    }
    if (file.mesh.first_node.back() != file.mesh.nodes.size()) std::abort();
  } catch (const nearwall::GeometryError&) {
  } catch (const nearwall::InputError&) {
  }
  return 0;
}
