#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "nearwall/core/errors.h"
#include "nearwall/io/boundary_file.h"
#include "nearwall/io/mesh_formats.h"
#include "nearwall/io/surface_reader.h"
#include "nearwall/io/surface_writer.h"
#include "nearwall/io/volume_reader.h"
#include "nearwall/surface/weld.h"
#include "program/cli.h"
#include "program/convert_mesh.h"
#include "program/table.h"

namespace nearwall::program {

namespace {

struct ConvertArguments {
  std::string input;
  std::string output;
  std::optional<double> weld;
  std::optional<std::string> boundary;
  bool is_ascii = false;
};

/// Where the names of formats that are files end: those of OpenFOAM come last.
constexpr auto kEndOfFiles = io::kMeshFormatNames.begin() + static_cast<std::size_t>(io::MeshFormat::OpenFoam);

std::string patches_text(std::size_t n) { return fmt::format("{} patch{}", n, n == 1 ? "" : "es"); }

ExitCode convert_surface(const ConvertArguments& arguments, Console& console) {
  if (arguments.boundary || arguments.is_ascii) {
    throw InputError(fmt::format("{} tells how meshes are converted, but {} is a surface",
                                 arguments.boundary ? "--boundary" : "--ascii", arguments.output));
  }
  mesh::SurfaceMesh mesh = staged(console, "reading", [&] { return io::read_surface(arguments.input); });
  if (arguments.weld) mesh = surface::weld(mesh, *arguments.weld);
  console.begin_stage("writing");
  io::write_surface(arguments.output, mesh);
  console.end_stage();
  console.print_json(nlohmann::json{{"file", arguments.output},
                                    {"points", mesh.points.size()},
                                    {"triangles", mesh.faces.size()},
                                    {"patches", mesh.patch_names.raw()}});
  console.print(fmt::format("{}: {} points, {} triangles, {}\n", arguments.output, grouped(mesh.points.size()),
                            grouped(mesh.faces.size()), patches_text(mesh.patch_names.size())));
  return ExitCode::Done;
}

io::MeshFormat format_of(const ConvertArguments& arguments, io::MeshFormat format) {
  if (!arguments.is_ascii) return format;
  if (format == io::MeshFormat::OpenFoam) return io::MeshFormat::OpenFoamAscii;
  throw InputError(
      fmt::format("--ascii: is for OpenFOAM's polyMesh; {} tells its form by its ending "
                  "(.ugrid or .lb8.ugrid, .msh or .msh2)",
                  arguments.output));
}

ExitCode convert_mesh(const ConvertArguments& arguments, io::MeshFormat format, Console& console) {
  if (arguments.weld) throw InputError("--weld makes points of surfaces one; points of meshes stay as they are");
  MeshOfFile mesh = read_mesh(arguments.input, arguments.boundary, console);
  const auto files = write_mesh_as(arguments.output, format_of(arguments, format), mesh, console);
  nlohmann::json cells;
  for (std::size_t type = 0; type < mesh::kNCellTypes; ++type) {
    cells[std::string(mesh::kCellTypeNames[type])] = mesh.n_cells_by_type[type];
  }
  nlohmann::json patches = nlohmann::json::array();
  for (const mesh::BoundaryPatch& patch : mesh.file.boundary.patches) {
    patches.push_back({{"name", patch.name}, {"type", mesh::name_of(patch.type)}});
  }
  const std::size_t n_faces = mesh.file.boundary.faces.size();
  console.print_json(nlohmann::json{{"file", arguments.output},
                                    {"files", files},
                                    {"points", mesh.file.mesh.points.size()},
                                    {"cells", std::move(cells)},
                                    {"boundary_faces", n_faces},
                                    {"patches", std::move(patches)}});
  console.print(fmt::format("{}: {} points, {} cells, {} boundary faces in {}\n", fmt::join(files, ", "),
                            grouped(mesh.file.mesh.points.size()), grouped(mesh.file.mesh.n_cells()), grouped(n_faces),
                            patches_text(mesh.file.boundary.patches.size())));
  return ExitCode::Done;
}

/// Surfaces do not become meshes, nor files of cells alone surfaces. \throws InputError  that says what does
void require_alike(const ConvertArguments& arguments, bool is_to_mesh) {
  const bool is_surface = io::is_surface_name(arguments.input), is_mesh = io::is_volume_name(arguments.input);
  if (is_to_mesh && is_surface && !is_mesh) {
    throw InputError(fmt::format("{}: is a surface, and {} would be a mesh; `nearwall run` makes one of the other",
                                 arguments.input, arguments.output));
  }
  if (!is_to_mesh && is_mesh && !is_surface) {
    throw InputError(
        fmt::format("{}: holds cells alone, which are written as: {}, or a folder polyMesh; its boundary, "
                    "for {}, would be {}",
                    arguments.input, fmt::join(io::kMeshFormatNames.begin(), kEndOfFiles, " "), arguments.output,
                    io::boundary_file_of(arguments.input).string()));
  }
}

ExitCode run_convert(const ConvertArguments& arguments, Console& console) {
  const auto format = io::mesh_format_of(arguments.output);
  require_alike(arguments, format.has_value());
  return format ? convert_mesh(arguments, *format, console) : convert_surface(arguments, console);
}

}  // namespace

void add_convert_command(CommandLine& line) {
  const auto arguments = std::make_shared<ConvertArguments>();
  CLI::App& app = line.add("convert", "a surface or a mesh from one format to another, by the ending of the file",
                           "convert IN OUT [--weld LENGTH] [--boundary FILE.vtp] [--ascii]",
                           "nearwall convert wing.stl wing.vtp --weld 0\n"
                           "nearwall convert out/wing.vtu wing.cgns\n"
                           "nearwall convert out/wing.vtu case/constant/polyMesh\n"
                           "nearwall convert mesh.su2 surface.stl",
                           [arguments](CommandContext& context) { return run_convert(*arguments, context.console); });
  app.add_option("IN", arguments->input,
                 "a surface: stl obj ply off vtp vtk, also gzipped; a mesh: vtu vtk vtkhdf cgns su2 ugrid b8.ugrid "
                 "lb8.ugrid msh bdf, a folder polyMesh")
      ->required();
  app.add_option("OUT", arguments->output,
                 "stl obj ply off vtp vtk: the surface, or the boundary of a mesh; vtu vtkhdf cgns su2 ugrid b8.ugrid "
                 "lb8.ugrid msh msh2, a folder polyMesh: the mesh")
      ->required();
  app.add_option("--weld", arguments->weld,
                 "surfaces: make points within this distance one [length]; 0: equal points; without it: none")
      ->type_name("LENGTH")
      ->check(non_negative());
  app.add_option("--boundary", arguments->boundary,
                 "meshes in vtu and vtkhdf: the patches; default: NAME-boundary.vtp beside, if it is there")
      ->type_name("FILE.vtp");
  app.add_flag("--ascii", arguments->is_ascii, "polyMesh as text; otherwise binary");
}

}  // namespace nearwall::program
