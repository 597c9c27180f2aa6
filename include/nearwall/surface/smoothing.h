#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/surface/features.h"
#include "nearwall/surface/point_normals.h"

namespace nearwall::surface {

/// What a direction is drawn to, and whether it steps back.
enum class SmoothingFilter {
  None,
  Laplacian,          ///< a step towards the mean of the neighbours' directions
  Taubin,             ///< the same, then a step away from it: no shrinkage (Taubin 1995)
  MostVisible,        ///< a step towards the most visible normal of the neighbours' directions
  MostVisibleTaubin,  ///< the same, then a step away from it (Aubry & Loehner 2008, section 6)
};

/// Names of the filters, in the order of SmoothingFilter, as in case files and on the command line.
inline constexpr std::array<std::string_view, 5> kSmoothingFilterNames = {"none", "laplacian", "taubin", "most-visible",
                                                                          "most-visible-taubin"};

std::string_view filter_name(SmoothingFilter filter);

/// nullopt if there is no filter of that name.
std::optional<SmoothingFilter> smoothing_filter(std::string_view name);

/// How the most visible normal of the neighbours is found.
enum class SearchMethod {
  Direct,     ///< `most_visible_normal`
  Iterative,  ///< `iterative_normal`, to compare: slower, and to its tolerance only
};

struct SmoothingOptions {
  SmoothingFilter filter = SmoothingFilter::Taubin;
  int iterations = 0;   ///< sweeps; a sweep of a Taubin filter is one lambda and one mu step
  double lambda = 0.5;  ///< step towards the neighbours, (0, 1]
  double mu = -0.53;    ///< counter-step of Taubin, < -lambda (Taubin 1995)
  /// The most visible normal of neighbours whose mean sees them all with a cosine above this is taken to be that mean,
  /// (0, 1]; 1: never (Aubry & Loehner 2008, section 5).
  double trigger = kVisibilityTrigger;
  SearchMethod search = SearchMethod::Direct;  ///< beyond the trigger
};

/// Smooths the normals of the vertices. Corners, ridge ends and tips keep theirs; ridge vertices look at their two
/// neighbours along the ridge only; all others at their ring. A new direction must see every face round its vertex: the
/// sign is exact, and it keeps at least half of the room that the normal given for the vertex has to the edge of
/// its visibility cone; where it would leave that, it is drawn back along the arc. Blind vertices keep their normal.
/// \param is_held  (n_vertices) or empty: vertices whose normal is imposed, as on a symmetry plane, and stays
/// \param normals  (n_vertices), changed in place; `max_angle` follows the direction
/// \throws InputError if an option is out of range
/// Cost: O(n_faces * iterations), on all threads; the same bits at any number of them.
void smooth_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, const Features& features,
                    const SmoothingOptions& options, IdVector<VertexId, PointNormal>& normals,
                    const IdVector<VertexId, char>& is_held = {});

}  // namespace nearwall::surface
