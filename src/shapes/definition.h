#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "nearwall/shapes/shapes.h"

namespace nearwall::shapes {

/// The values of all parameters of a shape, checked against their ranges.
class Values {
 public:
  explicit Values(ParameterValues values) : values_(std::move(values)) {}
  double operator[](std::string_view name) const;
  int integer(std::string_view name) const { return static_cast<int>((*this)[name]); }
  bool is_on(std::string_view name) const { return (*this)[name] != 0; }

 private:
  ParameterValues values_;
};

/// A shape and how it is made; size 0 means a size that suits it.
struct Definition {
  ShapeInfo info;
  mesh::SurfaceMesh (*make)(const Values&, double size);
};

inline constexpr double kAnyLength = std::numeric_limits<double>::infinity();

ShapeParameter length(std::string name, double value, std::string description);
ShapeParameter angle(std::string name, double value, double min, double max, std::string description);
ShapeParameter number(std::string name, double value, double min, double max, std::string description);
ShapeParameter integer(std::string name, int value, int min, int max, std::string description);
ShapeParameter option(std::string name, bool value, std::string description);

/// \throws InputError with `what` if `holds` is false: for parameters that do not go together
void require(bool holds, std::string_view what);

std::vector<Definition> round_shapes();
std::vector<Definition> block_shapes();
std::vector<Definition> corner_shapes();
std::vector<Definition> edge_shapes();
std::vector<Definition> fin_shapes();
std::vector<Definition> fading_shapes();
std::vector<Definition> duct_shapes();
Definition vessel();
std::vector<Definition> several_bodies();
std::vector<Definition> wing_shapes();
std::vector<Definition> aircraft_shapes();
std::vector<Definition> vehicle_shapes();
std::vector<Definition> tunnel_shapes();

}  // namespace nearwall::shapes
