// Fuzz target of one surface reader: NEARWALL_PARSE names it. Bytes are read or refused with a GeometryError; anything
// else is a defect.

#include <cstdint>

#include "io/surface_formats.h"
#include "nearwall/core/errors.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    nearwall::io::NEARWALL_PARSE({reinterpret_cast<const char*>(data), size}, "file");
  } catch (const nearwall::GeometryError&) {
  }
  return 0;
}
