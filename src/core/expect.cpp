#include "nearwall/core/expect.h"

#include <string>

#include <fmt/format.h>

#include "nearwall/core/errors.h"

namespace nearwall::detail {

void fail_expectation(std::string_view what, const std::source_location& where) {
  throw InternalError(
      fmt::format("{}:{} ({}): expected {}", where.file_name(), where.line(), where.function_name(), what));
}

}  // namespace nearwall::detail
