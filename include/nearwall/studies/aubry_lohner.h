#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "nearwall/core/progress.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/studies/report.h"

namespace nearwall::studies {

struct AubryLohnerOptions {
  int repetitions = 5;  ///< of each measurement, whose median counts; at least 1
};

/// What five sweeps of one kind have done to the normals of a body.
struct SweepResult {
  std::string kind;
  double seconds = 0;                ///< median processor time of the five sweeps, one thread
  double direct_percent = 0;         ///< share of points that went past the trigger, over all sweeps
  double mean_iterations = 0;        ///< of the iterative search, for each point and sweep; NaN for others
  double not_converged_percent = 0;  ///< share of its searches that stopped short of their tolerance; NaN for others
  double worst_angle_deg = 0;        ///< largest visibility angle of all points after the last sweep
  std::size_t n_blind = 0;           ///< points whose normal does not see all faces then
  double edge_angle_deg = 0;         ///< mean visibility angle of the points on ridges and corners
};

/// Five sweeps of each kind over a closed surface (Aubry & Loehner 2008, section 5): in each, the normal of every point
/// becomes the mean of its neighbours' normals, or their most visible normal by the direct method, by that beyond the
/// trigger 0.95, or by the iteration of section 3. Nothing is held. All start from the most visible normals of the
/// faces. The first result is that of a loop that only streams the same arrays; its angles are those of the start.
/// Results but the times are the same bits on any machine.
std::vector<SweepResult> compare_sweeps(const mesh::SurfaceMesh& surface, const AubryLohnerOptions& options,
                                        ProgressSink& progress);

/// Sweeps, normals of the faces by several methods, and the smoothing of the library, on two bodies, on one thread.
/// \throws InputError if an option is out of range; whatever `progress` throws
Report study_aubry_lohner(const AubryLohnerOptions& options, ProgressSink& progress);

}  // namespace nearwall::studies
