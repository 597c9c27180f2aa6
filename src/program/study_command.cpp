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
#include "nearwall/studies/bohdal.h"
#include "nearwall/studies/ubach.h"
#include "program/cli.h"

namespace nearwall::program {

namespace {

using nlohmann::json;

struct StudyArguments {
  std::string folder;
  studies::UbachOptions ubach;
  studies::BohdalOptions bohdal;
};

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

std::vector<std::string> write_files(const studies::Report& report, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw IoError(fmt::format("{}: cannot make the folder: {}", folder.string(), error.message()));
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

CLI::App& add_study(CommandLine& line, CLI::App& parent, const std::string& name, const std::string& summary,
                    const std::string& usage, const std::shared_ptr<StudyArguments>& arguments, Run run) {
  CLI::App& app = line.add_below(parent, name, summary, fmt::format("study {} [-o DIR] {}", name, usage),
                                 fmt::format("nearwall study {0} -o out/{0}", name),
                                 [arguments, run = std::move(run)](CommandContext& context) {
                                   return deliver(run(*arguments, context), arguments->folder, context.console);
                                 });
  app.add_option("-o,--output", arguments->folder, "folder for the tables as Markdown and the plots as SVG")
      ->type_name("DIR");
  return app;
}

void add_ubach(CommandLine& line, CLI::App& parent) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App& app = add_study(
      line, parent, "ubach", "weights of face normals on random cubic surfaces (Ubach 2013)",
      "[--samples N] [--seed N]", arguments,
      [](const StudyArguments& a, CommandContext& context) { return studies::study_ubach(a.ubach, context.console); });
  app.add_option("--samples", arguments->ubach.samples, "random surfaces of each of the 49 cells")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}))
      ->capture_default_str();
  app.add_option("--seed", arguments->ubach.seed, "of the random numbers")->type_name("N")->capture_default_str();
}

void add_bohdal(CommandLine& line, CLI::App& parent) {
  constexpr int kMostRepetitions = 1000;
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App& app = add_study(
      line, parent, "bohdal", "normals of nine functions over random points, and interpolants from them (Bohdal 2017)",
      "[--repetitions N] [--seed N]", arguments, [](const StudyArguments& a, CommandContext& context) {
        return studies::study_bohdal(a.bohdal, context.console);
      });
  app.add_option("--repetitions", arguments->bohdal.repetitions, "sets of 36 meshes")
      ->type_name("N")
      ->check(CLI::Range(1, kMostRepetitions))
      ->capture_default_str();
  app.add_option("--seed", arguments->bohdal.seed, "of the random points")->type_name("N")->capture_default_str();
}

}  // namespace

void add_study_command(CommandLine& line) {
  CLI::App& app =
      line.add("study", "re-runs the studies of papers on normals, tables and plots", "study NAME [-o DIR] [options]",
               "nearwall study ubach --samples 10000 -o out/ubach", [](CommandContext&) -> ExitCode {
                 throw InputError("study: expected a name\n`nearwall study --help` lists them");
               });
  app.require_subcommand(0, 1);
  add_ubach(line, app);
  add_bohdal(line, app);
}

}  // namespace nearwall::program
