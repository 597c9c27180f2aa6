#include "tests/peers/child.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace nearwall::peers {

namespace {

constexpr int kCannotRun = 127;

void redirect(const std::string& file, int descriptor) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (opened < 0 || dup2(opened, descriptor) < 0) _exit(kCannotRun);
}

double seconds(const timeval& time) {
  constexpr double kMicro = 1e-6;
  return double(time.tv_sec) + kMicro * double(time.tv_usec);
}

}  // namespace

Run run_program(const std::filesystem::path& folder, std::vector<std::string> words, const std::string& output) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t process = fork();
  if (process == 0) {
    if (chdir(folder.c_str()) != 0) _exit(kCannotRun);
    redirect(output, STDOUT_FILENO);
    redirect(output + ".err", STDERR_FILENO);
    execvp(argv[0], argv.data());
    _exit(kCannotRun);
  }
  int status = 0;
  rusage usage{};
  if (process < 0 || wait4(process, &status, 0, &usage) != process) return {};
  constexpr std::uint64_t kKilobyte = 1024;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, seconds(usage.ru_utime) + seconds(usage.ru_stime),
          kKilobyte * static_cast<std::uint64_t>(usage.ru_maxrss)};
}

}  // namespace nearwall::peers
