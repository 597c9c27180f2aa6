#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace nearwall::io {

/// The bytes of a file, unpacked if it is gzipped (by its content, not its name).
/// \throws InputError     no such file, or a folder
///         IoError        no permission, read failure, no memory
///         GeometryError  gzipped data that is damaged, or a name in .gz without gzipped data
std::string read_bytes(const std::filesystem::path& path);

/// `bytes` in gzip form, the same bytes at every time and on every machine with the same zlib.
std::string gzip(std::string_view bytes);

/// The last ending of a file name in lower case, without the dot and ignoring a final .gz: "wing.STL.gz" → "stl".
std::string format_ending(const std::filesystem::path& path);

/// Does the name end in .gz (upper or lower case)?
bool is_gzip_name(const std::filesystem::path& path);

}  // namespace nearwall::io
