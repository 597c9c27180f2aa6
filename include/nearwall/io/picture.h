#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "nearwall/core/vec3.h"

namespace nearwall::io {

/// A cut through the mesh; what lies on the side of the normal is taken away.
struct ClipPlane {
  Vec3 normal;                ///< any length but 0
  std::optional<Vec3> point;  ///< default: the middle of the bounding box
};

/// "x", "y", "z", "-x" …: across an axis through the middle; "x=0.3": at a coordinate; "nx,ny,nz": across a normal;
/// "nx,ny,nz,px,py,pz": also through a point. \throws InputError
ClipPlane parse_clip_plane(std::string_view text);

/// The part of the space that fills the picture.
struct ZoomBox {
  Vec3 low;
  Vec3 high;
};

/// What to show of which file, and how.
struct PictureRequest {
  std::filesystem::path input;                 ///< .vtu, .vtp or any surface of read_surface
  std::filesystem::path output;                ///< .png
  std::array<int, 2> size = {1600, 1000};      ///< pixels, 16 to 16384 each
  std::string colour_by;                       ///< a cell or point array; empty: one colour
  bool logarithmic = false;                    ///< colours by the logarithm; for arrays of positive values
  std::optional<std::array<double, 2>> range;  ///< of the colours; default: that of the array
  std::string title;                           ///< of the colour bar; default: the name of the array
  std::optional<ClipPlane> clip;
  std::optional<ZoomBox> zoom;
  std::optional<Vec3> view;  ///< from the object to the eye; default: against the clip plane, else from above and aside
  bool edges = true;         ///< edges of the cells
};

struct PictureResult {
  bool made = false;
  std::string reason;  ///< why not, in one line
};

/// Renders a picture off screen, on a display if there is one, else on a private Xvfb. It is done in a process of its
/// own, so nothing that OpenGL does can harm the caller; it is stopped after a minute.
///
/// \returns made == false, with a reason, where this machine cannot make pictures (no Xvfb, no OpenGL, timeout)
/// \throws InputError     the request: no such file or array, wrong size or plane
///         GeometryError  the input file is malformed
///         IoError        the input cannot be read or the picture cannot be written
PictureResult render_picture(const PictureRequest& request);

}  // namespace nearwall::io
