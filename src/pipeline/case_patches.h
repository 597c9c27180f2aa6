#pragma once

#include "nearwall/pipeline/case.h"

namespace nearwall::pipeline {

/// Checks what can be checked before the surface is known: heights are given somewhere, [layers] alone makes no
/// contradiction, y_plus comes with [flow]. \throws InputError
void check_heights(const Case& settings);

}  // namespace nearwall::pipeline
