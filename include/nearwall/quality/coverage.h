#pragma once

#include <array>
#include <vector>

#include "nearwall/core/id_vector.h"
#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/mesh/limit_reason.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/quality/statistics.h"

namespace nearwall::quality {

/// Share of the asked thickness from which a triangle counts as full.
inline constexpr double kFullThickness = 0.95;

/// First heights that differ from the asked one by this share of it at most count as the asked one.
inline constexpr double kFirstHeightTolerance = 0.05;

/// First heights beyond this multiple of the asked one count as too large.
inline constexpr double kLargeFirstHeight = 1.5;

/// What was asked for on one patch.
struct PatchRequest {
  bool has_layers = true;
  double first_height = 0;       ///< [length]
  double total_thickness = 0;    ///< [length]
  Level count = 0;               ///< layers; the most, where lines have their own
  bool has_own_heights = false;  ///< each line was asked for its own heights: LineOutcome::asked_first_height
  bool has_own_counts = false;   ///< each line was asked for its own number of layers: LineOutcome::asked_levels
};

/// How the lines came out, each (n_lines).
struct LineOutcome {
  const IdVector<LineId, double>& asked_thickness;  ///< 0 where nothing is asked
  const IdVector<LineId, double>& reached_thickness;
  const IdVector<LineId, mesh::LimitReason>& reason;
  const IdVector<LineId, Level>* asked_levels = nullptr;         ///< null where no patch has_own_counts
  const IdVector<LineId, double>* asked_first_height = nullptr;  ///< null where no patch has_own_heights
};

/// Layers on one wall triangle.
struct FaceCoverage {
  Level layers = 0;      ///< levels that all its lines have
  bool has_any = false;  ///< its column has a cell
  bool has_all_layers = false;
  bool is_full = false;           ///< all layers, at kFullThickness of the asked thickness or more
  double first_height = 0;        ///< mean distance of its first-level nodes from its plane [length]
  double thickness = 0;           ///< the same of its top nodes [length]
  double asked_first_height = 0;  ///< [length]
  double asked_thickness = 0;     ///< [length]
  /// Of its most limited line; where it is full None, or Isotropic if that is where its lines were to end.
  mesh::LimitReason reason = mesh::LimitReason::None;
};

/// Layers on one patch; percentages and statistics by area of the wetted triangles. Definitions:
/// docs/theory/quality.md.
struct PatchCoverage {
  bool has_layers = true;
  double area = 0;
  double full_percent = 0;
  double all_layers_percent = 0;
  double any_percent = 0;
  double mean_layers = 0;
  PatchRequest asked;             ///< lengths that differ from line to line: their medians
  Statistics asked_first_height;  ///< of the triangles
  Statistics asked_thickness;
  Statistics first_height;
  double first_height_met_percent = 0;    ///< within kFirstHeightTolerance of the asked one
  double first_height_large_percent = 0;  ///< beyond kLargeFirstHeight of it
  Statistics thickness;
  std::array<double, mesh::kNLimitReasons>
      limit_percent{};  ///< by LimitReason, of triangles that are not full; None: 0
};

/// \returns (n_wall_faces); default entries where nothing is asked: no layers, and no reason
/// Cost: O(n_wall_faces), on all threads.
IdVector<FaceId, FaceCoverage> face_coverage(const mesh::LayerMesh& layers, const mesh::SurfaceMesh& wall,
                                             const IdVector<PatchId, PatchRequest>& requests,
                                             const LineOutcome& outcome);

/// Sums over each patch.
/// \param is_wetted  (n_faces) 0: on a component that the fluid cannot reach, not counted
IdVector<PatchId, PatchCoverage> patch_coverage(const mesh::SurfaceMesh& wall,
                                                const IdVector<FaceId, FaceCoverage>& faces,
                                                const IdVector<PatchId, PatchRequest>& requests,
                                                const IdVector<FaceId, char>& is_wetted);

}  // namespace nearwall::quality
