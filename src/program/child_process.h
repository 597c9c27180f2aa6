#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace nearwall::program {

/// How a child process ended.
struct ChildEnd {
  int exit_code = 0;   ///< meaningless if a signal ended it
  int signal = 0;      ///< that killed it; 0: none
  std::string output;  ///< all of its standard output
  std::string talk;    ///< all of its standard error
};

/// This same program, run once more: whatever happens to it, a crash included, happens to it alone.
class ChildProcess {
 public:
  /// \param arguments  without the program's name. \throws IoError if no process can be started
  explicit ChildProcess(const std::vector<std::string>& arguments);
  /// Kills the process if it still runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Does not wait.
  bool has_ended();
  /// Asks the process to stop.
  void interrupt() const;
  /// Call once, after `has_ended`.
  ChildEnd end() const;

 private:
  pid_t pid_ = -1;
  int status_ = 0;
  bool has_ended_ = false;
  int output_ = -1;  // files in memory: they take any amount, and nobody has to read along
  int talk_ = -1;
};

}  // namespace nearwall::program
