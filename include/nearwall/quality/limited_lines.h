#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nearwall/core/id_vector.h"
#include "nearwall/core/vec3.h"
#include "nearwall/mesh/front.h"
#include "nearwall/mesh/limit_reason.h"
#include "nearwall/mesh/lines.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/quality/coverage.h"

namespace nearwall::quality {

/// Places that are kept for each reason.
inline constexpr std::size_t kPlacesForEachReason = 5;

/// A vertex whose lines have less than was asked.
struct LimitedVertex {
  VertexId vertex;
  PatchId patch;  ///< of the triangles round it that ask for layers, the one of the lowest number
  Vec3 place;
  std::uint32_t n_lines = 1;  ///< that stand on it and share its fate
  Level levels = 0;           ///< last level of the line; 0: it stays at the wall
  double reached = 0;         ///< thickness normal to the wall [length]
  double asked = 0;           ///< [length], > 0

  double share() const { return reached / asked; }
};

/// The lines that one reason has limited.
struct ReasonLines {
  std::uint64_t n_lines = 0;
  std::uint64_t n_at_wall = 0;       ///< of them: never leave the wall
  std::vector<LimitedVertex> worst;  ///< the smallest share first, equal ones by vertex
};

/// Which lines have less than was asked, why and where.
struct LimitedLines {
  std::uint64_t n_lines = 0;  ///< that are asked to leave the wall
  std::array<ReasonLines, mesh::kNLimitReasons> by_reason;
  /// (n_patches) limited lines by reason; a line counts to the patch of LimitedVertex::patch
  IdVector<PatchId, std::array<std::uint64_t, mesh::kNLimitReasons>> by_patch;

  std::uint64_t n_limited() const;
  std::uint64_t n_at_wall() const;
};

/// Every line that is asked for layers and has a reason. Cost: O(n_lines).
LimitedLines limited_lines(const mesh::SurfaceMesh& wall, const mesh::Front& front, const mesh::Lines& lines,
                           const LineOutcome& outcome, const IdVector<PatchId, PatchRequest>& requests);

}  // namespace nearwall::quality
