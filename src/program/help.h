#pragma once

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

namespace nearwall::program {

/// What `nearwall` alone prints.
std::string overview();

/// A line with a name to the left and what it means to the right, wrapped below itself.
std::string entry(const std::string& left, const std::string& right);

/// Lays out the help of a command: summary, usage, arguments, options by group, example.
/// \param usage    what follows `nearwall` on the command line; \param example  whole command lines, one a line
std::shared_ptr<CLI::FormatterBase> help_formatter(const std::string& usage, const std::string& example);

inline constexpr const char* kCommonGroup = "Common options";  ///< group of the options that every command has

}  // namespace nearwall::program
