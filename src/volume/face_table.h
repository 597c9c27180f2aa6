#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nearwall::volume {

/// Corners of the four faces of a tetrahedron, each counterclockwise seen from outside; face k is opposite corner k.
inline constexpr int kFaceCorners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

/// Which tetrahedron is beyond each face of each tetrahedron.
class FaceTable {
 public:
  /// Beyond a triangle of the boundary: its number and this bit.
  static constexpr std::uint32_t kBoundary = 0x80000000;
  /// Beyond a face that has no counterpart, or too many.
  static constexpr std::uint32_t kNothing = 0xffffffff;

  /// \param triangles  of the boundary, counterclockwise seen from outside
  /// Cost: O(n_tetrahedra), on all threads.
  FaceTable(std::size_t n_points, std::span<const std::array<std::uint32_t, 4>> tetrahedra,
            std::span<const std::array<std::uint32_t, 3>> triangles);

  /// The tetrahedron, or the triangle and kBoundary, beyond face k of tetrahedron t; kNothing.
  std::uint32_t beyond(std::size_t t, int k) const { return beyond_[4 * t + static_cast<std::size_t>(k)]; }

  std::size_t n_unmatched_faces() const { return n_unmatched_faces_; }
  /// Sorted.
  const std::vector<std::uint32_t>& unmatched_triangles() const { return unmatched_triangles_; }

 private:
  std::vector<std::uint32_t> beyond_;
  std::size_t n_unmatched_faces_ = 0;
  std::vector<std::uint32_t> unmatched_triangles_;
};

}  // namespace nearwall::volume
