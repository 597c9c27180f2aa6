#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "nearwall/pipeline/report.h"

namespace nearwall::pipeline {

/// "99.9 %", for the page.
std::string percent(double value);

/// A patch that was to get layers, and that the fluid reaches.
bool is_wall(const PatchReport& patch);

/// Style class and label of each colour.
std::string legend(std::span<const std::pair<std::string_view, std::string_view>> entries);

/// The part of report.html that says where there is less than was asked, and why; empty where there is nothing to say.
std::string limits_of(const Report& report);

}  // namespace nearwall::pipeline
