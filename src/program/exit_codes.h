#pragma once

#include <exception>
#include <string>

namespace nearwall::program {

/// Exit codes of the program (docs/command-line.md).
enum class ExitCode : int {
  Done = 0,
  Fault = 1,        ///< `check`: faults found; `certify`: not valid; `batch`: at least one case failed
  BadInput = 2,     ///< command line or case file
  BadSurface = 3,   ///< the input surface cannot be used
  PartMissing = 4,  ///< a part that was asked for is missing
  Machine = 5,      ///< disk full, no memory, no permission
  Defect = 70,      ///< of nearwall itself
  Interrupted = 130
};

/// What a user is told about an error that ended a command.
struct Failure {
  ExitCode code;
  std::string kind;     ///< "input", "surface", "part-missing", "machine", "defect", "interrupted"
  std::string message;  ///< what, where, what to do
};

/// Short name of a code, the `kind` of a Failure.
std::string kind_of(ExitCode code);

/// Maps an exception to its exit code; whatever is not one of ours is a defect.
Failure explain(const std::exception_ptr& error);

}  // namespace nearwall::program
