#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "nearwall/core/errors.h"
#include "nearwall/io/surface_reader.h"
#include "nearwall/pipeline/case.h"
#include "nearwall/pipeline/run.h"
#include "program/cli.h"
#include "program/coverage_table.h"
#include "program/relative_lengths.h"
#include "program/table.h"

namespace nearwall::program {

namespace {

namespace fs = std::filesystem;

struct RunArguments {
  std::string file;
  std::optional<std::string> directory;
  std::vector<std::string> overrides;
  bool is_dry_run = false;
  bool is_forced = false;
  bool is_resumed = false;
  bool has_relative_lengths = false;
};

std::string counted_cells(const Report& report) {
  constexpr std::array<const char*, mesh::kNCellTypes> kMany = {"tetrahedra", "pyramids", "wedges", "hexahedra"};
  std::string out;
  for (std::size_t t = 0; t < mesh::kNCellTypes; ++t) {
    if (report.cells[t] == 0) continue;
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", grouped(report.cells[t]),
                       report.cells[t] == 1 ? mesh::kCellTypeNames[t].data() : kMany[t]);
  }
  return out.empty() ? "no cells" : out;
}

std::string shown_path(const fs::path& path) {
  std::error_code error;
  const fs::path relative = fs::relative(path, error);
  return !error && !relative.empty() && *relative.begin() != ".." ? relative.string() : path.string();
}

std::string verdict(const Report& report) {
  if (!report.certified) return "not certified";
  return fmt::format("certified: {} in {}", counted_cells(report), duration(report.seconds()));
}

std::string below_coverage(const Report& report) {
  std::string out;
  for (const PatchReport& patch : report.patches) {
    if (!patch.is_below_min_coverage()) continue;
    out += fmt::format("{}patch '{}': {:.1f} % of its area has all layers, min_coverage asks for {:.1f} %",
                       out.empty() ? "" : "\n", patch.name, patch.coverage.all_layers_percent, patch.min_coverage);
  }
  return out;
}

void print_results(const Report& report, Console& console) {
  console.print(fmt::format("\n{}\n", coverage_table(report, console.manner().is_verbose)));
  if (const std::string at_wall = lines_at_wall(report); !at_wall.empty()) console.print(at_wall + "\n");
  console.print(verdict(report) + "\n");
  std::string files;
  for (const std::string& file : report.files) files += (files.empty() ? "" : ", ") + file;
  console.print(fmt::format("in {}: {}\n", shown_path(report.output_directory), files));
}

/// The report of the complete result that is there already.
std::string stored_report(const fs::path& directory) {
  const fs::path file = directory / "report.json";
  std::ifstream in(file);
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (!in) throw IoError(fmt::format("{}: cannot be read", file.string()));
  return text;
}

void demand_case_file(const std::string& file) {
  if (!io::is_surface_name(file)) return;
  throw InputError(
      fmt::format("{0} is a surface; `run` takes a case file, which names the surface and the layer heights.\nMake one "
                  "with sensible values, look it over, and run it:\n"
                  "  nearwall init {0} > case.toml\n  nearwall run case.toml",
                  file));
}

ExitCode run_case(const RunArguments& arguments, Console& console) {
  demand_case_file(arguments.file);
  Case settings = read_case(arguments.file, arguments.overrides);
  if (arguments.has_relative_lengths) make_lengths_absolute(settings);

  RunOptions options;
  if (arguments.directory) options.output_directory = *arguments.directory;
  options.dry_run = arguments.is_dry_run;
  options.force = arguments.is_forced;
  if (arguments.is_resumed && is_up_to_date(settings, options)) {
    const fs::path directory = options.output_directory.value_or(settings.output_directory());
    console.print(fmt::format("{}: complete already\n", shown_path(directory)));
    if (console.manner().is_json) console.print_json_text(stored_report(directory));
    return ExitCode::Done;
  }

  const Report report = run(settings, options, &console);
  console.print_json_text(to_json(report));
  if (report.dry_run) {
    console.print(
        fmt::format("{}\ndry run: everything is in order, nothing was meshed or written\n", describe(report.forecast)));
    return ExitCode::Done;
  }
  print_results(report, console);
  if (!report.volume_failure.empty()) {
    const bool names_triangles = std::any_of(report.files.begin(), report.files.end(), [](const std::string& file) {
      return file.ends_with("-fill-faults.vtp");
    });
    console.fail(fmt::format("the volume could not be filled: {}\nThe certified layers are written alone{}",
                             report.volume_failure,
                             names_triangles ? "; the file with -fill-faults shows the triangles concerned" : ""));
    return ExitCode::PartMissing;
  }
  if (!report.is_short_of_coverage()) return ExitCode::Done;
  console.fail(below_coverage(report) +
               "\nThe mesh is certified and written; the column 'limited by' tells what is in the way");
  return ExitCode::PartMissing;
}

}  // namespace

void add_run_command(CommandLine& line) {
  const auto arguments = std::make_shared<RunArguments>();
  CLI::App& app = line.add("run", "the main job: from a surface to certified layers, files and report",
                           "run CASE.toml [-o DIR] [--set key=value]... [options]",
                           "nearwall run cases/onera-m6/case.toml\n"
                           "nearwall run case.toml -o out/fine --set layers.first_height=1e-6 --set layers.count=40",
                           [arguments](CommandContext& context) { return run_case(*arguments, context.console); });
  app.add_option("CASE.toml", arguments->file, "case file; `nearwall init SURFACE` writes one")->required();
  app.add_option("-o,--output", arguments->directory, "folder of the results, in place of the case's")
      ->type_name("DIR");
  app.add_option("--set", arguments->overrides,
                 "a key of the case file and its value, dotted: layers.count=20; repeatable")
      ->type_name("KEY=VALUE")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  app.add_flag("--dry-run", arguments->is_dry_run,
               "check everything and forecast cells, memory and disk; write nothing");
  app.add_flag("--force", arguments->is_forced, "write into a folder that holds other things, too");
  app.add_flag("--resume", arguments->is_resumed,
               "do nothing if complete results of the same case, surface and version are there");
  app.add_flag(
      "--relative", arguments->has_relative_lengths,
      "the case's lengths in [layers] and [volume] are multiples of the diagonal of the surface's bounding box");
}

}  // namespace nearwall::program
