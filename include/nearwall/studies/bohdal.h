#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "nearwall/core/progress.h"
#include "nearwall/studies/report.h"
#include "nearwall/surface/point_normals.h"

namespace nearwall::studies {

/// A way to estimate the normals of a height field.
struct BohdalMethod {
  std::string_view name;
  surface::NormalMethod method;
  int n_rings = 1;           ///< neighbours that a fit looks at
  bool is_of_paper = false;  ///< one of the eight that the paper compares
};

/// All methods of the study, those of the paper under its names.
inline constexpr std::array<BohdalMethod, 23> kBohdalMethods = {{
    {"Gouraud", surface::NormalMethod::Uniform, 1, true},
    {"Little, r = 1/2", surface::NormalMethod::InverseRootEdges},
    {"Little, r = 1", surface::NormalMethod::InverseEdges, 1, true},
    {"Little, r = 2", surface::NormalMethod::InverseSquaredEdges},
    {"Thürmer", surface::NormalMethod::Angle, 1, true},
    {"Akima", surface::NormalMethod::Area, 1, true},
    {"Akima2", surface::NormalMethod::ProjectedArea, 1, true},
    {"Max", surface::NormalMethod::Max, 1, true},
    {"Little-Max", surface::NormalMethod::LittleMax, 1, true},
    {"Ubach's α/A∘", surface::NormalMethod::AngleOverCircumArea},
    {"thin plate, one ring", surface::NormalMethod::ThinPlate, 1, true},
    {"thin plate, two rings", surface::NormalMethod::ThinPlate, 2},
    {"Hardy, one ring", surface::NormalMethod::Hardy, 1},
    {"Hardy, two rings", surface::NormalMethod::Hardy, 2},
    {"Renka & Cline, one ring", surface::NormalMethod::RenkaCline, 1},
    {"Renka & Cline, two rings", surface::NormalMethod::RenkaCline, 2},
    {"quadratic, one ring", surface::NormalMethod::QuadraticFit, 1},
    {"quadratic, two rings", surface::NormalMethod::QuadraticFit, 2},
    {"linear, one ring", surface::NormalMethod::LinearFit, 1},
    {"linear, two rings", surface::NormalMethod::LinearFit, 2},
    {"Shepard, one ring", surface::NormalMethod::Shepard, 1},
    {"Shepard, two rings", surface::NormalMethod::Shepard, 2},
    {"Nielson", surface::NormalMethod::Nielson},
}};

/// What is taken away before normals are estimated.
enum class BohdalRemoval {
  None,
  ThinInPlane,           ///< thin boundary triangles of the plane, as in the paper
  ThinInSpace,           ///< thin boundary triangles of the graph, as point_normals does by default
  UnsuitableAtBoundary,  ///< normals far from the mean of their fan, algorithm 1, at boundary vertices
  UnsuitableEverywhere,
  ThinAndUnsuitable,  ///< ThinInPlane and UnsuitableEverywhere: both modifications of the paper
};
inline constexpr std::array<std::string_view, 6> kBohdalRemovals = {
    "none", "thin in the plane", "thin in space", "unsuitable, boundary", "unsuitable, everywhere", "thin, unsuitable"};

/// Errors of all methods on one mesh, each in the order of kBohdalMethods.
struct BohdalErrors {
  int function = 0;
  std::size_t n_points = 0;
  /// Root mean square angle between estimated and true normals [degrees] for each removal.
  std::array<std::array<double, kBohdalMethods.size()>, kBohdalRemovals.size()> normals_deg{};
  std::array<double, kBohdalMethods.size()> clough_tocher{};  ///< root mean square error of the interpolant
  std::array<double, kBohdalMethods.size()> powell_sabin{};
  std::array<double, kBohdalMethods.size()> fallback_percent{};  ///< share of points where a fit had no answer
  double clough_tocher_of_truth = 0;                             ///< with the true gradients
  double powell_sabin_of_truth = 0;
};

/// One of the 36 meshes.
/// \param function  test function, 1 to 9    \param n_points  random points of the unit square, > 3
/// \throws InputError if an argument is out of range    Cost: O(n_points log n_points)
BohdalErrors bohdal_errors(int function, std::size_t n_points, std::uint64_t seed);

/// Processor time for the normals at all points of a mesh of f1, without triangulation and adjacency: median of a few
/// repetitions on one thread [seconds], for each method.
/// \throws InputError if there are fewer than 4 points
std::array<double, kBohdalMethods.size()> bohdal_seconds(std::size_t n_points, std::uint64_t seed);

struct BohdalOptions {
  int repetitions = 5;  ///< sets of 36 meshes, at least 1
  std::uint64_t seed = 1;
};

/// 9 functions times 100, 900, 2500 and 4900 points, as tables and plots.
/// \throws InputError if an option is out of range; whatever `progress` throws
Report study_bohdal(const BohdalOptions& options, ProgressSink& progress);

}  // namespace nearwall::studies
