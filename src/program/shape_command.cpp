#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "nearwall/io/surface_writer.h"
#include "nearwall/shapes/shapes.h"
#include "program/cli.h"
#include "program/help.h"
#include "program/table.h"

namespace nearwall::program {

namespace {

using nlohmann::json;
using shapes::ParameterKind;
using shapes::ShapeInfo;
using shapes::ShapeParameter;

struct ShapeArguments {
  std::string output;
  double size = 0;
  shapes::ParameterValues values;
};

/// JSON has no infinity: a limit that is none is null.
json limit(double value) { return std::isfinite(value) ? json(value) : json(); }

json json_of(const ShapeInfo& shape) {
  json parameters = json::array();
  for (const ShapeParameter& p : shape.parameters) {
    parameters.push_back({{"name", p.name},
                          {"default", p.value},
                          {"min", limit(p.min)},
                          {"max", limit(p.max)},
                          {"unit", p.unit},
                          {"description", p.description}});
  }
  return {{"name", shape.name}, {"summary", shape.summary}, {"parameters", parameters}};
}

ExitCode list_shapes(Console& console) {
  json list = json::array();
  std::string text = "shapes\n";
  for (const ShapeInfo& shape : shapes::catalogue()) {
    list.push_back(json_of(shape));
    text += entry(shape.name, shape.summary);
  }
  console.print_json(json{{"shapes", list}});
  console.print(text + "\nnearwall shape NAME --help lists the parameters of a shape\n");
  return ExitCode::Done;
}

ExitCode write_shape(const ShapeInfo& shape, const ShapeArguments& arguments, Console& console) {
  const auto mesh =
      staged(console, shape.name, [&] { return shapes::make_shape(shape.name, arguments.values, arguments.size); });
  io::write_surface(arguments.output, mesh);
  std::string patches;
  for (const std::string& name : mesh.patch_names) patches += (patches.empty() ? "" : ", ") + name;
  console.print_json(json{{"shape", shape.name},
                          {"file", arguments.output},
                          {"points", mesh.points.size()},
                          {"triangles", mesh.faces.size()},
                          {"patches", mesh.patch_names.raw()}});
  console.print(fmt::format("{}: {} points, {} triangles, patches {}\n", arguments.output, grouped(mesh.points.size()),
                            grouped(mesh.faces.size()), patches));
  return ExitCode::Done;
}

std::string range_of(const ShapeParameter& p) {
  if (std::isfinite(p.max)) return fmt::format("{:g} to {:g}", p.min, p.max);
  // The smallest double stands for "more than zero".
  return p.min > 0 && p.min <= std::numeric_limits<double>::min() ? "above 0" : fmt::format("from {:g}", p.min);
}

std::string described(const ShapeParameter& p) {
  if (p.kind == ParameterKind::Switch)
    return fmt::format("{} (--{} or --{}=0) [{:g}]", p.description, p.name, p.name, p.value);
  const std::string unit = p.unit == "-" ? "" : ", " + p.unit;
  return fmt::format("{} ({}{}) [{:g}]", p.description, range_of(p), unit, p.value);
}

void add_parameter(CLI::App& app, const ShapeParameter& p, ShapeArguments& arguments) {
  const auto store = [&arguments, name = p.name](double value) { arguments.values[name] = value; };
  if (p.kind == ParameterKind::Switch) {
    app.add_flag_function(
           "--" + p.name, [store](std::int64_t n) { store(n > 0 ? 1 : 0); }, described(p))
        ->group("parameters");
  } else {
    app.add_option_function<double>("--" + p.name, store, described(p))->type_name("X")->group("parameters");
  }
}

void add_shape(CommandLine& line, CLI::App& parent, const ShapeInfo& shape) {
  const auto arguments = std::make_shared<ShapeArguments>();
  CLI::App& app = line.add_below(
      parent, shape.name, shape.summary, fmt::format("shape {} -o FILE [--size H] [parameters]", shape.name),
      fmt::format("nearwall shape {0} -o {0}.stl", shape.name),
      [arguments, &shape](CommandContext& context) { return write_shape(shape, *arguments, context.console); });
  app.add_option("-o,--output", arguments->output, "stl, obj, ply, off, vtp or vtk, also gzipped")
      ->type_name("FILE")
      ->required();
  app.add_option("--size", arguments->size, "edge length of the triangles; 0: one that suits the shape")
      ->type_name("H")
      ->check(non_negative());
  for (const ShapeParameter& p : shape.parameters) add_parameter(app, p, *arguments);
}

}  // namespace

void add_shape_command(CommandLine& line) {
  CLI::App& app = line.add("shape", "surfaces of wings, bodies, ducts and test shapes, with named patches",
                           "shape                      the list of shapes\n"
                           "  nearwall shape NAME --help          the parameters of one\n"
                           "  nearwall shape NAME -o FILE [--size H] [parameters]",
                           "nearwall shape sphere --size 0.05 -o sphere.stl",
                           [](CommandContext& context) { return list_shapes(context.console); });
  app.require_subcommand(0, 1);
  for (const ShapeInfo& shape : shapes::catalogue()) add_shape(line, app, shape);
}

}  // namespace nearwall::program
