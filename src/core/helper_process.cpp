#include "nearwall/core/helper_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <system_error>

#include "nearwall/core/errors.h"

namespace nearwall {

namespace {

using Clock = std::chrono::steady_clock;

/// "nearwall-render" is named by NEARWALL_RENDER.
std::string variable_of(std::string_view name) {
  std::string variable;
  for (const char c : name) variable += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return variable;
}

void open_or_pass(posix_spawn_file_actions_t* files, int target, std::optional<int> given, int mode) {
  if (given) {
    posix_spawn_file_actions_adddup2(files, *given, target);
  } else {
    posix_spawn_file_actions_addopen(files, target, "/dev/null", mode, 0);
  }
}

}  // namespace

std::filesystem::path find_helper(std::string_view name) {
  std::vector<std::filesystem::path> places;
  if (const char* named = std::getenv(variable_of(name).c_str())) places.emplace_back(named);
  std::error_code none;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", none);
  if (!none) {
    places.push_back(program.parent_path() / name);
    places.push_back(program.parent_path().parent_path() / "libexec" / "nearwall" / name);
  }
  places.push_back(std::filesystem::path(NEARWALL_LIBEXEC_DIR) / name);
  for (const auto& place : places) {
    if (::access(place.c_str(), X_OK) == 0 && !std::filesystem::is_directory(place)) return place;
  }
  return {};
}

HelperProcess::HelperProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                             const Streams& streams) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw IoError("no pipe can be opened for a helper program");
  pipe_ = ends[0];
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  open_or_pass(&files, STDIN_FILENO, streams.input, O_RDONLY);
  open_or_pass(&files, STDOUT_FILENO, streams.output, O_WRONLY);
  posix_spawn_file_actions_adddup2(&files, ends[1], STDERR_FILENO);
  std::vector<std::string> words = {program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  has_started_ = ::posix_spawn(&pid_, program.c_str(), &files, nullptr, argv.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&files);
  ::close(ends[1]);
}

HelperProcess::~HelperProcess() {
  if (has_started_ && !has_ended_) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  ::close(pipe_);
}

bool HelperProcess::wait(std::chrono::milliseconds patience) {
  constexpr std::chrono::milliseconds kBetweenLooks{2};
  const auto deadline = Clock::now() + patience;
  while (!has_ended_) {
    read_talk(std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()));
    has_ended_ = ::waitpid(pid_, &status_, WNOHANG) == pid_;
    if (has_ended_) read_talk({});  // what it said between the two
    if (has_ended_ || Clock::now() >= deadline) break;
    ::usleep(std::chrono::microseconds(kBetweenLooks).count());
  }
  return has_ended_;
}

void HelperProcess::read_talk(std::chrono::milliseconds patience) {
  const auto deadline = Clock::now() + patience;
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd waiting{pipe_, POLLIN, 0};
    if (::poll(&waiting, 1, static_cast<int>(std::max<long>(left, 0))) <= 0) return;
    char chunk[4096];
    const ssize_t n = ::read(pipe_, chunk, sizeof(chunk));
    if (n <= 0) return;
    talk_.append(chunk, static_cast<std::size_t>(n));
  }
}

std::string HelperProcess::last_words() const {
  const std::size_t end = talk_.find_last_not_of(" \n");
  if (end == std::string::npos) return {};
  const std::string text = talk_.substr(0, end + 1);
  return text.substr(text.rfind('\n') + 1);
}

}  // namespace nearwall
