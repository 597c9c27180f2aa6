#pragma once

#include <string_view>

#include "pipeline/case_document.h"
#include "pipeline/case_keys.h"

namespace nearwall::pipeline {

/// The value of an entry in the type of its key. \throws InputError with its place, what was found, what is allowed
CaseValue checked_value(const Entry& entry, const Key& key);

/// The same of a number without "auto".
double checked_number(const Entry& entry, const Key& key);

/// \param more  said behind what was found
[[noreturn]] void reject_value(const Entry& entry, const Key& key, std::string_view more = "");

}  // namespace nearwall::pipeline
