#pragma once

#include <string>
#include <string_view>

namespace nearwall {

/// Text as it may stand in XML and HTML, within elements and within attributes: what would be markup is escaped.
std::string escaped_markup(std::string_view text);

}  // namespace nearwall
