#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace nearwall::spacing {

/// How heights grow from layer to layer. Source: docs/theory/spacing.md.
enum class Law {
  Geometric,     ///< constant ratio, Eq. (1)
  Accelerating,  ///< a few layers of one height, then a ratio that itself grows up to a cap, Eq. (5)
  Tanh,          ///< hyperbolic tangent between the wall and the total thickness, Eq. (6)
  Table,         ///< heights given one by one
};

/// Name of a law as in the case file: "geometric", …
std::string_view law_name(Law law);

inline constexpr double kDefaultGrowth = 1.2;
inline constexpr int kDefaultCount = 30;
inline constexpr double kMaxGrowth = 2.0;  ///< ratio from layer to layer that no schedule may exceed [-]
inline constexpr int kMaxCount = 1000;     ///< layers

/// What is asked for. Of the four quantities any three determine the fourth; with fewer, growth is kDefaultGrowth, and
/// count kDefaultCount where growth is given (or taken). One of the two lengths is needed.
struct ScheduleRequest {
  Law law = Law::Geometric;
  std::optional<double> first_height;     ///< [length], > 0
  std::optional<double> growth;           ///< ratio of the first two heights that differ [-], 1 … kMaxGrowth
  std::optional<int> count;               ///< layers, 1 … kMaxCount
  std::optional<double> total_thickness;  ///< [length], > 0
  std::vector<double> heights;            ///< (n_layers) [length], > 0; for Law::Table only

  // Law::Accelerating only.
  int constant_layers = 5;      ///< layers of one height at the wall, >= 1
  double acceleration = 0.05;   ///< by which the ratio grows from layer to layer [-], >= 0
  double largest_growth = 1.5;  ///< cap of the ratio [-], growth … kMaxGrowth
};

/// A schedule with all four quantities known.
struct Schedule {
  Law law = Law::Geometric;
  double first_height = 0;      ///< [length]
  double growth = 1;            ///< [-]; for a table the largest ratio of successive heights
  int count = 0;                ///< layers
  double total_thickness = 0;   ///< [length], the sum of the heights
  std::vector<double> heights;  ///< (count) [length], from the wall up
};

/// Fills in what is not given. Where the count follows from the other three it is the smallest with which the asked
/// thickness is reached; the growth is then lowered a little so that it is reached exactly (and where a growth of 1 is
/// still too thick, the first height).
/// Scaling the lengths by a power of two scales the result, bit for bit.
/// \throws InputError  where quantities are missing, out of range or contradict each other; says what to change.
/// Cost: O(count), times some 60 where the growth is solved for.   Source: docs/theory/spacing.md
Schedule solve_schedule(const ScheduleRequest& request);

/// The heights of `solve_schedule`: (n_layers) [length], from the wall up.
std::vector<double> layer_heights(const ScheduleRequest& request);

/// Thickness of a stack of layers whose heights grow by a constant ratio.
/// \param first_height  [length], > 0     \param growth  [-], >= 1     \param count  layers, >= 1
/// \returns sum of the heights [length]; tends to count * first_height as growth -> 1 without loss of digits (the
/// closed
///          form is 0/0 there and has a branch of its own)
/// \throws InputError outside these ranges.    Cost: O(1).    Source: docs/theory/spacing.md, Eqs. (2), (3)
double total_thickness(double first_height, double growth, int count);

/// The ratio for which `count` layers, the first of height `first_height`, are `thickness` thick: the inverse of
/// `total_thickness`, to a few units in the last place.
/// \throws InputError  if the ratio would be below 1 or above kMaxGrowth.   Source: docs/theory/spacing.md, Eq. (4)
double growth_ratio(double first_height, int count, double thickness);

}  // namespace nearwall::spacing
