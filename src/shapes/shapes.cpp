#include "nearwall/shapes/shapes.h"

#include <fmt/format.h>

#include <cmath>

#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"
#include "nearwall/core/nearest.h"
#include "shapes/definition.h"

namespace nearwall::shapes {
namespace {

const std::vector<Definition>& definitions() {
  static const std::vector<Definition> all = [] {
    std::vector<Definition> result;
    for (const auto& group :
         {round_shapes(), block_shapes(), corner_shapes(), edge_shapes(), fin_shapes(), fading_shapes(), duct_shapes(),
          several_bodies(), wing_shapes(), aircraft_shapes(), vehicle_shapes(), tunnel_shapes()}) {
      result.insert(result.end(), group.begin(), group.end());
    }
    return result;
  }();
  return all;
}

std::string listed(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

const Definition& definition_of(std::string_view name) {
  std::vector<std::string> names;
  for (const Definition& d : definitions()) {
    if (d.info.name == name) return d;
    names.push_back(d.info.name);
  }
  const std::string near = nearest(name, names);
  throw InputError(fmt::format("there is no shape '{}'{}; shapes: {}", name,
                               near.empty() ? "" : fmt::format(", did you mean '{}'?", near), listed(names)));
}

void check_value(const ShapeInfo& shape, const ShapeParameter& p, double value) {
  if (!(value >= p.min && value <= p.max) || !std::isfinite(value)) {
    const std::string unit = p.unit == "-" ? "" : " " + p.unit;
    const std::string range =
        std::isinf(p.max) ? fmt::format("at least {:g}", p.min) : fmt::format("between {:g} and {:g}", p.min, p.max);
    throw InputError(fmt::format("{} of shape '{}' must be {}{}, not {:g}", p.name, shape.name, range, unit, value));
  }
  if (p.kind != ParameterKind::Real && value != std::floor(value)) {
    throw InputError(fmt::format("{} of shape '{}' must be {}, not {:g}", p.name, shape.name,
                                 p.kind == ParameterKind::Switch ? "0 or 1" : "a whole number", value));
  }
}

Values complete(const ShapeInfo& shape, const ParameterValues& given) {
  std::vector<std::string> names;
  ParameterValues values;
  for (const ShapeParameter& p : shape.parameters) {
    const auto it = given.find(p.name);
    values[p.name] = it == given.end() ? p.value : it->second;
    check_value(shape, p, values[p.name]);
    names.push_back(p.name);
  }
  for (const auto& [name, value] : given) {
    if (values.contains(name)) continue;
    const std::string near = nearest(name, names);
    throw InputError(fmt::format("shape '{}' has no parameter '{}'{}; it has {}", shape.name, name,
                                 near.empty() ? "" : fmt::format(", did you mean '{}'?", near),
                                 names.empty() ? "none" : listed(names)));
  }
  return Values(std::move(values));
}

ShapeParameter parameter(std::string name, double value, double min, double max, std::string unit,
                         std::string description, ParameterKind kind = ParameterKind::Real) {
  return {std::move(name), value, min, max, std::move(unit), std::move(description), kind};
}

}  // namespace

double Values::operator[](std::string_view name) const {
  const auto it = values_.find(name);
  expect(it != values_.end(), "a shape asks only for parameters that it has");
  return it->second;
}

ShapeParameter length(std::string name, double value, std::string description) {
  return parameter(std::move(name), value, std::numeric_limits<double>::min(), kAnyLength, "length",
                   std::move(description));
}

ShapeParameter angle(std::string name, double value, double min, double max, std::string description) {
  return parameter(std::move(name), value, min, max, "deg", std::move(description));
}

ShapeParameter number(std::string name, double value, double min, double max, std::string description) {
  return parameter(std::move(name), value, min, max, "-", std::move(description));
}

ShapeParameter integer(std::string name, int value, int min, int max, std::string description) {
  return parameter(std::move(name), value, min, max, "-", std::move(description), ParameterKind::Integer);
}

ShapeParameter option(std::string name, bool value, std::string description) {
  return parameter(std::move(name), value ? 1 : 0, 0, 1, "-", std::move(description), ParameterKind::Switch);
}

void require(bool holds, std::string_view what) {
  if (!holds) throw InputError(std::string(what));
}

const std::vector<ShapeInfo>& catalogue() {
  static const std::vector<ShapeInfo> all = [] {
    std::vector<ShapeInfo> result;
    for (const Definition& d : definitions()) result.push_back(d.info);
    return result;
  }();
  return all;
}

mesh::SurfaceMesh make_shape(std::string_view name, const ParameterValues& parameters, double size) {
  const Definition& d = definition_of(name);
  if (!(size >= 0) || std::isinf(size)) {
    throw InputError(
        fmt::format("size of shape '{}' must be a positive length, or 0 for its default, not {:g}", name, size));
  }
  return d.make(complete(d.info, parameters), size);
}

}  // namespace nearwall::shapes
