#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "nearwall/core/errors.h"
#include "nearwall/io/pending_file.h"
#include "program/batch_plan.h"
#include "program/batch_result.h"
#include "program/cli.h"
#include "program/interrupt.h"
#include "program/table.h"
#include "program/version.h"

namespace nearwall::program {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kPollInterval = std::chrono::milliseconds(10);
constexpr int kMostJobs = 1024;

struct BatchArguments {
  BatchRequest request;
  int n_jobs = 1;
  std::optional<std::string> table_file;
};

/// Runs the items in child processes, so many at a time, and keeps their results in the order of the items.
class BatchRun {
 public:
  BatchRun(const std::vector<BatchItem>& items, int n_jobs, int n_threads, Console& console)
      : items_(items),
        n_jobs_(static_cast<std::size_t>(n_jobs)),
        n_threads_(n_threads),
        console_(console),
        results_(items.size()) {}

  std::vector<BatchResult> results() {
    while (!running_.empty() || (next_ < items_.size() && !is_interrupted())) {
      while (running_.size() < n_jobs_ && next_ < items_.size() && !is_interrupted()) start(next_++);
      std::this_thread::sleep_for(kPollInterval);
      pass_interrupt_on();
      collect();
    }
    for (; next_ < items_.size(); ++next_) results_[next_] = not_run(items_[next_].label);
    return std::move(results_);
  }

 private:
  struct Running {
    std::size_t item;
    std::unique_ptr<ChildProcess> process;
    Clock::time_point begin;
  };

  void start(std::size_t item) {
    std::vector<std::string> arguments = items_[item].arguments;
    arguments.insert(arguments.end(), {"--threads", std::to_string(n_threads_)});
    running_.push_back({item, std::make_unique<ChildProcess>(arguments), Clock::now()});
  }

  void pass_interrupt_on() {
    if (!is_interrupted() || has_passed_on_) return;
    for (const Running& r : running_) r.process->interrupt();
    has_passed_on_ = true;
  }

  void collect() {
    for (Running& r : running_) {
      if (!r.process->has_ended()) continue;
      const double seconds = std::chrono::duration<double>(Clock::now() - r.begin).count();
      results_[r.item] = read_result(items_[r.item].label, r.process->end(), seconds);
      r.process.reset();
      tell(results_[r.item]);
    }
    std::erase_if(running_, [](const Running& r) { return r.process == nullptr; });
  }

  void tell(const BatchResult& result) {
    ++n_ended_;
    console_.say(fmt::format("[{:>{}}/{}] {:<12} {} ({})", n_ended_, std::to_string(items_.size()).size(),
                             items_.size(), result.result, result.label, duration(result.seconds)));
  }

  const std::vector<BatchItem>& items_;
  std::size_t n_jobs_;
  int n_threads_;
  Console& console_;
  std::vector<BatchResult> results_;
  std::vector<Running> running_;
  std::size_t next_ = 0;
  std::size_t n_ended_ = 0;
  bool has_passed_on_ = false;
};

int threads_of_each(int n_threads, int n_jobs) {
  if (n_threads > 0) return n_threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / n_jobs);
}

/// The table as a page of Markdown. It names no path of this machine.
std::string page_of(const Table& table, const std::vector<BatchResult>& results) {
  return fmt::format(
      "# Coverage\n\nMade by `nearwall batch` of version {}. Coverage is the share of the walls' area that has all "
      "layers; "
      "seconds are those of all stages, or until the case failed.\n\n{}.\n\n{}",
      kVersion, tally(results), table.to_markdown());
}

ExitCode run_batch(const BatchArguments& arguments, CommandContext& context) {
  Console& console = context.console;
  const std::vector<BatchItem> items = plan_batch(arguments.request);
  const int n_threads = threads_of_each(context.n_threads, arguments.n_jobs);
  const std::vector<BatchResult> results = BatchRun(items, arguments.n_jobs, n_threads, console).results();

  const Table table = table_of(results);
  console.print_json(json_of(results));
  console.print(fmt::format("{}\n{}\n", table.to_text(), tally(results)));
  if (arguments.table_file) io::write_text(*arguments.table_file, page_of(table, results));
  if (is_interrupted()) {
    console.fail("interrupted");
    return ExitCode::Interrupted;
  }
  const bool is_done = std::all_of(results.begin(), results.end(), [](const BatchResult& r) { return r.is_done(); });
  return is_done ? ExitCode::Done : ExitCode::Fault;
}

}  // namespace

void add_batch_command(CommandLine& line) {
  const auto arguments = std::make_shared<BatchArguments>();
  BatchRequest& request = arguments->request;
  CLI::App& app = line.add("batch", "many cases, each in a process of its own; a table at the end",
                           "batch CASE.toml|DIR... [-j N] [--resume] [options]\n"
                           "  nearwall batch SURFACE|DIR... --template CASE.toml [--relative] [options]",
                           "nearwall batch cases -j 2 --resume\n"
                           "nearwall batch surfaces --template case.toml --relative -o out --table coverage.md",
                           [arguments](CommandContext& context) { return run_batch(*arguments, context); });
  app.add_option("CASE.toml|DIR", request.inputs,
                 "case files and folders to search for them; with --template: surfaces")
      ->required();
  app.add_option("-j,--jobs", arguments->n_jobs, "cases at a time; they share the threads")
      ->type_name("N")
      ->check(CLI::Range(1, kMostJobs))
      ->capture_default_str();
  app.add_flag("--resume", request.is_resumed, "skip what is complete for the same case, surface and version");
  app.add_option("-o,--output", request.directory, "folder of all results, one folder below it for each case")
      ->type_name("DIR");
  app.add_option("--template", request.template_file,
                 "mesh surfaces with this case file: its [surface] file is replaced by each")
      ->type_name("CASE.toml");
  app.add_flag(
      "--relative", request.has_relative_lengths,
      "the template's lengths in [layers] and [volume] are multiples of the diagonal of each surface's bounding box");
  app.add_option("--exclude", request.excluded,
                 "leave out paths or file names that match, as in the shell: '*_domain*'; repeatable")
      ->type_name("PATTERN")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--set", request.overrides, "a key of the case files and its value; repeatable")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--table", arguments->table_file, "write the table as Markdown, too")->type_name("FILE.md");
  app.add_flag("--force", request.is_forced, "write into folders that hold other things, too");
}

}  // namespace nearwall::program
