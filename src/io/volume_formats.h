#pragma once

#include <string>
#include <string_view>

#include "nearwall/io/volume_reader.h"

namespace nearwall::io {

// One reader for each format, from the unpacked bytes of the file. `file` is its name for messages.
// Each throws GeometryError on malformed content and InputError on cells that are not ours.
VolumeFile parse_vtu(std::string_view bytes, const std::string& file);
VolumeFile parse_legacy_volume(std::string_view bytes, const std::string& file);

}  // namespace nearwall::io
