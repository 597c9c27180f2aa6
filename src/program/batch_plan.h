#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace nearwall::program {

/// What `batch` is asked to do.
struct BatchRequest {
  std::vector<std::string> inputs;           ///< case files, surfaces or folders
  std::optional<std::string> template_file;  ///< case file for surfaces
  std::optional<std::string> directory;      ///< of all results
  std::vector<std::string> excluded;         ///< patterns of the shell, against path and file name
  std::vector<std::string> overrides;        ///< --set
  bool is_resumed = false;
  bool is_forced = false;
  bool has_relative_lengths = false;
};

/// One case of a batch.
struct BatchItem {
  std::string label;                   ///< the path as typed, or below the folder that was searched
  std::vector<std::string> arguments;  ///< command line of the child process, but for --threads
};

/// Finds the cases: folders are searched for case files, or for surfaces if there is a template.
/// \throws InputError if there is none
std::vector<BatchItem> plan_batch(const BatchRequest& request);

}  // namespace nearwall::program
