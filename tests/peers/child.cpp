#include "tests/peers/child.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

namespace nearwall::peers {

namespace {

constexpr int kCannotRun = 127;

void redirect(const std::string& file, int descriptor) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (opened < 0 || dup2(opened, descriptor) < 0) _exit(kCannotRun);
}

}  // namespace

Run run_program(const std::filesystem::path& folder, std::vector<std::string> words, const std::string& output) {
  const std::string result = output + ".run";
  words.insert(words.begin(), {NEARWALL_PEERS_MEASURE, result});
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t process = fork();
  if (process == 0) {
    if (chdir(folder.c_str()) != 0) _exit(kCannotRun);
    redirect(output, STDOUT_FILENO);
    redirect(output + ".err", STDERR_FILENO);
    execv(argv[0], argv.data());
    _exit(kCannotRun);
  }
  int status = 0;
  if (process < 0 || waitpid(process, &status, 0) != process) return {};
  Run run;
  std::uint64_t kilobytes = 0;
  std::ifstream(folder / result) >> run.exit_code >> run.seconds >> kilobytes;
  constexpr std::uint64_t kKilobyte = 1024;
  run.peak_bytes = kKilobyte * kilobytes;
  return run;
}

}  // namespace nearwall::peers
