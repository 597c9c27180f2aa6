#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/box.h"
#include "nearwall/io/polydata_writer.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/pipeline/faults_file.h"
#include "nearwall/surface/admission.h"
#include "nearwall/surface/features.h"
#include "nearwall/surface/point_normals.h"
#include "program/cli.h"
#include "program/loaded_surface.h"
#include "program/surface_arguments.h"
#include "program/surface_files.h"
#include "program/table.h"

namespace nearwall::program {

namespace {

using nlohmann::json;
using surface::Admission;
using surface::Fault;
using surface::PointKind;

struct CheckArguments {
  SurfaceArguments surface;
  std::optional<std::string> output;
  std::string fluid = "outside";
};

/// Counts of the features of a surface on which they can be told.
struct FeatureCounts {
  std::size_t convex = 0, concave = 0;  // ridges
  std::size_t corners = 0, ridge_ends = 0, tips = 0, blind = 0;
};

/// The surface with its faces turned to the fluid, as far as that can be told of one that cannot be used: admission
/// turns the others itself.
mesh::SurfaceMesh facing_fluid(const Admission& admission, surface::FluidSide fluid) {
  mesh::SurfaceMesh mesh = admission.surface;
  if (admission.is_usable() || admission.face_component.empty()) return mesh;
  for (const FaceId f : mesh.faces.ids()) {
    const surface::Component& part = admission.components[admission.face_component[f]];
    const bool is_inside_out = part.depth % 2 == 0 ? part.volume < 0 : part.volume > 0;
    const bool is_seen_from_inside = fluid == surface::FluidSide::Inside && part.is_wetted;
    if (is_inside_out != is_seen_from_inside) std::swap(mesh.faces[f][1], mesh.faces[f][2]);
  }
  return mesh;
}

/// nullopt: the surface is not manifold, so that a vertex has no ring to look at.
std::optional<FeatureCounts> count_features(const mesh::SurfaceMesh& mesh, double ridge_angle) try {
  const mesh::Topology topology(mesh);
  const surface::Features features = surface::find_features(mesh, topology, {.ridge_angle = ridge_angle});
  const auto normals = surface::point_normals(mesh, topology, features);
  const auto count = [&](PointKind kind) {
    return static_cast<std::size_t>(std::count(features.kind.begin(), features.kind.end(), kind));
  };
  FeatureCounts counts;
  counts.convex = features.n_convex;
  counts.concave = features.n_concave;
  counts.corners = count(PointKind::Corner);
  counts.ridge_ends = count(PointKind::RidgeEnd);
  counts.tips = count(PointKind::Tip);
  counts.blind = static_cast<std::size_t>(
      std::count_if(normals.begin(), normals.end(), [](const surface::PointNormal& n) { return !n.is_visible; }));
  return counts;
} catch (const GeometryError&) {
  return std::nullopt;
}

json json_of(const Fault& fault) {
  json where = json::array(), triangles = json::array();
  for (const Vec3& p : fault.where) where.push_back({p.x(), p.y(), p.z()});
  for (const FaceId f : fault.triangles) triangles.push_back(f.index());
  return {{"kind", surface::fault_name(fault.kind)},
          {"count", fault.count},
          {"where", where},
          {"triangles", triangles},
          {"patch", fault.patch},
          {"advice", fault.advice}};
}

json json_of(const Admission& admission, const mesh::SurfaceMesh& mesh, const std::optional<FeatureCounts>& counts) {
  json faults = json::array();
  for (const Fault& fault : admission.faults) faults.push_back(json_of(fault));
  json out = {{"usable", admission.is_usable()},
              {"points", mesh.points.size()},
              {"triangles", mesh.faces.size()},
              {"components", admission.components.size()},
              {"faults", faults}};
  out["ridges"] = counts ? json{{"convex", counts->convex}, {"concave", counts->concave}} : json();
  out["corners"] = counts ? json(counts->corners) : json();
  out["ridge_ends"] = counts ? json(counts->ridge_ends) : json();
  out["tips"] = counts ? json(counts->tips) : json();
  out["blind"] = counts ? json(counts->blind) : json();
  out["closing_tolerance"] = admission.closing_tolerance > 0 ? json(admission.closing_tolerance) : json();
  return out;
}

std::string place(const Vec3& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z()); }

std::string facts(const LoadedSurface& loaded, const Admission& admission, const std::optional<FeatureCounts>& counts,
                  double ridge_angle_deg) {
  const geometry::Box box = geometry::bounding_box(std::span(loaded.mesh.points.raw()));
  const auto n_unwetted = std::count_if(admission.components.begin(), admission.components.end(),
                                        [](const surface::Component& c) { return !c.is_wetted; });
  std::string out = fmt::format("  points      {} ({} in the file)\n", grouped(loaded.mesh.points.size()),
                                grouped(loaded.n_points_read));
  out += fmt::format("  triangles   {}\n", grouped(loaded.mesh.faces.size()));
  out += fmt::format("  patches     {}\n", loaded.mesh.patch_names.size());
  if (!admission.components.empty()) {
    out += fmt::format("  components  {}{}\n", admission.components.size(),
                       n_unwetted > 0 ? fmt::format(", {} of them out of the fluid's reach", n_unwetted) : "");
  }
  out += fmt::format("  box         {} to {}\n", place(box.low), place(box.high));
  if (!counts) return out + "  features    cannot be told: the surface is not manifold\n";
  out += fmt::format("  ridges      {} convex, {} concave edges, seen from the fluid (turn of {} degrees and more)\n",
                     grouped(counts->convex), grouped(counts->concave), ridge_angle_deg);
  out += fmt::format("  points of   {} corners, {} ridge ends, {} tips\n", grouped(counts->corners),
                     grouped(counts->ridge_ends), grouped(counts->tips));
  return out + fmt::format("  blind       {} points that no direction sees all faces of\n", grouped(counts->blind));
}

std::string faults(const Admission& admission) {
  std::string out;
  for (const Fault& fault : admission.faults) {
    out += fmt::format("  {}: {}", surface::fault_name(fault.kind), grouped(fault.count));
    if (!fault.patch.empty()) out += fmt::format(" on patch '{}'", fault.patch);
    if (!fault.triangles.empty()) out += fmt::format(", triangle {}", fault.triangles.front().index());
    if (!fault.where.empty()) out += fmt::format(", at {}", place(fault.where.front()));
    out += fmt::format("\n    {}\n", fault.advice);
  }
  return out;
}

ExitCode run_check(const CheckArguments& arguments, Console& console) {
  if (arguments.output) demand_vtp("--output", *arguments.output);
  const LoadedSurface loaded = load_surface(arguments.surface.file, arguments.surface.weld, console);
  surface::AdmissionPolicy policy;
  policy.fluid = arguments.fluid == "inside" ? surface::FluidSide::Inside : surface::FluidSide::Outside;
  const Admission admission = staged(console, "inspecting", [&] { return surface::inspect(loaded.mesh, policy); });
  const auto counts = staged(console, "features", [&] {
    return count_features(facing_fluid(admission, policy.fluid),
                          geometry::to_radians(arguments.surface.ridge_angle_deg));
  });

  console.print_json(json_of(admission, loaded.mesh, counts));
  console.print(fmt::format("{}: {}\n{}", arguments.surface.file,
                            admission.is_usable() ? "usable" : "cannot be used as it is",
                            facts(loaded, admission, counts, arguments.surface.ridge_angle_deg)));
  if (admission.is_usable()) {
    if (arguments.output) console.say("there are no offending triangles to write");
    return ExitCode::Done;
  }
  console.print("faults\n" + faults(admission));
  if (arguments.output) {
    io::write_polydata(*arguments.output, pipeline::faults_file(loaded.mesh, admission.faults));
    console.print(fmt::format("the triangles concerned: {}\n", *arguments.output));
  }
  return ExitCode::Fault;
}

}  // namespace

void add_check_command(CommandLine& line) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App& app = line.add("check", "what is wrong with a surface, and what its edges are like; nothing is changed",
                           "check SURFACE [-o FILE.vtp] [options]", "nearwall check wing.stl -o faults.vtp",
                           [arguments](CommandContext& context) { return run_check(*arguments, context.console); });
  arguments->surface.add_argument(app);
  app.add_option("-o,--output", arguments->output, "write the offending triangles, with the cell array Fault")
      ->type_name("FILE.vtp");
  app.add_option("--fluid", arguments->fluid, "side of the wall on which the fluid lies")
      ->type_name("outside|inside")
      ->check(CLI::IsMember({"outside", "inside"}))
      ->capture_default_str();
  arguments->surface.add_options(app);
}

}  // namespace nearwall::program
