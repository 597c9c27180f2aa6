#include <algorithm>
#include <array>
#include <memory>
#include <numbers>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "nearwall/core/errors.h"
#include "nearwall/core/nearest.h"
#include "nearwall/io/polydata_writer.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/surface/features.h"
#include "nearwall/surface/normals.h"
#include "program/cli.h"
#include "program/loaded_surface.h"
#include "program/surface_files.h"
#include "program/table.h"

namespace nearwall::program {

namespace {

constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

struct NormalsArguments {
  std::string file;
  std::string output;
  std::string method = "most-visible";
  double weld = 0;
  double ridge_angle_deg = 40;
};

/// Methods of later versions.
constexpr std::array kLaterMethods = {"uniform",
                                      "area",
                                      "inverse-area",
                                      "projected-area",
                                      "little-1",
                                      "little-1/2",
                                      "little-2",
                                      "max",
                                      "little-max",
                                      "inverse-diameter",
                                      "angle-over-diameter",
                                      "inverse-circumarea",
                                      "angle-over-circumarea",
                                      "most-normal",
                                      "kallinderis",
                                      "pirzadeh",
                                      "iterative",
                                      "thin-plate",
                                      "hardy",
                                      "shepard",
                                      "linear-fit",
                                      "quadratic-fit",
                                      "renka-cline",
                                      "nielson"};

surface::NormalMethod method_of(const std::string& name) {
  if (name == "most-visible") return surface::NormalMethod::MostVisible;
  if (name == "angle") return surface::NormalMethod::Angle;
  if (std::find(kLaterMethods.begin(), kLaterMethods.end(), name) != kLaterMethods.end()) {
    throw InputError(fmt::format("--method {}: not in this version, which has most-visible and angle", name));
  }
  const std::array<std::string, 2> known = {"most-visible", "angle"};
  const std::string near = nearest(name, known);
  throw InputError(fmt::format("--method {}: unknown{}; there are most-visible and angle", name,
                               near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
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
    angles.push_back(n.max_angle * kDegreesPerRadian);
    kinds.push_back(static_cast<std::int32_t>(features.kind[v]));
  }
  for (const HalfedgeId h : features.turn.ids()) {
    const HalfedgeId twin = topology.twin(h);
    if (!features.is_ridge[h] || (twin.is_valid() && twin < h)) continue;
    file.lines.push_back({topology.origin(h).index(), topology.target(h).index()});
    turns.push_back(features.turn[h] * kDegreesPerRadian);
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
  const LoadedSurface loaded = load_surface(arguments.file, arguments.weld, console);
  const mesh::Topology topology(loaded.mesh);
  const surface::FeatureOptions options{.ridge_angle = arguments.ridge_angle_deg / kDegreesPerRadian};
  const auto features =
      staged(console, "features", [&] { return surface::find_features(loaded.mesh, topology, options); });
  const PointNormals normals =
      staged(console, "normals", [&] { return surface::point_normals(loaded.mesh, topology, features, method); });
  io::write_polydata(arguments.output, with_normals(loaded.mesh, topology, features, normals));

  const auto n_blind = std::count_if(normals.begin(), normals.end(), [](const auto& n) { return !n.is_visible; });
  double worst = 0;
  for (const surface::PointNormal& n : normals) worst = std::max(worst, n.max_angle * kDegreesPerRadian);
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
  app.add_option("SURFACE", arguments->file, "stl, obj, ply, off, vtp or vtk, also gzipped")->required();
  app.add_option("-o,--output", arguments->output, "point arrays Normals, VisibilityAngle, PointKind; ridges as lines")
      ->type_name("OUT.vtp")
      ->required();
  app.add_option("--method", arguments->method, "most-visible: sees its worst face best; angle: weighted by angles")
      ->type_name("M")
      ->capture_default_str();
  app.add_option("--weld", arguments->weld, "distance within which points become one [length]; 0: equal points only")
      ->type_name("LENGTH")
      ->check(non_negative())
      ->capture_default_str();
  app.add_option("--ridge-angle", arguments->ridge_angle_deg, "turn from which an edge is a ridge [deg]")
      ->type_name("DEG")
      ->check(CLI::Range(0.0, 180.0))
      ->capture_default_str();
}

}  // namespace nearwall::program
