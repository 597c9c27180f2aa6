#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "nearwall/core/errors.h"
#include "nearwall/spacing/schedule.h"
#include "nearwall/spacing/wall_units.h"
#include "program/cli.h"
#include "program/table.h"

namespace nearwall::program {

namespace {

constexpr double kAirKinematicViscosity = 1.5e-5;  // [m²/s] of air at 15 °C and 1 atm, to two digits

struct LayersOptions {
  double y_plus = 1;
  double velocity = 0;
  double length = 0;
  double kinematic_viscosity = kAirKinematicViscosity;
  std::optional<double> density;
  std::optional<double> dynamic_viscosity;
  std::optional<double> growth;
  std::optional<int> count;
  std::optional<double> total_thickness;
};

/// Everything the calculator finds out.
struct Calculation {
  double y_plus;
  spacing::FlowConditions flow;
  double reynolds;
  double skin_friction_coefficient;
  double friction_velocity;
  double boundary_layer_thickness;
  spacing::Schedule schedule;
};

double viscosity(const LayersOptions& options) {
  if (options.density.has_value() != options.dynamic_viscosity.has_value()) {
    throw InputError("--density and --dynamic-viscosity belong together: give both, or --kinematic-viscosity");
  }
  if (!options.density) return options.kinematic_viscosity;
  if (!(*options.density > 0)) throw InputError(fmt::format("--density must be positive, not {}", *options.density));
  return *options.dynamic_viscosity / *options.density;
}

Calculation calculate(const LayersOptions& options) {
  Calculation result;
  result.y_plus = options.y_plus;
  result.flow = {options.velocity, viscosity(options), options.length};
  result.reynolds = spacing::reynolds_number(result.flow);
  result.skin_friction_coefficient = spacing::skin_friction_coefficient(result.reynolds);
  result.friction_velocity = spacing::friction_velocity(result.flow);
  result.boundary_layer_thickness = spacing::boundary_layer_thickness(result.flow);

  spacing::ScheduleRequest request;
  request.first_height = spacing::first_cell_height(result.flow, options.y_plus);
  request.growth = options.growth;
  request.count = options.count;
  request.total_thickness = options.total_thickness;
  // With nothing said about where the layers end, they cover the boundary layer.
  if (!request.count && !request.total_thickness) request.total_thickness = result.boundary_layer_thickness;
  if (!request.growth && !(request.count && request.total_thickness)) request.growth = spacing::kDefaultGrowth;
  result.schedule = spacing::solve_schedule(request);
  return result;
}

nlohmann::json to_json(const Calculation& c) {
  return {{"y_plus", c.y_plus},
          {"velocity", c.flow.velocity},
          {"kinematic_viscosity", c.flow.kinematic_viscosity},
          {"reference_length", c.flow.reference_length},
          {"reynolds", c.reynolds},
          {"skin_friction_coefficient", c.skin_friction_coefficient},
          {"friction_velocity", c.friction_velocity},
          {"boundary_layer_thickness", c.boundary_layer_thickness},
          {"first_height", c.schedule.first_height},
          {"growth", c.schedule.growth},
          {"count", c.schedule.count},
          {"total_thickness", c.schedule.total_thickness},
          {"last_height", c.schedule.heights.back()},
          {"heights", c.schedule.heights}};
}

std::string summary(const Calculation& c) {
  Table table({{"quantity"}, {"value", true}, {"of"}});
  const auto row = [&](const char* name, double value, const char* of) {
    table.add_row({name, fmt::format("{:.4g}", value), of});
  };
  row("first height", c.schedule.first_height, "the layer at the wall");
  row("growth", c.schedule.growth, "from layer to layer");
  row("layers", c.schedule.count, "");
  row("total thickness", c.schedule.total_thickness, "all layers");
  row("last height", c.schedule.heights.back(), "the outermost layer");
  row("boundary layer", c.boundary_layer_thickness, "thickness at the end of the length, estimated");
  row("Reynolds number", c.reynolds, "velocity * length / viscosity");
  row("skin friction", c.skin_friction_coefficient, "flat plate, turbulent");
  row("friction velocity", c.friction_velocity, "");
  return table.to_text();
}

std::string case_lines(const Calculation& c) {
  return fmt::format(
      "\nin a case file\n  [layers]\n  first_height = {:.4g}\n  growth       = {:.4g}\n  count        = {}\n",
      c.schedule.first_height, c.schedule.growth, c.schedule.count);
}

std::string stack(const spacing::Schedule& schedule) {
  Table table({{"layer", true}, {"height", true}, {"distance", true}});
  double distance = 0;
  for (std::size_t i = 0; i < schedule.heights.size(); ++i) {
    distance += schedule.heights[i];
    table.add_row({std::to_string(i + 1), fmt::format("{:.5g}", schedule.heights[i]), fmt::format("{:.5g}", distance)});
  }
  return "\n" + table.to_text();
}

ExitCode run_layers(const LayersOptions& options, Console& console) {
  const Calculation result = calculate(options);
  console.print_json(to_json(result));
  console.print(summary(result) + case_lines(result));
  if (console.manner().is_verbose) console.print(stack(result.schedule));
  return ExitCode::Done;
}

}  // namespace

void add_layers_command(CommandLine& line) {
  const auto options = std::make_shared<LayersOptions>();
  CLI::App& app = line.add(
      "layers", "the y+ calculator: first height and layers for a turbulent boundary layer",
      "layers --velocity U --length L [--y-plus 1] [options]",
      "nearwall layers --y-plus 1 --velocity 50 --length 1\n"
      "nearwall layers --velocity 3 --length 2 --density 998 --dynamic-viscosity 1e-3 --growth 1.15 --count 25",
      [options](CommandContext& context) { return run_layers(*options, context.console); });
  app.add_option("--y-plus", options->y_plus, "y+ of the first layer's outer nodes")
      ->type_name("Y")
      ->capture_default_str();
  app.add_option("--velocity", options->velocity, "free stream [length/time]; any consistent units")
      ->type_name("U")
      ->required();
  app.add_option("--length", options->length, "run of the boundary layer [length]: chord, hull or body length")
      ->type_name("L")
      ->required();
  auto* kinematic = app.add_option("--kinematic-viscosity", options->kinematic_viscosity,
                                   "[length^2/time]; the default is that of air in m and s")
                        ->type_name("NU")
                        ->capture_default_str();
  app.add_option("--density", options->density, "[mass/length^3], with --dynamic-viscosity")
      ->type_name("RHO")
      ->excludes(kinematic);
  app.add_option("--dynamic-viscosity", options->dynamic_viscosity, "[mass/(length*time)], with --density")
      ->type_name("MU")
      ->excludes(kinematic);
  app.add_option("--growth", options->growth, "ratio of successive heights; 1.2 unless it follows from the others")
      ->type_name("R");
  app.add_option("--count", options->count, "number of layers; otherwise as many as the thickness takes")
      ->type_name("N");
  app.add_option("--total-thickness", options->total_thickness,
                 "of all layers [length]; with neither this nor --count the layers cover the boundary layer")
      ->type_name("T");
}

}  // namespace nearwall::program
