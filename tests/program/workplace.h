#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace nearwall::program {

/// What a run of the program left behind.
struct Outcome {
  int exit_code = -1;  ///< −1 if a signal ended it
  int signal = 0;
  std::string out;
  std::string err;
};

/// A folder of its own for each test, in which the real program is run. Removed with all it holds.
class Workplace {
 public:
  Workplace();
  ~Workplace();
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  /// Paths of all files below a folder, relative to it, sorted; empty if there is no such folder.
  std::vector<std::string> files(const std::string& name) const;

  Outcome run(const std::vector<std::string>& arguments);
  /// Starts without waiting; `wait` ends it.
  pid_t start(const std::vector<std::string>& arguments);
  Outcome wait(pid_t process);
  /// Waits until the standard error of the process holds the text. \returns false if that takes longer than 30 s
  bool has_said(const std::string& text) const;

  /// A closed cube as OBJ, and the same without one of its triangles.
  void write_cube(const std::string& name) const;
  void write_open_cube(const std::string& name) const;
  /// A case with three layers on the given surface.
  void write_case(const std::string& name, const std::string& surface, const std::string& more = "") const;

 private:
  std::filesystem::path folder_;
};

}  // namespace nearwall::program
