#include "nearwall/io/picture.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <vector>

#include "io/file_bytes.h"
#include "io/picture_arguments.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/pending_file.h"

namespace nearwall::io {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kPatience{60};
constexpr std::string_view kHelper = "nearwall-render";

/// Where the rendering program is: named by the environment, beside this program, in the libexec folder that belongs to
/// it, or where the package was installed. Empty if nowhere.
std::filesystem::path find_helper() {
  std::vector<std::filesystem::path> places;
  if (const char* named = std::getenv("NEARWALL_RENDER")) places.emplace_back(named);
  std::error_code none;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", none);
  if (!none) {
    places.push_back(program.parent_path() / kHelper);
    places.push_back(program.parent_path().parent_path() / "libexec" / "nearwall" / kHelper);
  }
  places.push_back(std::filesystem::path(NEARWALL_LIBEXEC_DIR) / kHelper);
  for (const auto& place : places) {
    if (::access(place.c_str(), X_OK) == 0 && !std::filesystem::is_directory(place)) return place;
  }
  return {};
}

struct HelperEnd {
  bool in_time = true;
  int status = 0;    ///< as of waitpid
  std::string talk;  ///< its standard error
};

/// A started helper; killed if it is left before its end.
class Helper {
 public:
  Helper(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw IoError("no pipe can be opened for making a picture");
    talk_ = ends[0];
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, ends[1], STDERR_FILENO);
    std::vector<std::string> words = {program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const int error = ::posix_spawn(&pid_, program.c_str(), &files, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    ::close(ends[1]);
    if (error != 0) pid_ = -1;
  }
  ~Helper() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      ::waitpid(pid_, nullptr, 0);
    }
    ::close(talk_);
  }
  Helper(const Helper&) = delete;
  Helper& operator=(const Helper&) = delete;

  bool has_started() const { return pid_ > 0; }

  HelperEnd wait() {
    HelperEnd end;
    const auto deadline = Clock::now() + kPatience;
    read_talk(end.talk, deadline);
    while (::waitpid(pid_, &end.status, WNOHANG) == 0) {
      if (Clock::now() > deadline) {
        end.in_time = false;
        return end;
      }
      ::usleep(2000);
    }
    pid_ = -1;
    return end;
  }

 private:
  /// Until the helper closes its end or the time is over.
  void read_talk(std::string& talk, Clock::time_point deadline) const {
    for (;;) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
      pollfd waiting{talk_, POLLIN, 0};
      if (left <= 0 || ::poll(&waiting, 1, static_cast<int>(left)) <= 0) return;
      char chunk[4096];
      const ssize_t n = ::read(talk_, chunk, sizeof(chunk));
      if (n <= 0) return;
      talk.append(chunk, static_cast<std::size_t>(n));
    }
  }

  pid_t pid_ = -1;
  int talk_ = -1;
};

std::string last_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

void check(const PictureRequest& request) {
  constexpr int kSmallest = 16, kLargest = 16384;
  for (const int n : request.size) {
    if (n < kSmallest || n > kLargest) {
      throw InputError(fmt::format("picture size {} is outside of {} to {} pixels", n, kSmallest, kLargest));
    }
  }
  if (format_ending(request.output) != "png") {
    throw InputError(fmt::format("{}: pictures are written as .png", request.output.string()));
  }
  if (!std::filesystem::exists(request.input)) {
    throw InputError(fmt::format("{}: no such file", request.input.string()));
  }
}

}  // namespace

PictureResult render_picture(const PictureRequest& request) {
  check(request);
  const std::filesystem::path program = find_helper();
  if (program.empty()) return {false, fmt::format("the program {} is not beside this one", kHelper)};

  PendingFile file(request.output);
  PictureRequest aside = request;
  aside.output = file.temporary();
  Helper helper(program, to_arguments(aside));
  if (!helper.has_started()) return {false, fmt::format("{} cannot be started", program.string())};
  const HelperEnd end = helper.wait();
  if (!end.in_time) return {false, fmt::format("the picture was not ready after {} seconds", kPatience.count())};

  const std::string message = last_line(end.talk);
  if (WIFSIGNALED(end.status)) {
    return {false, fmt::format("rendering ended with signal {}: {}", WTERMSIG(end.status), message)};
  }
  switch (static_cast<RenderExit>(WEXITSTATUS(end.status))) {
    case RenderExit::Made:
      file.commit();
      return {true, {}};
    case RenderExit::Input:
      throw InputError(message);
    case RenderExit::Geometry:
      throw GeometryError(message);
    case RenderExit::Io:
      throw IoError(message);
    case RenderExit::NotPossible:
      break;
  }
  return {false, message.empty() ? "rendering failed" : message};
}

}  // namespace nearwall::io
