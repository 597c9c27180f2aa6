#include <memory>
#include <optional>

#include <fmt/format.h>

#include "nearwall/certify/mesh_certificate.h"
#include "nearwall/certify/wall_match.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/surface_reader.h"
#include "nearwall/io/volume_reader.h"
#include "nearwall/quality/wall_layers.h"
#include "program/certify_files.h"
#include "program/certify_report.h"
#include "program/cli.h"
#include "program/table.h"

namespace nearwall::program {

namespace {

struct CertifyArguments {
  std::string file;
  std::vector<std::string> outputs;
  std::size_t n_offenders = 10;
  std::optional<std::string> wall;
  std::optional<std::uint32_t> layers;
  std::optional<double> first_height;
};

enum class OutputKind { Cells, Faces };

OutputKind kind_of_output(const std::string& name) {
  if (name.ends_with(".vtu")) return OutputKind::Cells;
  if (name.ends_with(".vtp")) return OutputKind::Faces;
  throw InputError(fmt::format("--output {}: expected a name that ends in .vtu, for cells, or .vtp, for faces", name));
}

void check_arguments(const CertifyArguments& arguments) {
  for (const std::string& name : arguments.outputs) {
    kind_of_output(name);
    std::error_code ignored;
    if (std::filesystem::equivalent(name, arguments.file, ignored)) {
      throw InputError(fmt::format("--output {}: that is the mesh itself", name));
    }
  }
  if (!arguments.wall && (arguments.layers || arguments.first_height)) {
    throw InputError("--layers and --first-height tell about the layers on a wall: they need --wall SURFACE");
  }
}

io::VolumeFile read_mesh(const CertifyArguments& arguments) {
  io::VolumeFile file = io::read_volume_mesh(arguments.file);
  if (file.mesh.n_cells() > 0) return file;
  throw InputError(fmt::format(
      "{}: expected tetrahedra, pyramids, wedges or hexahedra to certify, found none{}", arguments.file,
      file.skipped.faces > 0 ? fmt::format(", but {} faces; `nearwall check` looks at surfaces", file.skipped.faces)
                             : std::string()));
}

WallReport look_at_wall(const CertifyArguments& arguments, const mesh::VolumeMesh& mesh,
                        const certify::MeshCertificate& certificate) {
  WallReport wall;
  wall.file = *arguments.wall;
  wall.surface = io::read_surface(wall.file);
  wall.match = certify::match_wall(mesh, certificate.faces.boundary, wall.surface);
  wall.patches = quality::wall_layers(mesh, wall.surface, wall.match.face, arguments.layers);
  wall.asked_count = arguments.layers;
  wall.asked_first_height = arguments.first_height;
  return wall;
}

void write_outputs(const CertifyArguments& arguments, const mesh::VolumeMesh& mesh,
                   const certify::MeshCertificate& certificate, Console& console) {
  for (const std::string& name : arguments.outputs) {
    const bool are_cells = kind_of_output(name) == OutputKind::Cells;
    const std::size_t n =
        are_cells ? write_offending_cells(name, mesh, certificate) : write_offending_faces(name, mesh, certificate);
    const std::string_view what = are_cells ? "cells" : "faces";
    if (n == 0) {
      console.say(fmt::format("there are no offending {} to write to {}", what, name));
    } else {
      console.print(fmt::format("the offending {} ({}): {}\n", what, grouped(n), name));
    }
  }
}

ExitCode run_certify(const CertifyArguments& arguments, Console& console) {
  check_arguments(arguments);
  const io::VolumeFile volume = staged(console, "reading", [&] { return read_mesh(arguments); });
  const certify::MeshCertificate certificate = certify::certify_mesh(volume.mesh, console);
  std::optional<WallReport> wall;
  if (arguments.wall) {
    wall = staged(console, "layers", [&] { return look_at_wall(arguments, volume.mesh, certificate); });
  }
  const CertifyReport report{arguments.file, volume, certificate, wall, arguments.n_offenders};
  console.print_json(json_of(report));
  console.print(text_of(report));
  write_outputs(arguments, volume.mesh, certificate, console);
  return certificate.is_valid() ? ExitCode::Done : ExitCode::Fault;
}

}  // namespace

void add_certify_command(CommandLine& line) {
  const auto arguments = std::make_shared<CertifyArguments>();
  CLI::App& app = line.add("certify", "the certificate of any mesh of tetrahedra, pyramids, wedges and hexahedra",
                           "certify MESH [--wall SURFACE] [-o FILE.vtu] [-o FILE.vtp] [options]",
                           "nearwall certify out/onera-m6.vtu --wall onera_m6.stl\n"
                           "nearwall certify other.vtk -o cells.vtu -o faces.vtp --json",
                           [arguments](CommandContext& context) { return run_certify(*arguments, context.console); });
  app.add_option("MESH", arguments->file,
                 "vtu vtk vtkhdf cgns su2 ugrid msh bdf or a folder polyMesh; ours or another program's")
      ->required();
  app.add_option("--wall", arguments->wall, "the layers that the mesh has on this surface, for each of its patches")
      ->type_name("SURFACE");
  app.add_option("-o,--output", arguments->outputs,
                 "write what is wrong: cells to a .vtu, faces to a .vtp; may be repeated")
      ->type_name("FILE");
  app.add_option("--offenders", arguments->n_offenders, "of each kind, how many to name")
      ->type_name("N")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  app.add_option("--layers", arguments->layers,
                 "with --wall: layers that count as all; default: the most common number")
      ->type_name("N")
      ->check(CLI::Range(1, 65534));
  app.add_option("--first-height", arguments->first_height, "with --wall: the first height that was asked for [length]")
      ->type_name("H")
      ->check(non_negative());
}

}  // namespace nearwall::program
