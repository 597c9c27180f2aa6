#include "io/x_display.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace nearwall::io {
namespace {

constexpr int kStartMilliseconds = 20000;
constexpr int kNotInstalled = 127;

[[noreturn]] void become_xvfb(int number_to) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int null = ::open("/dev/null", O_RDWR);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(null, descriptor);
  constexpr int kNumberDescriptor = 3;
  if (number_to == kNumberDescriptor) {
    ::fcntl(number_to, F_SETFD, 0);
  } else {
    ::dup2(number_to, kNumberDescriptor);
  }
  ::execlp("Xvfb", "Xvfb", "-displayfd", "3", "-screen", "0", "1280x1024x24", "-nolisten", "tcp", "-noreset",
           static_cast<char*>(nullptr));
  ::_exit(kNotInstalled);
}

}  // namespace

PrivateDisplay::PrivateDisplay() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    reason_ = "no pipe can be opened";
    return;
  }
  pid_ = ::fork();
  if (pid_ == 0) become_xvfb(ends[1]);
  ::close(ends[1]);
  const std::string number = pid_ > 0 ? read_number(ends[0]) : std::string();
  ::close(ends[0]);
  if (!number.empty()) {
    name_ = ":" + number;
    return;
  }
  int status = 0;
  const bool has_ended = pid_ > 0 && ::waitpid(pid_, &status, WNOHANG) == pid_;
  if (has_ended) pid_ = -1;
  reason_ = has_ended && WIFEXITED(status) && WEXITSTATUS(status) == kNotInstalled
                ? "there is no display, and Xvfb is not installed (Debian: apt install xvfb)"
                : "there is no display, and Xvfb did not start";
}

PrivateDisplay::~PrivateDisplay() {
  if (pid_ <= 0) return;
  ::kill(pid_, SIGTERM);
  ::waitpid(pid_, nullptr, 0);
}

/// The number that Xvfb gives itself, once it takes connections; empty if it ends or takes too long.
std::string PrivateDisplay::read_number(int from) {
  std::string number;
  for (;;) {
    pollfd waiting{from, POLLIN, 0};
    char digit = 0;
    if (::poll(&waiting, 1, kStartMilliseconds) <= 0 || ::read(from, &digit, 1) != 1) break;
    if (digit == '\n') return number;
    number += digit;
  }
  ::usleep(20000);  // its end may come a moment after that of the pipe
  return {};
}

}  // namespace nearwall::io
