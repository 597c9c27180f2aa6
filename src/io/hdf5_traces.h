#pragma once

#include <filesystem>

namespace nearwall::io {

/// Takes out of an HDF5 file what depends on more than its contents, and flushes it to the disk: the times of groups
/// and data sets, and what stands behind the ends of texts in attributes, where CGNS leaves what was in memory by
/// chance. \param path  a complete file that nobody has open; object headers of version 2 \throws IoError  also if the
/// file is cut off
void clear_traces(const std::filesystem::path& path);

}  // namespace nearwall::io
