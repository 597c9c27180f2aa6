#pragma once

#include <span>

#include "nearwall/surface/point_normals.h"

namespace nearwall::surface {

/// A computed cosine of two unit vectors above this is positive, whatever was rounded on the way: some five roundings
/// of 2^-53 in the vectors and their product.
inline constexpr double kSurelyPositive = 0x1p-50;

/// Whether `direction` sees all normals, of any length: exact for the doubles as given.
bool sees_all(const Vec3& direction, std::span<const Vec3> normals);

/// Squared chord from `direction` to the farthest of the normals: cosine 1 - s / 2, angle 2 asin(sqrt(s) / 2).
double squared_chord_to_worst(const Vec3& direction, std::span<const Vec3> normals);

/// The unit vector `direction` as the normal of a vertex whose faces have these unit normals; zero sees nothing.
/// \param squared_chord  to the worst of them
PointNormal judged(const Vec3& direction, std::span<const Vec3> normals, double squared_chord);

/// `most_visible_normal` without its preparation.
/// \param given  finite and not zero    \param units  the same, normalised; at least one
std::optional<VisibleNormal> most_visible_of(std::span<const Vec3> given, std::span<const Vec3> units);

}  // namespace nearwall::surface
