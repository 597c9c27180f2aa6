#pragma once

#include <source_location>
#include <string_view>

namespace nearwall {

namespace detail {
[[noreturn]] void fail_expectation(std::string_view what, const std::source_location& where);
}

/// Checks an invariant of our own, always: a failure is a defect of nearwall and throws InternalError. For cheap
/// checks.
inline void expect(bool holds, std::string_view what,
                   const std::source_location& where = std::source_location::current()) {
  if (!holds) detail::fail_expectation(what, where);
}

/// The same for checks that cost more than O(1): evaluated in builds with NEARWALL_CHECKED only.
template <class Condition>
void expect_costly([[maybe_unused]] Condition&& condition, [[maybe_unused]] std::string_view what,
                   [[maybe_unused]] const std::source_location& where = std::source_location::current()) {
#ifdef NEARWALL_CHECKED
  expect(condition(), what, where);
#endif
}

}  // namespace nearwall
