#include "tests/program/workplace.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace nearwall::program {

namespace fs = std::filesystem;

namespace {

constexpr const char* kCube = R"(v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
g sides
f 1 2 6
f 1 6 5
f 2 3 7
f 2 7 6
f 3 4 8
f 3 8 7
f 4 1 5
f 4 5 8
g bottom
f 1 3 2
f 1 4 3
g top
f 5 6 7
)";
constexpr const char* kLastTriangle = "f 5 7 8\n";

void redirect(const fs::path& file, int descriptor) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (opened < 0 || dup2(opened, descriptor) < 0) _exit(126);
}

}  // namespace

Workplace::Workplace() {
  std::string name = (fs::temp_directory_path() / "nearwall-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  folder_ = name;
}

Workplace::~Workplace() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Workplace::write(const std::string& name, const std::string& text) const {
  fs::create_directories(path(name).parent_path());
  std::ofstream(path(name)) << text;
}

std::string Workplace::read(const std::string& name) const {
  if (!fs::is_regular_file(path(name))) return "";
  std::ifstream in(path(name));
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::vector<std::string> Workplace::files(const std::string& name) const {
  std::vector<std::string> found;
  if (!has(name)) return found;
  for (const auto& entry : fs::recursive_directory_iterator(path(name))) {
    if (entry.is_regular_file()) found.push_back(entry.path().lexically_relative(path(name)).string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

Outcome Workplace::run(const std::vector<std::string>& arguments) { return wait(start(arguments)); }

pid_t Workplace::start(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {NEARWALL_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  fs::remove(path(".err"));
  const pid_t process = fork();
  if (process == 0) {
    if (chdir(folder_.c_str()) != 0) _exit(126);
    redirect(".out", STDOUT_FILENO);
    redirect(".err", STDERR_FILENO);
    execv(NEARWALL_PROGRAM, argv.data());
    _exit(127);
  }
  return process;
}

Outcome Workplace::wait(pid_t process) {
  int status = 0;
  waitpid(process, &status, 0);
  Outcome outcome;
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  outcome.out = read(".out");
  outcome.err = read(".err");
  return outcome;
}

bool Workplace::has_said(const std::string& text) const {
  for (int i = 0; i < 3000; ++i) {
    if (read(".err").find(text) != std::string::npos) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

void Workplace::write_cube(const std::string& name) const { write(name, std::string(kCube) + kLastTriangle); }

void Workplace::write_open_cube(const std::string& name) const { write(name, kCube); }

void Workplace::write_case(const std::string& name, const std::string& surface, const std::string& more) const {
  write(name, "format = 1\n[surface]\nfile = \"" + surface +
                  "\"\n[layers]\nfirst_height = 0.01\ngrowth = 1.2\ncount = 3\n[output]\npictures = false\n" + more);
}

}  // namespace nearwall::program
