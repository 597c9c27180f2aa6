// Any text is either a case or is refused with an error of ours.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "nearwall/core/errors.h"
#include "nearwall/pipeline/case.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const nearwall::Case settings = nearwall::parse_case(std::string(data, data + size), "case.toml");
    const std::vector<std::string> patches = {"wing", "body"};
    nearwall::resolve_patches(settings, patches);
  } catch (const nearwall::InputError&) {
  }
  return 0;
}
