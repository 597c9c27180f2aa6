#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "nearwall/io/surface_reader.h"
#include "nearwall/io/surface_writer.h"
#include "nearwall/surface/weld.h"
#include "program/cli.h"
#include "program/table.h"

namespace nearwall::program {

namespace {

struct ConvertArguments {
  std::string input;
  std::string output;
  std::optional<double> weld;
};

ExitCode run_convert(const ConvertArguments& arguments, Console& console) {
  mesh::SurfaceMesh mesh = staged(console, "reading", [&] { return io::read_surface(arguments.input); });
  if (arguments.weld) mesh = surface::weld(mesh, *arguments.weld);
  console.begin_stage("writing");
  io::write_surface(arguments.output, mesh);
  console.end_stage();
  console.print_json(nlohmann::json{{"file", arguments.output},
                                    {"points", mesh.points.size()},
                                    {"triangles", mesh.faces.size()},
                                    {"patches", mesh.patch_names.raw()}});
  console.print(fmt::format("{}: {} points, {} triangles, {} patch{}\n", arguments.output, grouped(mesh.points.size()),
                            grouped(mesh.faces.size()), mesh.patch_names.size(),
                            mesh.patch_names.size() == 1 ? "" : "es"));
  return ExitCode::Done;
}

}  // namespace

void add_convert_command(CommandLine& line) {
  const auto arguments = std::make_shared<ConvertArguments>();
  CLI::App& app = line.add("convert", "a surface from one format to another, by the ending of the file",
                           "convert IN OUT [--weld LENGTH]", "nearwall convert wing.stl wing.vtp --weld 0",
                           [arguments](CommandContext& context) { return run_convert(*arguments, context.console); });
  app.add_option("IN", arguments->input, "stl, obj, ply, off, vtp or vtk, also gzipped")->required();
  app.add_option("OUT", arguments->output, "the same endings")->required();
  app.add_option("--weld", arguments->weld,
                 "make points within this distance one [length]; 0: equal points; without it: none")
      ->type_name("LENGTH")
      ->check(non_negative());
}

}  // namespace nearwall::program
