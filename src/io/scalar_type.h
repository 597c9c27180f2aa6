#pragma once

#include <bit>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "io/cursor.h"

namespace nearwall::io {

/// Number types of binary files.
enum class ScalarType { None, Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };

/// Calls f with a value of the C++ type.
template <class F>
decltype(auto) with_type(ScalarType type, F&& f) {
  switch (type) {
    case ScalarType::Int8:
      return f(std::int8_t{});
    case ScalarType::UInt8:
      return f(std::uint8_t{});
    case ScalarType::Int16:
      return f(std::int16_t{});
    case ScalarType::UInt16:
      return f(std::uint16_t{});
    case ScalarType::Int32:
      return f(std::int32_t{});
    case ScalarType::UInt32:
      return f(std::uint32_t{});
    case ScalarType::Int64:
      return f(std::int64_t{});
    case ScalarType::UInt64:
      return f(std::uint64_t{});
    case ScalarType::Float32:
      return f(float{});
    case ScalarType::None:
    case ScalarType::Float64:
      break;
  }
  return f(double{});
}

inline std::size_t size_of(ScalarType type) {
  return with_type(type, [](auto value) { return sizeof(value); });
}

inline bool is_real(ScalarType type) {
  return with_type(type, [](auto value) { return std::is_floating_point_v<decltype(value)>; });
}

/// A value of a file as T. Reals that do not fit an integer T become its −1.
template <class T, class Value>
T converted(Value value) {
  if constexpr (std::is_floating_point_v<Value> && std::is_integral_v<T>) {
    constexpr double kEdge = 9.0e18;  // inside the range of 64-bit integers
    const double wide = static_cast<double>(value);
    return wide > -kEdge && wide < kEdge ? static_cast<T>(wide) : T{-1};
  } else {
    return static_cast<T>(value);
  }
}

/// One value of `type` at `from`, as T.
template <class T>
T decode_as(ScalarType type, const char* from, std::endian order) {
  return with_type(type, [&](auto kind) { return converted<T>(Cursor::decode<decltype(kind)>(from, order)); });
}

}  // namespace nearwall::io
