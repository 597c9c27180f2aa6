#pragma once

#include <vector>

namespace nearwall::planar {

/// Points along a segment whose distances grow from both ends: the wanted distance at s is the least of
/// size_begin + growth · s, size_end + growth · (length − s) and `largest`, and each piece holds the same share of the
/// integral of its reciprocal, which is rounded to a whole number of pieces.
/// \param length  of the segment, > 0     \param size_begin, size_end  wanted at its ends, > 0 [length]
/// \param growth  per unit of length [-], >= 0     \param largest  > 0, may be infinite [length]
/// \returns   the points' distances from the beginning, ascending, strictly between 0 and length; with the ends
///            exchanged, length minus these to rounding
/// \throws    InputError outside these ranges. Cost: O(points).
std::vector<double> graded_points(double length, double size_begin, double size_end, double growth, double largest);

}  // namespace nearwall::planar
