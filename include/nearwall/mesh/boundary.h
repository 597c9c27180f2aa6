#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "nearwall/core/id_vector.h"
#include "nearwall/core/ids.h"

namespace nearwall::mesh {

/// What a patch is to a flow solver.
enum class BoundaryType : std::uint8_t {
  Wall,
  Symmetry,
  Inlet,
  Outlet,
  FarField,
  Other,  ///< not known, or the front of layers without a volume
};

inline constexpr std::array<std::string_view, 6> kBoundaryTypeNames = {"wall",   "symmetry", "inlet",
                                                                       "outlet", "farfield", "other"};

constexpr std::string_view name_of(BoundaryType type) { return kBoundaryTypeNames[static_cast<std::size_t>(type)]; }

struct BoundaryPatch {
  std::string name;
  BoundaryType type = BoundaryType::Other;
  friend bool operator==(const BoundaryPatch&, const BoundaryPatch&) = default;
};

/// In place of the fourth node of a triangle.
inline constexpr NodeIndex kNoFourthNode = ~NodeIndex{0};

/// Nodes of a mesh, counterclockwise seen from outside of it; kNoFourthNode in the fourth place of a triangle.
using BoundaryFace = std::array<NodeIndex, 4>;

constexpr int size_of(const BoundaryFace& face) { return face[3] == kNoFourthNode ? 3 : 4; }

/// The boundary of a mesh: each face that belongs to one cell alone, once.
struct Boundary {
  std::vector<BoundaryFace> faces;
  std::vector<PatchId> patch;                ///< (n_faces)
  IdVector<PatchId, BoundaryPatch> patches;  ///< unique names; some may have no faces
};

/// Faces of each patch, in the order of the boundary. Cost: O(n_faces).
IdVector<PatchId, std::vector<std::uint32_t>> faces_by_patch(const Boundary& boundary);

}  // namespace nearwall::mesh
