#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "nearwall/core/progress.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/studies/report.h"

namespace nearwall::studies {

struct AubryLohnerOptions {
  int repetitions = 5;  ///< of each measurement, whose median counts; at least 1
};

inline constexpr int kSweeps = 5;  ///< one after the other, as in the paper

/// How a sweep comes by the new normal of a point.
enum class SweepKind {
  Streaming,        ///< none: only the same arrays are read and written
  Plain,            ///< mean of the neighbours' normals
  Direct,           ///< their most visible normal, by the direct method
  Triggered,        ///< the mean; the direct method where its worst cosine is not above the trigger 0.95
  IterativeFull,    ///< the iteration of section 3 with the relaxation 1
  IterativeHalf,    ///< with 1/2
  IterativeChosen,  ///< with the one chosen at each step
};

/// Names of the kinds in tables, in the order of SweepKind.
inline constexpr std::array<std::string_view, 7> kSweepNames = {
    "streaming only", "plain", "direct", "triggered", "iterative, β = 1", "iterative, β = 1/2", "iterative, β chosen"};

/// What the sweeps of one kind have done to the normals of a body.
struct SweepResult {
  SweepKind kind = SweepKind::Streaming;
  double seconds = 0;                ///< median processor time of all sweeps, one thread
  double direct_percent = 0;         ///< share of points that went past the trigger, over all sweeps
  double mean_iterations = 0;        ///< of the iterative search, for each point and sweep; NaN for others
  double not_converged_percent = 0;  ///< share of its searches that stopped short of their tolerance; NaN for others
  double worst_angle_deg = 0;        ///< largest visibility angle of all points after the last sweep
  std::size_t n_blind = 0;           ///< points whose normal does not see all faces then, decided exactly
  double edge_angle_deg = 0;         ///< mean visibility angle of the points on ridges and corners
};

/// Five sweeps of each kind over a closed surface (Aubry & Loehner 2008, section 5): in each, the normal of every point
/// becomes what the kind says. Nothing is held. All start from the most visible normals of the faces; the angles of
/// `Streaming` are those of the start.
/// \returns  one result of each kind, in the order of SweepKind: the same but for the times at any number of threads,
/// and on all machines whose sine and its kin round alike
/// \throws   InputError if an option is out of range; whatever `progress` throws
std::vector<SweepResult> compare_sweeps(const mesh::SurfaceMesh& surface, const AubryLohnerOptions& options,
                                        ProgressSink& progress);

/// Sweeps, normals of the faces by several methods, and the smoothing of the library, on two bodies, on one thread.
/// \throws InputError if an option is out of range; whatever `progress` throws
Report study_aubry_lohner(const AubryLohnerOptions& options, ProgressSink& progress);

}  // namespace nearwall::studies
