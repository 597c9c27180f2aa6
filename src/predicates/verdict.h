#pragma once

#include <algorithm>

#include "nearwall/predicates/cells.h"

namespace nearwall::predicates {

/// Answer of an arithmetic that may not know: Open means that the error bound leaves it to the exact arithmetic.
enum class Verdict { No, Open, Yes };

inline Verdict both(Verdict a, Verdict b) { return std::min(a, b); }
inline Verdict either(Verdict a, Verdict b) { return std::max(a, b); }

inline Positivity to_positivity(Verdict v) {
  if (v == Verdict::Open) return Positivity::Undecided;
  return v == Verdict::Yes ? Positivity::Positive : Positivity::NotPositive;
}

}  // namespace nearwall::predicates
