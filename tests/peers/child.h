#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace nearwall::peers {

/// How a run of a program went.
struct Run {
  int exit_code = -1;  ///< 127: there is no such program; −1: a signal ended it, or it could not be waited for
  double seconds = 0;  ///< of processor time, of all its threads and of the processes that it waited for
  std::uint64_t peak_bytes = 0;
};

/// Runs a program, looked for in PATH, in a folder; what it prints goes to files there.
/// \param output  name of the file for its standard output; standard error goes to the same name with .err behind it
Run run_program(const std::filesystem::path& folder, std::vector<std::string> words,
                const std::string& output = "output.txt");

}  // namespace nearwall::peers
