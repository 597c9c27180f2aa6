#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace nearwall::program {

/// Whether the file is a case file: *.toml with a key `format` at its top level.
bool is_case_file(const std::filesystem::path& path);

/// For options that name a VTP file to write. \throws InputError if the name ends otherwise
void demand_vtp(const std::string& option, const std::filesystem::path& path);

/// Files below a folder that `wanted` accepts, in the order of their names; hidden folders are passed over.
/// \throws IoError if a folder cannot be read
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder,
                                               bool (*wanted)(const std::filesystem::path&));

}  // namespace nearwall::program
