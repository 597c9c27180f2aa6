#pragma once

#include <filesystem>
#include <optional>

#include "nearwall/io/picture.h"
#include "nearwall/layers/grow.h"

namespace nearwall::pipeline {

/// A place at which the layers are shown in section: at a ridge where there is one with layers, or where they are
/// thickest.
struct CloseUp {
  VertexId vertex;
  io::ClipPlane plane;
  io::ZoomBox zoom;
};

/// nullopt if no line moves.
std::optional<CloseUp> choose_close_up(const layers::Wall& wall, const layers::Growth& growth);

/// Writes the columns that the close-up shows, as a mesh of their own: the picture of a part must not need the memory
/// of the whole. \throws IoError
void write_columns_near(const layers::Wall& wall, const layers::Growth& growth, const CloseUp& place,
                        const std::filesystem::path& path);

}  // namespace nearwall::pipeline
