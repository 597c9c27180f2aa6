#pragma once

#include <string>
#include <vector>

namespace nearwall::studies {

/// An axis of a plot: which numbers it spans and where they lie along its length, 0 to 1.
class Axis {
 public:
  /// \param values  what it has to show; a logarithmic axis passes over those that are not positive
  /// \throws InputError if there is none to show
  Axis(const std::vector<double>& values, bool is_log);

  static bool can_show(double value, bool is_log);
  bool can_show(double value) const { return can_show(value, is_log_); }
  /// Place of a value, 0 at the low end.
  double place(double value) const;
  /// Round numbers within the axis, for lines of the grid and their labels.
  const std::vector<double>& ticks() const { return ticks_; }
  static std::string label(double tick);

 private:
  void place_linear_ticks();
  void place_log_ticks();

  bool is_log_;
  double low_ = 0, high_ = 0;  ///< logarithms to base 10 on logarithmic axes
  std::vector<double> ticks_;
};

}  // namespace nearwall::studies
