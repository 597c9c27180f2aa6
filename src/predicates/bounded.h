#pragma once

#include <cmath>
#include <limits>

#include "predicates/verdict.h"

namespace nearwall::predicates {

/// Unit roundoff of doubles: fl(a op b) = (a op b)(1 + d), |d| <= u.
inline constexpr double kRoundoff = std::numeric_limits<double>::epsilon() / 2;

/// Far above what any underflow loses (2^-1074) and a normal number, so that adding it is cheap.
inline constexpr double kUnderflow = 0x1p-1000;

/// A double together with a bound on its distance from the exact result: running error analysis,
/// docs/theory/predicates.md, Eqs. (2) and (3). Overflow makes the bound infinite, so that no sign is certain any more.
class Bounded {
 public:
  Bounded() = default;
  explicit Bounded(double exact) : value_(exact) {}

  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    const double v = a.value_ + b.value_;
    return {v, (a.error_ + b.error_ + kRoundoff * std::abs(v)) * kInflate};
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) {
    const double v = a.value_ - b.value_;
    return {v, (a.error_ + b.error_ + kRoundoff * std::abs(v)) * kInflate};
  }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    const double v = a.value_ * b.value_;
    const double inherited = std::abs(a.value_) * b.error_ + std::abs(b.value_) * a.error_ + a.error_ * b.error_;
    return {v, (inherited + kRoundoff * std::abs(v) + kUnderflow) * kInflate};
  }

  friend Verdict is_positive(const Bounded& a) {
    if (a.value_ > a.error_) return Verdict::Yes;
    return a.value_ < -a.error_ ? Verdict::No : Verdict::Open;
  }
  friend Verdict is_nonnegative(const Bounded& a) {
    if (a.value_ >= a.error_) return Verdict::Yes;
    return a.value_ < -a.error_ ? Verdict::No : Verdict::Open;
  }

 private:
  /// Pays for the at most seven roundings in the bound itself: (1 - u)^8 (1 + 16 u) > 1.
  static constexpr double kInflate = 1.0 + 16.0 * kRoundoff;

  Bounded(double value, double error) : value_(value), error_(error) {}

  double value_ = 0;
  double error_ = 0;
};

}  // namespace nearwall::predicates
