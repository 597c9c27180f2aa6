#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "nearwall/core/vec3.h"
#include "nearwall/geometry/box.h"
#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::search {

/// Axis-aligned box tree over the triangles of a surface, for ray, gap and box queries. Queries may run on many
/// threads. What is hit is decided exactly; distances are in doubles, computed the same way whatever the order of the
/// axes. Cost: O(n log n) to build, O(log n + hits) a query.
class WallTree {
 public:
  explicit WallTree(const mesh::SurfaceMesh& surface);
  ~WallTree();
  WallTree(const WallTree&) = delete;
  WallTree& operator=(const WallTree&) = delete;

  struct Hit {
    FaceId face;
    double distance = 0;  ///< from the start of the segment, in its own unit of length
  };

  /// Nearest triangle that the segment from `from` to `to` meets, among those for which `keep(face)` holds; an invalid
  /// face if none. Ties go to the smallest face id. A triangle in whose plane the segment runs counts as far away as
  /// its nearest point.
  Hit first_hit(const Vec3& from, const Vec3& to, const std::function<bool(FaceId)>& keep) const;

  /// Faces whose boxes meet the given box, in increasing order.
  std::vector<FaceId> faces_near(const geometry::Box& box) const;

  /// Faces whose boxes come as near to the centre as the radius, in increasing order.
  std::vector<FaceId> faces_near(const Vec3& centre, double radius) const;

  /// Point of one face nearest to p, to rounding; a corner bit for bit.
  Vec3 nearest_on(FaceId face, const Vec3& p) const;

  /// Nearest point of the surface; ties go to the smallest face id. The surface must have a face.
  struct Nearest {
    FaceId face;
    Vec3 point;
    double distance = 0;
  };
  Nearest nearest(const Vec3& p) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace nearwall::search
