#pragma once

#include <span>
#include <string>
#include <string_view>

#include "nearwall/quality/statistics.h"

namespace nearwall::pipeline {

/// A number for people: about `digits` significant digits.
std::string shown(double value, int digits = 4);

/// 1234567 with thin spaces.
std::string shown_count(std::uint64_t n);

/// A bar chart of a distribution as inline SVG, with its median marked.
std::string histogram(const quality::Statistics& statistics, std::string_view unit);

struct Share {
  std::string_view label;
  double percent = 0;
  std::string_view css_class;
};

/// One bar of 100 % made of shares.
std::string stacked_bar(std::span<const Share> shares);

}  // namespace nearwall::pipeline
