#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "nearwall/core/vec3.h"
#include "nearwall/predicates/intersection.h"
#include "nearwall/predicates/orientation.h"
#include "nearwall/search/patch_tree.h"
#include "search/patch_pieces.h"

namespace nearwall::search {

enum class PatchShape : std::uint8_t { Triangle, Planar, Warped };

/// A triangle or quad of which the exact parts are at hand: the triangles that make it up, or, if it is warped, those
/// of its hull.
class Patch {
 public:
  using Corners = std::array<std::uint32_t, 4>;

  Patch(std::span<const Vec3> points, const Corners& corners, PatchShape shape)
      : points_(points), corners_(corners), shape_(shape) {}

  /// Exactly planar or not.
  static PatchShape shape_of(std::span<const Vec3> points, const Corners& corners);

  PatchShape shape() const { return shape_; }
  bool is_warped() const { return shape_ == PatchShape::Warped; }
  int size() const { return shape_ == PatchShape::Triangle ? 3 : 4; }
  std::uint32_t node(int k) const { return corners_[static_cast<std::size_t>(k)]; }
  const Vec3& point(int k) const { return points_[node(k)]; }
  std::span<const Vec3> points() const { return points_; }

  /// 1 triangle, 2 that cut a quad along its first diagonal, or these and the 2 along the other one, which are the
  /// hull: the patch lies between the first two and the last two.
  int n_triangles() const { return shape_ == PatchShape::Triangle ? 1 : shape_ == PatchShape::Planar ? 2 : 4; }
  std::array<std::uint32_t, 3> triangle_nodes(int i) const;
  predicates::Triangle triangle(int i) const;

  /// Whether a point lies in the closed hull of a warped patch.
  bool hull_contains(const Vec3& p) const;
  /// Whether a straight way surely crosses the patch: for one that is warped, from one side of its hull to the other.
  bool is_surely_crossed(const Vec3& from, const Vec3& to) const;
  /// False: a straight way surely does not meet the patch.
  bool may_be_met(const Vec3& from, const Vec3& to) const;
  /// Corners for `are_surely_apart`.
  PatchCorners corners() const { return {point(0), point(1), point(2), point(size() == 3 ? 2 : 3)}; }
  /// Which side of the patch a point of its hull is on: positive where the corners are seen counterclockwise from.
  predicates::Sign side_in_hull(const Vec3& p) const;
  /// Mean of the corners: within the patch if it is planar.
  Vec3 middle() const;

 private:
  std::span<const Vec3> points_;
  Corners corners_;
  PatchShape shape_;
};

enum class PatchContact { Apart, Meeting, Undecided };

/// Whether two patches meet elsewhere than in what they share by index.
PatchContact contact(const Patch& a, const Patch& b);

}  // namespace nearwall::search
