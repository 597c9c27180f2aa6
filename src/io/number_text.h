#pragma once

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <concepts>
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
  std::array<char, 3 * 32> text;  // a double takes 24 at most
  char* end = text.data();
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) *end++ = ' ';
    end = std::to_chars(end, text.data() + text.size(), p[axis]).ptr;
  }
  out.append(text.data(), end);
}

}  // namespace nearwall::io
