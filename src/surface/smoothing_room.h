#pragma once

#include <span>

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

}  // namespace nearwall::surface
