#pragma once

#include <string>

#include "nearwall/pipeline/report.h"

namespace nearwall::program {

/// What came out on each patch, as text for about 120 columns: with many patches the rows of those that lack least are
/// put together in one, and long names and reasons are cut.
/// \param is_whole  every patch, name and reason
std::string coverage_table(const Report& report, bool is_whole);

/// "12 of 5,402 lines stay at the wall: curvature 8, one at (1, 0, 0.5) on 'hull'; patch-edge 4", one line; empty where
/// none does. Lines at the edge of a patch without layers come last: they were asked to.
std::string lines_at_wall(const Report& report);

}  // namespace nearwall::program
