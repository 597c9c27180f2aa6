#include "program/child_process.h"

#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "program/exit_codes.h"

extern char** environ;

namespace nearwall::program {

namespace {

constexpr const char* kThisProgram = "/proc/self/exe";

int file_in_memory(const char* name) {
  const int file = memfd_create(name, MFD_CLOEXEC);
  if (file < 0) throw IoError(fmt::format("no memory for the output of a child process: {}", std::strerror(errno)));
  return file;
}

std::string content_of(int file) {
  std::string text;
  char block[65536];
  lseek(file, 0, SEEK_SET);
  for (ssize_t n = read(file, block, sizeof block); n > 0; n = read(file, block, sizeof block)) {
    text.append(block, static_cast<std::size_t>(n));
  }
  return text;
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& arguments)
    : output_(file_in_memory("output")), talk_(file_in_memory("talk")) {
  std::vector<std::string> words = {"nearwall"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", 0, 0);
  posix_spawn_file_actions_adddup2(&actions, output_, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, talk_, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  // A group of its own: Ctrl-C on the terminal reaches the parent alone, which passes it on once.
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int error = posix_spawn(&pid_, kThisProgram, &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    close(output_);
    close(talk_);
    throw IoError(fmt::format("a child process cannot be started: {}", std::strerror(error)));
  }
}

ChildProcess::~ChildProcess() {
  if (!has_ended_) {
    kill(pid_, SIGKILL);
    waitpid(pid_, &status_, 0);
  }
  close(output_);
  close(talk_);
}

bool ChildProcess::has_ended() {
  if (!has_ended_) has_ended_ = waitpid(pid_, &status_, WNOHANG) == pid_;
  return has_ended_;
}

void ChildProcess::interrupt() const {
  if (!has_ended_) kill(pid_, SIGINT);
}

ChildEnd ChildProcess::end() const {
  ChildEnd end;
  end.exit_code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 0;
  if (WIFSIGNALED(status_)) end.signal = WTERMSIG(status_);
  if (end.signal == SIGINT) {
    // The interrupt came before the child could take it in hand: it stopped all the same.
    end.signal = 0;
    end.exit_code = static_cast<int>(ExitCode::Interrupted);
  }
  end.output = content_of(output_);
  end.talk = content_of(talk_);
  return end;
}

}  // namespace nearwall::program
