#pragma once

#include <fmt/format.h>

#include <concepts>
#include <iterator>
#include <span>
#include <string>

#include "nearwall/core/vec3.h"

namespace nearwall::io {

/// Appends whole numbers with blanks between them.
template <std::integral T>
void append_integers(std::string& out, std::span<const T> values) {
  bool is_first = true;
  for (const T value : values) {
    if (!is_first) out += ' ';
    is_first = false;
    const fmt::format_int text(value);
    out.append(text.data(), text.size());
  }
}

/// Appends three coordinates with blanks between them, each with as few digits as read back to the same double.
inline void append_coordinates(std::string& out, const Vec3& p) {
  fmt::format_to(std::back_inserter(out), "{} {} {}", p.x(), p.y(), p.z());
}

}  // namespace nearwall::io
