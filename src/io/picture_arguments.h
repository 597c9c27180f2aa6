#pragma once

#include <span>
#include <string>
#include <vector>

#include "nearwall/io/picture.h"

namespace nearwall::io {

/// How a picture goes to the process that renders it: as words NAME=VALUE.
std::vector<std::string> to_arguments(const PictureRequest& request);

/// \throws InputError  an unknown name or a value that is no number
PictureRequest request_of(std::span<const std::string> arguments);

/// How that process says what went wrong, by its exit code; the message is on its standard error.
enum class RenderExit { Made = 0, Input = 2, Geometry = 3, Io = 5, NotPossible = 10 };

}  // namespace nearwall::io
