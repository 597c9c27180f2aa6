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
#include "nearwall/surface/features.h"
#include "nearwall/surface/point_normals.h"
#include "program/cli.h"
#include "program/loaded_surface.h"
#include "program/surface_arguments.h"
#include "program/surface_files.h"
#include "program/table.h"

namespace nearwall::program {

namespace {

struct NormalsArguments {
  SurfaceArguments surface;
  std::string output;
  std::string method = "most-visible";
};

surface::NormalMethod method_of(const std::string& name) {
  if (const auto method = surface::normal_method(name)) return *method;
  const std::vector<std::string> known(surface::kNormalMethodNames.begin(), surface::kNormalMethodNames.end());
  const std::string there_are = fmt::format("{}", fmt::join(known, ", "));
  const std::string near = nearest(name, known);
  throw InputError(fmt::format("--method {}: unknown{}; there are {}", name,
                               near.empty() ? "" : fmt::format("; did you mean '{}'?", near), there_are));
}

using PointNormals = IdVector<VertexId, surface::PointNormal>;

/// The surface with its normals, named as in NAME-surface.vtp, and the ridges as lines.
io::PolyDataFile with_normals(const mesh::SurfaceMesh& mesh, const mesh::Topology& topology,
                              const surface::Features& features, const PointNormals& normals) {
  io::PolyDataFile file = io::polydata_of(mesh);
  std::vector<double> directions, angles, turns;
  std::vector<std::int32_t> kinds;
  for (const VertexId v : normals.ids()) {
    const surface::PointNormal& n = normals[v];
    directions.insert(directions.end(), {n.direction.x(), n.direction.y(), n.direction.z()});
    angles.push_back(geometry::to_degrees(n.max_angle));
    kinds.push_back(static_cast<std::int32_t>(features.kind[v]));
  }
  for (const HalfedgeId h : features.turn.ids()) {
    const HalfedgeId twin = topology.twin(h);
    if (!features.is_ridge[h] || (twin.is_valid() && twin < h)) continue;
    file.lines.push_back({topology.origin(h).index(), topology.target(h).index()});
    turns.push_back(geometry::to_degrees(features.turn[h]));
  }
  file.point_data.push_back({"Normals", std::move(directions), 3});
  file.point_data.push_back({"VisibilityAngle", std::move(angles)});
  file.point_data.push_back({"PointKind", std::move(kinds)});
  file.line_data.push_back({"Turn", std::move(turns)});
  return file;
}

ExitCode run_normals(const NormalsArguments& arguments, Console& console) {
  demand_vtp("--output", arguments.output);
  const surface::NormalMethod method = method_of(arguments.method);
  const LoadedSurface loaded = load_surface(arguments.surface.file, arguments.surface.weld, console);
  const mesh::Topology topology(loaded.mesh);
  const surface::FeatureOptions options{.ridge_angle = geometry::to_radians(arguments.surface.ridge_angle_deg)};
  const auto features =
      staged(console, "features", [&] { return surface::find_features(loaded.mesh, topology, options); });
  const PointNormals normals = staged(
      console, "normals", [&] { return surface::point_normals(loaded.mesh, topology, features, {.method = method}); });
  io::write_polydata(arguments.output, with_normals(loaded.mesh, topology, features, normals));

  const auto n_blind = std::count_if(normals.begin(), normals.end(), [](const auto& n) { return !n.is_visible; });
  double worst = 0;
  for (const surface::PointNormal& n : normals) worst = std::max(worst, geometry::to_degrees(n.max_angle));
  console.print_json(nlohmann::json{{"file", arguments.output},
                                    {"method", arguments.method},
                                    {"points", normals.size()},
                                    {"blind", n_blind},
                                    {"largest_visibility_angle", worst}});
  console.print(fmt::format("{}: {} normals, {} of them blind, largest visibility angle {:.2f} degrees\n",
                            arguments.output, grouped(normals.size()), n_blind, worst));
  return ExitCode::Done;
}

}  // namespace

void add_normals_command(CommandLine& line) {
  const auto arguments = std::make_shared<NormalsArguments>();
  CLI::App& app =
      line.add("normals", "point normals of a surface, closed or open", "normals SURFACE --method M -o OUT.vtp",
               "nearwall normals wing.stl --method most-visible -o normals.vtp",
               [arguments](CommandContext& context) { return run_normals(*arguments, context.console); });
  arguments->surface.add_argument(app);
  app.add_option("-o,--output", arguments->output, "point arrays Normals, VisibilityAngle, PointKind; ridges as lines")
      ->type_name("OUT.vtp")
      ->required();
  app.add_option("--method", arguments->method, "most-visible: sees its worst face best; angle: weighted by angles")
      ->type_name("M")
      ->capture_default_str();
  arguments->surface.add_options(app);
}

}  // namespace nearwall::program
