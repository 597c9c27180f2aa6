#pragma once

#include <string>
#include <vector>

namespace nearwall::program {

/// Names that fit a column of a table: what is too long keeps its begin and its end, "wing-upper…outboard", as names
/// of parts differ in either. No two are the same unless two of the full names are: those that would be have their
/// number (from 1) in place of the end.
/// \param longest  characters of UTF-8, some ten at least
std::vector<std::string> row_names(const std::vector<std::string>& names, std::size_t longest);

}  // namespace nearwall::program
