#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "program/child_process.h"
#include "program/table.h"

namespace nearwall::program {

/// How one case of a batch came out: a row of the table.
struct BatchResult {
  std::string label;
  int exit_code = -1;       ///< of the child process; -1: it never ran
  int signal = 0;           ///< that killed it; 0: none
  std::string result = {};  ///< "certified", "surface", "input", …, "crashed", "not run"
  unsigned long long n_triangles = 0;
  unsigned long long n_cells = 0;
  double coverage_percent = 0;  ///< of the area of all wall patches, with all layers
  double seconds = 0;
  double peak_memory_bytes = 0;
  std::string message = {};  ///< what went wrong

  bool is_done() const { return exit_code == 0 && signal == 0; }
};

/// Reads a result from what the child process left. \param seconds  that it ran; a report knows better
BatchResult read_result(const std::string& label, const ChildEnd& end, double seconds);

/// A case that an interrupt kept from running.
BatchResult not_run(const std::string& label);

Table table_of(const std::vector<BatchResult>& results);

/// "239 of 241 certified, 2 failed".
std::string tally(const std::vector<BatchResult>& results);

nlohmann::json json_of(const std::vector<BatchResult>& results);

}  // namespace nearwall::program
