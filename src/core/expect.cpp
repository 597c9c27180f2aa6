#include "nearwall/core/expect.h"

#include <string>

#include <fmt/format.h>

#include "nearwall/core/errors.h"

namespace nearwall::detail {

void fail_expectation(std::string_view what, const Place& where) {
  throw InternalError(fmt::format("{}:{} ({}): expected {}", where.file, where.line, where.function, what));
}

}  // namespace nearwall::detail
