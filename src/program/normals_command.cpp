#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "nearwall/core/errors.h"
#include "nearwall/core/nearest.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/io/polydata_writer.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/surface/smoothing.h"
#include "program/cli.h"
#include "program/loaded_surface.h"
#include "program/normals_file.h"
#include "program/surface_arguments.h"
#include "program/surface_files.h"
#include "program/table.h"

namespace nearwall::program {

namespace {

struct NormalsArguments {
  SurfaceArguments surface;
  std::string output;
  std::string method = "most-visible";
  std::string unsuitable = "keep";
  double thin_angle_deg = surface::kThinAngleInDegrees;
  std::string filter = "none";
  int iterations = 5;
  std::string per = "vertex";
  double multi_angle_deg = 100;
};

template <class Names>
[[noreturn]] void reject(const char* option, const std::string& name, const Names& names) {
  const std::vector<std::string> known(names.begin(), names.end());
  const std::string near = nearest(name, known);
  throw InputError(fmt::format("{} {}: unknown{}; there are {}", option, name,
                               near.empty() ? "" : fmt::format("; did you mean '{}'?", near), fmt::join(known, ", ")));
}

surface::NormalOptions normal_options(const NormalsArguments& arguments) {
  const auto method = surface::normal_method(arguments.method);
  if (!method) reject("--method", arguments.method, surface::kNormalMethodNames);
  return {.method = *method,
          .thin_angle = geometry::to_radians(arguments.thin_angle_deg),
          .unsuitable = arguments.unsuitable == "keep"          ? surface::Unsuitable::Keep
                        : arguments.unsuitable == "at-boundary" ? surface::Unsuitable::DropAtBoundary
                                                                : surface::Unsuitable::DropEverywhere};
}

surface::SmoothingOptions smoothing_options(const NormalsArguments& arguments) {
  const auto filter = surface::smoothing_filter(arguments.filter);
  if (!filter) reject("--filter", arguments.filter, surface::kSmoothingFilterNames);
  return {.filter = *filter, .iterations = arguments.iterations};
}

ExitCode run_normals(const NormalsArguments& arguments, Console& console) {
  demand_vtp("--output", arguments.output);
  const surface::NormalOptions options = normal_options(arguments);
  const surface::SmoothingOptions smoothing = smoothing_options(arguments);
  if (arguments.per != "vertex" && !surface::is_for_runs(options.method)) {
    throw InputError(
        fmt::format("--per {}: --method {} needs all of what is round a vertex; leave --per out, or take a "
                    "weight, most-visible, kallinderis, pirzadeh or iterative",
                    arguments.per, arguments.method));
  }
  if (arguments.per != "vertex" && smoothing.filter != surface::SmoothingFilter::None) {
    throw InputError(fmt::format("--filter {}: smooths one normal for each vertex; leave it out, or --per {}",
                                 arguments.filter, arguments.per));
  }
  const LoadedSurface loaded = load_surface(arguments.surface.file, arguments.surface.weld, console);
  const mesh::Topology topology(loaded.mesh);
  const surface::FeatureOptions feature_options{.ridge_angle = geometry::to_radians(arguments.surface.ridge_angle_deg)};
  const auto features =
      staged(console, "features", [&] { return surface::find_features(loaded.mesh, topology, feature_options); });
  const NormalsSource source{
      loaded.mesh, topology, features, options, {.multi_angle = geometry::to_radians(arguments.multi_angle_deg)}};
  const ShownNormals shown = staged(console, "normals", [&] {
    return arguments.per == "vertex"  ? normals_of_vertices(source, smoothing)
           : arguments.per == "patch" ? normals_of_runs(source, surface::Separation::DiscretePatches)
                                      : normals_of_runs(source, surface::Separation::Groups);
  });
  io::write_polydata(arguments.output, shown.file);

  console.print_json(nlohmann::json{{"file", arguments.output},
                                    {"method", arguments.method},
                                    {"points", shown.n_normals},
                                    {"blind", shown.n_blind},
                                    {"fallbacks", shown.n_fallbacks},
                                    {"largest_visibility_angle", geometry::to_degrees(shown.worst_angle)}});
  std::string text =
      fmt::format("{}: {} normals, {} of them blind, largest visibility angle {:.2f} degrees\n", arguments.output,
                  grouped(shown.n_normals), grouped(shown.n_blind), geometry::to_degrees(shown.worst_angle));
  if (shown.n_fallbacks > 0) {
    text += fmt::format("{} where {} has no answer: another method stands in (point array Fallback)\n",
                        grouped(shown.n_fallbacks), arguments.method);
  }
  console.print(text);
  return ExitCode::Done;
}

void add_method_options(CLI::App& app, NormalsArguments& arguments) {
  app.add_option("--method", arguments.method, fmt::format("{}", fmt::join(surface::kNormalMethodNames, ", ")))
      ->type_name("M")
      ->capture_default_str();
  app.add_option("--thin-angle", arguments.thin_angle_deg,
                 "boundary triangles with a wider corner are left out of means [deg]; 180: none")
      ->type_name("DEG")
      ->check(CLI::Range(60.0, 180.0))
      ->capture_default_str();
  app.add_option("--unsuitable", arguments.unsuitable,
                 "face normals that differ much from the others: keep, or drop them from means at-boundary, everywhere")
      ->type_name("RULE")
      ->check(CLI::IsMember({"keep", "at-boundary", "everywhere"}))
      ->capture_default_str();
  CLI::Option* filter = app.add_option("--filter", arguments.filter,
                                       fmt::format("smoothing: {}", fmt::join(surface::kSmoothingFilterNames, ", ")))
                            ->type_name("F")
                            ->capture_default_str();
  app.add_option("--iterations", arguments.iterations, "sweeps of the filter")
      ->type_name("N")
      ->check(CLI::Range(0, 1000))
      ->needs(filter)
      ->capture_default_str();
  app.add_option(
         "--per", arguments.per,
         "one normal for each vertex, for each discrete patch of it (between ridges), or for each group (between "
         "ridges that get several lines)")
      ->type_name("WHAT")
      ->check(CLI::IsMember({"vertex", "patch", "group"}))
      ->capture_default_str();
  app.add_option("--multi-angle", arguments.multi_angle_deg, "turn from which a convex ridge gets several lines [deg]")
      ->type_name("DEG")
      ->check(CLI::Range(1.0, 179.0))
      ->capture_default_str();
}

}  // namespace

void add_normals_command(CommandLine& line) {
  const auto arguments = std::make_shared<NormalsArguments>();
  CLI::App& app =
      line.add("normals", "point normals of a surface, closed or open", "normals SURFACE -o OUT.vtp [options]",
               "nearwall normals wing.stl --method most-visible -o normals.vtp",
               [arguments](CommandContext& context) { return run_normals(*arguments, context.console); });
  arguments->surface.add_argument(app);
  app.add_option("-o,--output", arguments->output,
                 "point arrays Normals, VisibilityAngle, PointKind, Patches, Groups, Fallback, Vertex; ridges as lines")
      ->type_name("OUT.vtp")
      ->required();
  add_method_options(app, *arguments);
  arguments->surface.add_options(app);
}

}  // namespace nearwall::program
