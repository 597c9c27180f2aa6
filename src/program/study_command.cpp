#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "nearwall/core/errors.h"
#include "nearwall/io/pending_file.h"
#include "nearwall/studies/aubry_lohner.h"
#include "nearwall/studies/bohdal.h"
#include "nearwall/studies/ubach.h"
#include "program/cli.h"
#include "program/help.h"

namespace nearwall::program {

namespace {

using nlohmann::json;

constexpr int kMostRepetitions = 1000;

struct StudyArguments {
  std::string folder;
  studies::UbachOptions ubach;
  studies::BohdalOptions bohdal;
  studies::AubryLohnerOptions aubry_lohner;
};

/// Name and summary of each study.
struct StudyInfo {
  const char* name;
  const char* summary;
};
constexpr StudyInfo kUbach = {"ubach", "weights of face normals on random cubic surfaces (Ubach 2013)"};
constexpr StudyInfo kBohdal = {"bohdal", "normals of nine functions over random points, interpolants (Bohdal 2017)"};
constexpr StudyInfo kAubryLohner = {"aubry-lohner",
                                    "smoothing on bodies with many ridges, timed (Aubry & Löhner 2008)"};

ExitCode list_studies(Console& console) {
  json list = json::array();
  std::string text = "studies\n";
  for (const StudyInfo& study : {kUbach, kBohdal, kAubryLohner}) {
    list.push_back({{"name", study.name}, {"summary", study.summary}});
    text += entry(study.name, study.summary);
  }
  console.print_json(json{{"studies", list}});
  console.print(text + "\nnearwall study NAME --help lists the options of a study\n");
  return ExitCode::Done;
}

json json_of(const studies::Table& table) {
  json rows = json::array();
  for (const auto& row : table.rows) {
    json values = json::array();
    // JSON has no NaN: a number that is not there is null.
    for (const double value : row.values) values.push_back(std::isnan(value) ? json() : json(value));
    rows.push_back({{"name", row.name}, {"values", values}});
  }
  return {{"title", table.title}, {"row_title", table.row_title}, {"columns", table.columns}, {"rows", rows}};
}

/// Before the study runs: nobody wants to wait for results that cannot be written.
void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw IoError(fmt::format("{}: cannot make the folder: {}", folder.string(), error.message()));
}

std::vector<std::string> write_files(const studies::Report& report, const std::filesystem::path& folder) {
  std::vector<std::string> files;
  const auto write = [&](const std::string& name, const std::string& text) {
    io::write_text(folder / name, text);
    files.push_back((folder / name).string());
  };
  for (const studies::Picture& picture : report.pictures) write(picture.file, picture.svg);
  write(fmt::format("study-{}.md", report.name), studies::to_markdown(report));
  return files;
}

/// Shows the tables, or writes them with the plots if there is a folder.
ExitCode deliver(const studies::Report& report, const std::string& folder, Console& console) {
  json result = {
      {"study", report.name}, {"settings", report.settings}, {"tables", json::array()}, {"files", json::array()}};
  for (const studies::Table& table : report.tables) result["tables"].push_back(json_of(table));
  std::string text = report.settings + "\n";
  if (folder.empty()) {
    for (const studies::Table& table : report.tables) text += "\n" + studies::to_markdown(table);
  } else {
    const auto files = write_files(report, folder);
    result["files"] = files;
    for (const std::string& file : files) text += file + "\n";
  }
  console.print_json(result);
  console.print(text);
  return ExitCode::Done;
}

using Run = std::function<studies::Report(const StudyArguments&, CommandContext&)>;

CLI::App& add_study(CommandLine& line, CLI::App& parent, const StudyInfo& study, const std::string& usage,
                    const std::shared_ptr<StudyArguments>& arguments, Run run) {
  CLI::App& app =
      line.add_below(parent, study.name, study.summary, fmt::format("study {} [-o DIR] {}", study.name, usage),
                     fmt::format("nearwall study {0} -o out/{0}", study.name),
                     [arguments, run = std::move(run)](CommandContext& context) {
                       if (!arguments->folder.empty()) make_folder(arguments->folder);
                       return deliver(run(*arguments, context), arguments->folder, context.console);
                     });
  app.add_option("-o,--output", arguments->folder, "folder for the tables as Markdown and the plots as SVG")
      ->type_name("DIR");
  return app;
}

void add_ubach(CommandLine& line, CLI::App& parent) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App& app = add_study(
      line, parent, kUbach, "[--samples N] [--seed N]", arguments,
      [](const StudyArguments& a, CommandContext& context) { return studies::study_ubach(a.ubach, context.console); });
  app.add_option("--samples", arguments->ubach.samples, "random surfaces of each of the 49 cells")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{100'000'000}))
      ->capture_default_str();
  app.add_option("--seed", arguments->ubach.seed, "of the random numbers")->type_name("N")->capture_default_str();
}

void add_bohdal(CommandLine& line, CLI::App& parent) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App& app = add_study(line, parent, kBohdal, "[--repetitions N] [--seed N]", arguments,
                            [](const StudyArguments& a, CommandContext& context) {
                              return studies::study_bohdal(a.bohdal, context.console);
                            });
  app.add_option("--repetitions", arguments->bohdal.repetitions, "sets of 36 meshes")
      ->type_name("N")
      ->check(CLI::Range(1, kMostRepetitions))
      ->capture_default_str();
  app.add_option("--seed", arguments->bohdal.seed, "of the random points")->type_name("N")->capture_default_str();
}

void add_aubry_lohner(CommandLine& line, CLI::App& parent) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App& app = add_study(line, parent, kAubryLohner, "[--repetitions N]", arguments,
                            [](const StudyArguments& a, CommandContext& context) {
                              return studies::study_aubry_lohner(a.aubry_lohner, context.console);
                            });
  app.add_option("--repetitions", arguments->aubry_lohner.repetitions, "of each measurement, whose median counts")
      ->type_name("N")
      ->check(CLI::Range(1, kMostRepetitions))
      ->capture_default_str();
}

}  // namespace

void add_study_command(CommandLine& line) {
  CLI::App& app = line.add("study", "runs the studies of papers on normals again, with tables and plots",
                           "study                      the list of studies\n"
                           "  nearwall study NAME [-o DIR] [options]",
                           "nearwall study ubach --samples 10000 -o out/ubach",
                           [](CommandContext& context) { return list_studies(context.console); });
  app.require_subcommand(0, 1);
  add_ubach(line, app);
  add_bohdal(line, app);
  add_aubry_lohner(line, app);
}

}  // namespace nearwall::program
