#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "nearwall/core/errors.h"
#include "nearwall/io/pending_file.h"
#include "nearwall/io/surface_reader.h"
#include "nearwall/pipeline/case.h"
#include "program/cli.h"

namespace nearwall::program {

namespace {

namespace fs = std::filesystem;

struct InitArguments {
  std::optional<std::string> surface;
  std::optional<std::string> output;
  bool is_forced = false;
};

/// The surface's path as the case file has to name it: relative to its own folder.
fs::path seen_from(const fs::path& case_file, const fs::path& surface) {
  if (surface.is_absolute()) return surface;
  return fs::absolute(surface).lexically_relative(fs::absolute(case_file).parent_path());
}

std::optional<SurfaceFacts> facts_of(const InitArguments& arguments, Console& console) {
  if (!arguments.surface) return std::nullopt;
  const fs::path file = *arguments.surface;
  const auto mesh = staged(console, "reading", [&] { return io::read_surface(file); });
  SurfaceFacts facts = surface_facts(arguments.output ? seen_from(*arguments.output, file) : file, mesh);
  facts.point_arrays = io::point_array_names(file);
  return facts;
}

ExitCode run_init(const InitArguments& arguments, Console& console) {
  if (arguments.output && fs::exists(*arguments.output) && !arguments.is_forced) {
    throw InputError(fmt::format("{}: exists already; --force replaces it", *arguments.output));
  }
  const std::string text = case_template(facts_of(arguments, console));
  if (arguments.output) io::write_text(*arguments.output, text);
  console.print_json(nlohmann::json{{"file", arguments.output ? nlohmann::json(*arguments.output) : nlohmann::json()},
                                    {"case", text}});
  if (!arguments.output) {
    console.print(text);
  } else {
    console.say(fmt::format("{0}: written. Look it over, then: nearwall run {0}", *arguments.output));
  }
  return ExitCode::Done;
}

}  // namespace

void add_init_command(CommandLine& line) {
  const auto arguments = std::make_shared<InitArguments>();
  CLI::App& app = line.add("init", "print a commented case file, with sensible values from the surface if one is given",
                           "init [SURFACE] [-o CASE.toml]",
                           "nearwall init wing.stl > case.toml\nnearwall init wing.stl -o case.toml",
                           [arguments](CommandContext& context) { return run_init(*arguments, context.console); });
  app.add_option("SURFACE", arguments->surface, "the surface that the case is for");
  app.add_option("-o,--output", arguments->output, "write to a file in place of standard output; never over another")
      ->type_name("CASE.toml");
  app.add_flag("--force", arguments->is_forced, "replace the file if it exists");
}

}  // namespace nearwall::program
