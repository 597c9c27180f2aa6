#include "nearwall/mesh/cap.h"

#include <algorithm>

namespace nearwall::mesh {

namespace {

/// Height of the apex over the plane of each corner, in widths: low caps stay clear of each other on a front that bends
/// inwards along a ridge.
constexpr double kCapHeight = 0.25;

/// Cosine below which the plane of a corner counts as if it leaned no more: bounds the height over badly warped quads.
constexpr double kLeastCosine = 0.125;

}  // namespace

Vec3 cap_apex(std::span<const Vec3, 4> b) {
  const Vec3 centre = (b[0] + b[1] + b[2] + b[3]) * 0.25;
  const Vec3 normal = normalized(cross(b[2] - b[0], b[3] - b[1]));
  const double width =
      0.5 * std::min(distance(b[0], b[1]) + distance(b[2], b[3]), distance(b[1], b[2]) + distance(b[3], b[0]));
  double height = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 corner = normalized(cross(b[(i + 1) % 4] - b[i], b[(i + 3) % 4] - b[i]));
    const double above = dot(b[i] - centre, corner) + kCapHeight * width;
    height = std::max(height, above / std::max(kLeastCosine, dot(normal, corner)));
  }
  return centre + normal * height;
}

bool has_cap(const Front& front, const Lines& lines, FrontFaceId f) {
  const FrontFace& face = front.faces[f];
  return face.size() == 4 &&
         std::all_of(face.lines.begin(), face.lines.end(), [&](LineId line) { return lines.windows[line].moves(); });
}

std::optional<Cap> cap_over(const Front& front, const Lines& lines, FrontFaceId f) {
  if (!has_cap(front, lines, f)) return std::nullopt;
  Cap cap;
  for (std::size_t k = 0; k < 4; ++k) {
    const LineId line = front.faces[f].lines[k];
    cap.base[k] = {line, lines.windows[line].end};
    cap.corners[k] = lines.position(line, cap.base[k].level);
  }
  cap.corners[4] = cap_apex(std::span<const Vec3, 5>(cap.corners).first<4>());
  return cap;
}

}  // namespace nearwall::mesh
