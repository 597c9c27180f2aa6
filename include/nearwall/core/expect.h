#pragma once

#include <string_view>

namespace nearwall {

namespace detail {

/// Where a call stands in the source, as default arguments see it.
struct Place {
  const char* file;
  int line;
  const char* function;
  static constexpr Place here(const char* file = __builtin_FILE(), int line = __builtin_LINE(),
                              const char* function = __builtin_FUNCTION()) {
    return {file, line, function};
  }
};

[[noreturn]] void fail_expectation(std::string_view what, const Place& where);

}  // namespace detail

/// Checks an invariant of our own, always: a failure is a defect of nearwall and throws InternalError. For cheap
/// checks.
inline void expect(bool holds, std::string_view what, const detail::Place& where = detail::Place::here()) {
  if (!holds) detail::fail_expectation(what, where);
}

/// The same for checks that cost more than O(1): evaluated in builds with NEARWALL_CHECKED only.
template <class Condition>
void expect_costly([[maybe_unused]] Condition&& condition, [[maybe_unused]] std::string_view what,
                   [[maybe_unused]] const detail::Place& where = detail::Place::here()) {
#ifdef NEARWALL_CHECKED
  expect(condition(), what, where);
#endif
}

}  // namespace nearwall
