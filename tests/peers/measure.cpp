#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

// measure RESULT PROGRAM [ARGUMENT]...   runs the program and writes to RESULT: its exit code, or −1 if a signal ended
// it; the seconds of processor time and the kilobytes at its peak that it took. Linux counts to a process the memory of
// the one that it was forked from: that is this one, small whatever the tests hold.

namespace {

constexpr int kCannotRun = 127;

double seconds(const timeval& time) {
  constexpr double kMicro = 1e-6;
  return double(time.tv_sec) + kMicro * double(time.tv_usec);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return kCannotRun;
  const pid_t process = fork();
  if (process == 0) {
    execvp(argv[2], argv + 2);
    _exit(kCannotRun);
  }
  int status = 0;
  rusage usage{};
  if (process < 0 || wait4(process, &status, 0, &usage) != process) return kCannotRun;
  std::FILE* result = std::fopen(argv[1], "w");
  if (result == nullptr) return kCannotRun;
  std::fprintf(result, "%d %.6f %ld\n", WIFEXITED(status) ? WEXITSTATUS(status) : -1,
               seconds(usage.ru_utime) + seconds(usage.ru_stime), usage.ru_maxrss);
  return std::fclose(result) == 0 ? 0 : kCannotRun;
}
