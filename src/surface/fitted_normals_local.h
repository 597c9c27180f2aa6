#pragma once

#include <Eigen/Core>
#include <optional>

#include "nearwall/surface/fitted_normals.h"
#include "surface/tangent_frame.h"

namespace nearwall::surface {

/// Neighbours in the local frame of a point, in units (a power of two) such that the farthest one in the plane has a
/// coordinate x in [1/2, 1).
struct LocalHeights {
  TangentFrame frame;
  Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxFittedNeighbours> x, y, z;  ///< z: heights

  Eigen::Index size() const { return x.size(); }
};

/// Slopes of a function at the point, along t1 and t2.
using Slopes = Eigen::Vector2d;

// Each of these gives nullopt if the function is not determined.
std::optional<Slopes> linear_fit_slopes(const LocalHeights& local);
std::optional<Slopes> quadratic_fit_slopes(const LocalHeights& local);
std::optional<Slopes> renka_cline_slopes(const LocalHeights& local);
std::optional<Slopes> shepard_slopes(const LocalHeights& local);
std::optional<Slopes> hardy_slopes(const LocalHeights& local);
std::optional<Slopes> thin_plate_slopes(const LocalHeights& local);

}  // namespace nearwall::surface
