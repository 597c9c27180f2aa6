#include "program/cli.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/nearest.h"
#include "program/help.h"
#include "program/version.h"

namespace nearwall::program {

namespace {

constexpr int kMaxThreads = 4096;

std::vector<std::string> names_below(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(sub->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& words) {
  const std::string near = nearest(word, words);
  return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
}

/// The command that was reached before parsing stopped, and its name as typed.
const CLI::App* deepest(const CLI::App& app, std::string& path) {
  const auto chosen = app.get_subcommands();
  if (chosen.empty()) return &app;
  path += " " + chosen.back()->get_name();
  return deepest(*chosen.back(), path);
}

/// First word that belongs to nothing, with the nearest that would; empty if there is none.
std::string stray_word(const CLI::App& app) {
  for (const std::string& word : app.remaining()) {
    if (word == "--") continue;
    if (word.starts_with('-') && word.size() > 1) {
      const std::string name = word.substr(0, word.find('='));
      return fmt::format("unknown option '{}'{}", name, did_you_mean(name, option_names(app)));
    }
    const auto names = names_below(app);
    if (!names.empty())
      return fmt::format("unknown {} '{}'{}", app.get_parent() ? app.get_name() : "command", word,
                         did_you_mean(word, names));
    return fmt::format("unexpected argument '{}'", word);
  }
  return "";
}

}  // namespace

CommandLine::CommandLine() : app_("", "nearwall") {
  app_.set_help_flag("-h,--help", "print this");
  app_.add_flag("--version", wants_version_, "print the version");
  app_.formatter(std::make_shared<CLI::FormatterLambda>(
      [](const CLI::App*, const std::string&, CLI::AppFormatMode) { return overview(); }));
  app_.require_subcommand(0, 1);
}

CLI::App& CommandLine::add(const std::string& name, const std::string& summary, const std::string& usage,
                           const std::string& example, Command command) {
  return add_below(app_, name, summary, usage, example, std::move(command));
}

CLI::App& CommandLine::add_below(CLI::App& parent, const std::string& name, const std::string& summary,
                                 const std::string& usage, const std::string& example, Command command) {
  CLI::App& app = *parent.add_subcommand(name, summary);
  app.formatter(help_formatter(usage, example));
  app.set_help_flag("-h,--help", "print this")->group(kCommonGroup);
  app.add_flag("--json", invocation_.manner.is_json, "one JSON object on standard output, talk on standard error")
      ->group(kCommonGroup);
  auto* quiet = app.add_flag("--quiet", invocation_.manner.is_quiet, "results and errors only")->group(kCommonGroup);
  app.add_flag("--verbose", invocation_.manner.is_verbose, "details, too")->group(kCommonGroup)->excludes(quiet);
  app.add_option("--threads", invocation_.n_threads, "threads to use; 0: as many as the machine has")
      ->type_name("N")
      ->check(CLI::Range(0, kMaxThreads))
      ->group(kCommonGroup);
  // A command below another is called back before its parent.
  app.callback([this, run = std::move(command)] {
    if (!invocation_.command) invocation_.command = run;
  });
  return app;
}

Invocation CommandLine::parse(int argc, const char* const* argv) {
  try {
    app_.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::string path;
    invocation_.command = nullptr;
    invocation_.text = deepest(app_, path)->help();
    return invocation_;
  } catch (const CLI::ParseError& e) {
    std::string path = "nearwall";
    const CLI::App* app = deepest(app_, path);
    const std::string stray = stray_word(*app);
    throw InputError(fmt::format("{}\n`{} --help` shows what it takes", stray.empty() ? e.what() : stray, path));
  }
  if (wants_version_) {
    invocation_.text = fmt::format("nearwall {}\n", kVersion);
  } else if (!invocation_.command) {
    invocation_.text = overview();
  }
  return invocation_;
}

CLI::Validator non_negative() {
  return CLI::Validator(
      [](const std::string& text) {
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool is_number = error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
        return is_number && value >= 0 ? std::string() : fmt::format("expected a number of at least 0, found {}", text);
      },
      "");
}

Manner manner_of(int argc, const char* const* argv) {
  const auto has = [&](std::string_view word) { return std::find(argv, argv + argc, word) != argv + argc; };
  return {.is_json = has("--json"), .is_quiet = has("--quiet"), .is_verbose = false};
}

}  // namespace nearwall::program
