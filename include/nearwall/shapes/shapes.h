#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::shapes {

/// What a parameter of a shape may be.
enum class ParameterKind {
  Real,     ///< any number in [min, max]
  Integer,  ///< a whole number in [min, max]
  Switch,   ///< 0 or 1
};

/// A number that a shape depends on.
struct ShapeParameter {
  std::string name;         ///< lower case, words joined by '-', as on the command line
  double value = 0;         ///< default
  double min = 0;           ///< smallest value allowed
  double max = 0;           ///< largest value allowed; may be infinite
  std::string unit;         ///< "length" (the shape's own unit, see its summary), "deg", "-"
  std::string description;  ///< one line
  ParameterKind kind = ParameterKind::Real;
};

/// A shape of the catalogue.
struct ShapeInfo {
  std::string name;
  std::string summary;  ///< one line: what it is, its unit of length if it has one, its patches
  std::vector<ShapeParameter> parameters;
};

using ParameterValues = std::map<std::string, double, std::less<>>;

/// All shapes, in the order of docs/shapes.md.
const std::vector<ShapeInfo>& catalogue();

/// The surface of a shape: closed, manifold, free of self-intersections and of degenerate triangles, with named
/// patches. Faces are counterclockwise seen from outside of the body; for ducts, from outside of the lumen. Equal
/// arguments give equal bits. \param name        of the catalogue \param parameters  values of the shape's parameters
/// by name; those left out take their defaults \param size        edge length of the triangles where nothing asks for
/// smaller ones [length], > 0; 0: one that suits
///                    the shape
/// \throws InputError for an unknown shape or parameter (with the nearest name), a value out of range, parameters that
///         do not go together, or a size that would give more triangles than can be numbered
/// Cost: O(n log n) in the number of triangles.
mesh::SurfaceMesh make_shape(std::string_view name, const ParameterValues& parameters = {}, double size = 0);

}  // namespace nearwall::shapes
