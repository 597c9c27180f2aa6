#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "nearwall/core/vec3.h"

namespace nearwall::search {

/// In place of the fourth corner of a triangle.
inline constexpr std::uint32_t kNoCorner = 0xffffffff;

/// Triangles and bilinear patches over four corners, that know which corners are one node: patches that share a node
/// number share the point.
struct IndexedPatches {
  std::span<const Vec3> points;                           ///< (n_points)
  std::span<const std::array<std::uint32_t, 4>> corners;  ///< (n_patches) counterclockwise; indices into points
};

/// Pairs (i < j) of patches, sorted.
struct PatchPairs {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> undecided;
  bool is_complete = true;  ///< false: there were so many that the search stopped
};

/// Patches on a tree of boxes. A patch whose corners lie in one plane is known exactly; of a warped one it is known on
/// which side points are, exactly, and what is apart from its hull, the tetrahedron of its corners, or from the hulls
/// of pieces of it. Queries may run on many threads. The points must outlive it. Source: docs/theory/certificate.md.
class PatchTree {
 public:
  /// \throws InputError if a coordinate is not finite.    Cost: O(n log n), on all threads.
  explicit PatchTree(const IndexedPatches& patches);
  ~PatchTree();
  PatchTree(const PatchTree&) = delete;
  PatchTree& operator=(const PatchTree&) = delete;

  /// Pairs that meet elsewhere than in the corners and edges they share by index, and pairs for which that cannot be
  /// told: of these one at least is warped, and its hull meets the other, or the hulls of its pieces do.
  /// \param limit  pairs of both kinds from which on the search stops, after a block of patches
  /// Cost: O(n log n + pairs of boxes), on all threads; the same whatever their number.
  PatchPairs intersections(std::size_t limit) const;

  /// Two points between which a straight way crosses one patch, once, and meets no other.
  struct Gate {
    Vec3 behind;  ///< on the side from which the corners are seen clockwise
    Vec3 before;
  };
  /// nullopt: none was found near the middle of the patch.
  std::optional<Gate> gate(std::uint32_t patch) const;

  /// Winding number of all patches about a point; they must close. +1 inside a body of which they are seen
  /// counterclockwise from outside. \returns  nullopt if the point lies on a patch, or on triangles of three corners of
  /// one to either side of it.    Cost: O(log n + crossings).
  std::optional<int> winding_number(const Vec3& point) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace nearwall::search
