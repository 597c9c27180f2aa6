#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "nearwall/core/progress.h"
#include "nearwall/studies/report.h"
#include "nearwall/surface/normals.h"

namespace nearwall::studies {

/// The weights of Ubach et al. 2013, in the order of their figure 5, and how the paper writes them.
inline constexpr std::array<surface::Weight, 11> kUbachWeights = {surface::Weight::InverseDiameter,
                                                                  surface::Weight::InverseCircumArea,
                                                                  surface::Weight::InverseEdges,
                                                                  surface::Weight::AngleOverDiameter,
                                                                  surface::Weight::AngleOverCircumArea,
                                                                  surface::Weight::Max,
                                                                  surface::Weight::Area,
                                                                  surface::Weight::Uniform,
                                                                  surface::Weight::InverseRootEdges,
                                                                  surface::Weight::InverseArea,
                                                                  surface::Weight::Angle};
inline constexpr std::array<std::string_view, 11> kUbachNames = {"1/∅", "1/A∘", "1/(bc)",  "α/∅",  "α/A∘", "sin α/(bc)",
                                                                 "A△",  "1",    "1/√(bc)", "1/A△", "α"};

/// Values of k_max and n_p of the study's 7 x 7 cells.
inline constexpr std::array<double, 7> kUbachCurvatures = {1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1, 10};
inline constexpr std::array<int, 7> kUbachFaces = {3, 4, 5, 6, 7, 8, 9};

struct UbachOptions {
  std::uint64_t samples = 100000;  ///< random surfaces of each cell, at least 1
  std::uint64_t seed = 1;
};

/// Errors of the weights over random cubic surfaces.
struct UbachCell {
  double max_curvature = 0;                                       ///< k_max: bound of the surfaces' coefficients
  int n_faces = 0;                                                ///< n_p: triangles round the point
  std::array<double, kUbachWeights.size()> rmse_deg{};            ///< root mean square of the angle to the true normal
  std::array<double, kUbachWeights.size()> standard_error_deg{};  ///< of `rmse_deg`, estimated from the same samples
};

/// One cell of the study: z = A x² + B xy + C y² + D x³ + E x²y + F xy² + G y³ with coefficients uniform in
/// (-k_max, k_max), round the origin `n_faces` points with r uniform in (0, 1] and polar angles uniform in [0, 2 pi),
/// draws with a gap of more than pi rejected (Ubach et al. 2013, section 3).
/// \param max_curvature  k_max, > 0 and <= 1e50    \param n_faces  n_p, 3 to 64
/// \throws InputError if an argument or an option is out of range
/// The same bits at any number of threads. Cost: O(samples * n_faces), on all threads.
UbachCell ubach_cell(double max_curvature, int n_faces, const UbachOptions& options);

/// The weight alpha / (area of the circumcircle) against Max's on a torus (section 5).
struct TorusComparison {
  std::string family;  ///< how the mesh came about
  std::size_t n_nodes = 0;
  double improved_percent = 0;     ///< share of the nodes where the former is nearer to the true normal
  double rmse_circle_deg = 0;      ///< of the former
  double rmse_max_deg = 0;         ///< of Max's
  std::vector<double> change_deg;  ///< error of the former less that of Max's, ascending
};

/// The torus with R / r = golden ratio, some 7083 nodes, in several kinds of irregular mesh.
std::vector<TorusComparison> compare_on_torus(std::uint64_t seed);

/// All cells and the torus, as tables and plots.
/// \throws InputError as `ubach_cell`; whatever `progress` throws
Report study_ubach(const UbachOptions& options, ProgressSink& progress);

}  // namespace nearwall::studies
