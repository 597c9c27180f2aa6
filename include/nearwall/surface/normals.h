#pragma once

#include <optional>
#include <span>

#include "nearwall/core/vec3.h"

namespace nearwall::surface {

/// Direction that sees its worst face best.
struct VisibleNormal {
  Vec3 direction;        ///< unit vector
  double max_angle = 0;  ///< angle to the worst of the given normals [rad], < pi / 2
};

/// The most visible normal: the direction whose largest angle to the given normals is smallest, by the direct method of
/// pairs and triples (Aubry & Loehner 2008, section 4, put right in docs/theory/normals.md). It is the centre of the
/// smallest cap that holds all normals.
/// \param face_normals  any number, of any length; duplicates and zero vectors are passed over
/// \returns  nullopt if no direction sees all faces (decided exactly), or if there is no face
/// \throws   InputError if a normal is not finite
/// Worst angle optimal to 1e-8 rad, for cones open by as little as 1e-6 rad. In cones thinner than about 1e-15 rad no
/// unit vector of doubles may see all faces: the direction is then the best rounded one.
/// The same bits on permuted axes and for normals scaled by powers of two. Cost: O(n) in practice, no memory for n
/// <= 24.
std::optional<VisibleNormal> most_visible_normal(std::span<const Vec3> face_normals);

/// Direction that keeps farthest from the faces themselves.
struct NormalNormal {
  Vec3 direction;                   ///< unit vector
  double min_distance = 0;          ///< angle to the nearest face [rad], in (0, pi)
  bool in_visibility_cone = false;  ///< whether it sees all faces: if not, one line is not enough here
};

/// The most normal normal: the direction in the fluid whose smallest angle to the faces round `apex` (as triangles, not
/// as planes) is largest: the centre of the largest circle that fits between the arcs in which the faces cut the unit
/// sphere (Aubry et al. 2015, put right in docs/theory/most-normal.md). Of several such directions, equal to 1e-10 rad,
/// the one nearest to the most visible normal.
/// \param ring  neighbours counterclockwise seen from outside, in at least three directions (those within 1e-15 rad
/// count as one); faces join successive ones and close up
/// \returns  nullopt if a neighbour is in the apex or successive ones are exactly opposite (a face without area), if no
/// direction sees all faces (a cone of less than about 1e-15 rad may be missed), or if the ring does not go round once
/// \throws   InputError if a coordinate is not finite
/// Distance optimal to 1e-9 rad. Cost: O(n) at most vertices, else O(n^2), 1 to 5 ms for n = 128. Up to 24 neighbours
/// take no memory.
std::optional<NormalNormal> most_normal_normal(const Vec3& apex, std::span<const Vec3> ring);

/// Weight of a face at its vertex A in a weighted normal, with b, c the lengths of its edges at A, alpha the angle
/// between them, a the length of the opposite edge.
/// Source: Ubach et al. 2013, equations (9) to (21); Bohdal 2017, section 2.1; docs/normals.md.
enum class Weight {
  Uniform,              ///< 1 (Gouraud)
  Area,                 ///< b c sin(alpha) / 2 (Akima)
  InverseArea,          ///< 2 / (b c sin(alpha))
  ProjectedArea,        ///< area seen along the z axis (Akima2), for height fields
  Angle,                ///< alpha (Thuermer)
  InverseRootEdges,     ///< 1 / sqrt(b c) (Little, r = 1/2)
  InverseEdges,         ///< 1 / (b c) (Little, r = 1)
  InverseSquaredEdges,  ///< 1 / (b c)^2 (Little, r = 2)
  Max,                  ///< sin(alpha) / (b c): exact on spheres
  LittleMax,            ///< (1 + sin(alpha)) / (2 b c)
  InverseDiameter,      ///< sin(alpha) / a
  AngleOverDiameter,    ///< alpha sin(alpha) / a
  InverseCircumArea,    ///< (sin(alpha) / a)^2
  AngleOverCircumArea,  ///< alpha (sin(alpha) / a)^2
};

/// Weighted mean of the unit normals of the faces round `apex`, normalised. Faces without area are passed over.
/// \param ring    neighbours counterclockwise seen from outside
/// \param closed  whether the last neighbour and the first span a face, too
/// \returns       unit vector; zero if the weighted normals cancel or no face has an area
/// Within 1e-13 of the formulas. Cost: O(n), no memory.
Vec3 weighted_normal(Weight weight, const Vec3& apex, std::span<const Vec3> ring, bool closed = true);

}  // namespace nearwall::surface
