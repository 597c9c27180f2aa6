#pragma once

#include <nlohmann/json.hpp>

#include "nearwall/pipeline/report.h"

namespace nearwall::pipeline {

using Json = nlohmann::ordered_json;

/// Every value of the case in force, nested as in the case file. Independent of where the files lie.
Json case_json(const Case& settings);

}  // namespace nearwall::pipeline
