#pragma once

#include <span>
#include <vector>

#include "nearwall/mesh/topology.h"
#include "nearwall/surface/features.h"
#include "nearwall/surface/point_normals.h"

namespace nearwall::surface {

/// How far the direction of a vertex may move: half of its room to the edge of the visibility cone stays.
struct Room {
  Vec3 given;                      ///< the direction it starts from
  double smallest_cosine = 1;      ///< that a direction may have to a face
  double squared_free_chord = -1;  ///< nearer to `given` than this, a direction needs no look at the faces
};

Room room_of(const PointNormal& given);

/// Whether `wanted` is so near to the given direction that it lies in the room wherever the faces are.
inline bool is_surely_in(const Room& room, const Vec3& wanted) {
  return squared_norm(wanted - room.given) < room.squared_free_chord;
}

/// `wanted` if it lies in the room, else the last direction on the arc from the given one to it that does.
/// \param normals  of the faces round the vertex; their sides are decided exactly
Vec3 drawn_back(const Vec3& wanted, const Room& room, std::span<const Vec3> normals);

/// Lists the unit normals of the faces round one vertex after the other, in memory that is used again.
class FaceNormals {
 public:
  FaceNormals(const mesh::Topology& topology, const Features& features) : topology_(topology), features_(features) {}

  /// Normals round v without those of faces without area; valid until the next call.
  std::span<const Vec3> round(VertexId v);

 private:
  const mesh::Topology& topology_;
  const Features& features_;
  std::vector<Vec3> normals_;
};

}  // namespace nearwall::surface
