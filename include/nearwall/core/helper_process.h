#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nearwall {

/// Where a program of ours that only ours start is: named by the environment (NEARWALL_RENDER for nearwall-render),
/// beside this program, in the libexec folder that belongs to it, or where the package was installed. Empty if nowhere.
std::filesystem::path find_helper(std::string_view name);

/// A started program of ours; killed if it is left before its end.
class HelperProcess {
 public:
  /// What it reads and writes, as open files; none: /dev/null. They stay the caller's.
  struct Streams {
    std::optional<int> input;
    std::optional<int> output;
  };
  HelperProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const Streams& streams = {});
  ~HelperProcess();
  HelperProcess(const HelperProcess&) = delete;
  HelperProcess& operator=(const HelperProcess&) = delete;

  bool has_started() const { return has_started_; }
  int pid() const { return pid_; }

  /// Waits for its end, but no longer than this. \returns  whether it has ended
  bool wait(std::chrono::milliseconds patience);

  int status() const { return status_; }             ///< as of waitpid, once it has ended
  const std::string& talk() const { return talk_; }  ///< its standard error so far
  std::string last_words() const;                    ///< the last line of it

 private:
  void read_talk(std::chrono::milliseconds patience);

  int pid_ = -1;
  int pipe_ = -1;
  int status_ = 0;
  bool has_started_ = false;
  bool has_ended_ = false;
  std::string talk_;
};

}  // namespace nearwall
