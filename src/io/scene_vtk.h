#pragma once

#include "nearwall/io/picture.h"

namespace nearwall::io {

/// Renders on the display that the environment names and writes the PNG file. Aborts the process where OpenGL fails.
/// \throws as render_picture
void render(const PictureRequest& request);

}  // namespace nearwall::io
