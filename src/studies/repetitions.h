#pragma once

#include <string_view>

#include <fmt/format.h>

#include "nearwall/core/errors.h"

namespace nearwall::studies {

/// \throws InputError if there is nothing to repeat
inline void check_repetitions(std::string_view study, int repetitions) {
  if (repetitions < 1) {
    throw InputError(fmt::format("study {}: expected at least 1 repetition, found {}", study, repetitions));
  }
}

}  // namespace nearwall::studies
