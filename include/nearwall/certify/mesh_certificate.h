#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "nearwall/core/progress.h"
#include "nearwall/mesh/cell_faces.h"
#include "nearwall/mesh/volume_mesh.h"
#include "nearwall/predicates/cells.h"
#include "nearwall/search/patch_tree.h"

// The certificate of any mesh of tetrahedra, pyramids, wedges and hexahedra. Source: docs/theory/certificate.md.

namespace nearwall::certify {

/// A cell that is not, or not surely, positive everywhere.
struct Offender {
  std::uint64_t cell = 0;
  predicates::Positivity verdict = predicates::Positivity::NotPositive;
  bool has_repeated_node = false;  ///< a collapsed cell
};

/// Point 1, by type of cell.
struct CellVerdicts {
  std::array<std::uint64_t, mesh::kNCellTypes> count{};
  std::array<std::uint64_t, mesh::kNCellTypes> not_positive{};
  std::array<std::uint64_t, mesh::kNCellTypes> undecided{};  ///< hexahedra only
  std::vector<Offender> offenders;                           ///< in the order of the cells
};

/// What is not finite is not positive. \throws InputError  as mesh::require_nodes    Cost: O(n_cells), on all threads.
CellVerdicts cell_verdicts(const mesh::VolumeMesh& mesh);

/// What is wrong with a face that is neither between two cells nor on the boundary.
enum class FaceFault : std::uint8_t {
  ManyCells,        ///< three or more cells have it
  SameSide,         ///< two cells have it that see it from the same side
  RepeatedNode,     ///< a node twice: the cell is collapsed there
  OtherOrder,       ///< a quad of one cell has the nodes of another cell's quad in an order that is no rotation
  QuadOnTriangles,  ///< a quad of one cell has three nodes that are a triangle of another
};

inline constexpr std::array<std::string_view, 5> kFaceFaultNames = {"many-cells", "same-side", "repeated-node",
                                                                    "other-order", "quad-on-triangles"};

struct NonconformingFace {
  mesh::FaceName face;  ///< of the first cell that has it
  FaceFault fault = FaceFault::ManyCells;
};

/// Point 2.
struct Conformity {
  std::vector<NonconformingFace> nonconforming;
  std::vector<mesh::FaceName> boundary;  ///< faces of one cell; those of the last two faults are among them
};

/// Nodes are told by their numbers: points that only coincide are different nodes. Memory: 8 bytes a face and a point
/// beside the answer. Cost: O(n_cells), on all threads. \throws InputError  as mesh::require_nodes
Conformity conformity(const mesh::VolumeMesh& mesh);

struct MeshCertificate {
  CellVerdicts cells;
  Conformity faces;
  /// Pairs of faces.boundary; nothing if a point of the boundary is not finite.
  std::optional<search::PatchPairs> intersections;
  /// Points of the boundary at which another point of it lies, if the boundary meets itself: points that were not made
  /// one.
  std::uint64_t n_coincident_points = 0;
  /// A boundary face of each part of the boundary behind which points are covered more than once. Nothing where the
  /// boundary meets itself, or does not close: then it has no meaning.
  std::optional<std::vector<mesh::FaceName>> covered_twice;
  std::uint64_t n_undecided_parts = 0;  ///< parts of the boundary for which that could not be told
  double cells_volume = 0;              ///< [length³], sum over cells
  double enclosed_volume = 0;           ///< [length³], within the boundary
  double summed_volume = 0;             ///< [length³], of the cones over the boundary's faces, each counted positive

  std::uint64_t n_cells() const;
  std::uint64_t n_not_positive() const;
  std::uint64_t n_undecided() const;
  /// Whether each face of a cell is the face of just one other or of the boundary, so that the boundary closes.
  bool closes() const;
  /// |sum of cells − enclosed volume| over the volume that was summed up. Nothing where the boundary does not close.
  std::optional<double> closure() const;
  /// All points hold, and none was left undecided.
  bool is_valid() const;
};

/// \throws InputError  no cell; or as `conformity`
/// Cost: O(n_cells + n log n for the n faces of the boundary), on all threads; the same bits whatever their number.
MeshCertificate certify_mesh(const mesh::VolumeMesh& mesh, ProgressSink& progress = silent_progress());

}  // namespace nearwall::certify
