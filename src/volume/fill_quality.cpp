#include "nearwall/volume/fill_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "nearwall/core/parallel.h"
#include "nearwall/geometry/angles.h"
#include "volume/face_table.h"

namespace nearwall::volume {

namespace {

constexpr std::size_t kInBlock = 32768;

// Widths of the bins: docs/theory/quality.md.
constexpr int kDihedralBins = 3600;
constexpr int kPerOctave = 512;
constexpr int kOctaves = 20;

using Corners = std::array<Vec3, 4>;

/// Angle between the faces at the six edges, the smallest [rad].
double smallest_dihedral(const Corners& p) {
  std::array<Vec3, 4> normal;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& c = kFaceCorners[k];
    normal[k] = cross(p[static_cast<std::size_t>(c[1])] - p[static_cast<std::size_t>(c[0])],
                      p[static_cast<std::size_t>(c[2])] - p[static_cast<std::size_t>(c[0])]);
  }
  double smallest = geometry::kPi;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      smallest = std::min(smallest, geometry::kPi - geometry::angle_between(normal[i], normal[j]));
    }
  }
  return smallest;
}

double volume_of(const Corners& p) { return dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) / 6; }

double radius_edge(const Corners& p) {
  const Vec3 a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  const Vec3 centre = (cross(b, c) * squared_norm(a) + cross(c, a) * squared_norm(b) + cross(a, b) * squared_norm(c)) /
                      (2 * dot(a, cross(b, c)));
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) shortest = std::min(shortest, squared_norm(p[i] - p[j]));
  }
  return norm(centre) / std::sqrt(shortest);
}

struct Parts {
  quality::Histogram dihedral{quality::Binning::linear(0, 90, kDihedralBins)};
  quality::Histogram radius_edge{quality::Binning::doublings(-1, kOctaves, kPerOctave)};
  quality::Histogram size_ratio{quality::Binning::doublings(0, kOctaves, kPerOctave)};

  void merge(const Parts& other) {
    dihedral.merge(other.dihedral);
    radius_edge.merge(other.radius_edge);
    size_ratio.merge(other.size_ratio);
  }
};

/// Mean height of the last layer over a front face; 0 where it has none.
double last_height(const mesh::LayerMesh& layers, FrontFaceId f) {
  const mesh::FrontFace& face = layers.front().faces[f];
  const mesh::Lines& lines = layers.lines();
  double sum = 0;
  int n = 0;
  for (int k = 0; k < face.size(); ++k) {
    const LineId line = face.lines[static_cast<std::size_t>(k)];
    const mesh::Window w = lines.windows[line];
    if (!w.moves()) return 0;
    sum += distance(lines.position(line, w.end), lines.position(line, static_cast<Level>(w.end - 1)));
    ++n;
  }
  return sum / n;
}

}  // namespace

FillQuality fill_quality(const mesh::LayerMesh& layers, const RestBoundary& rest, const Fill& fill) {
  const FaceTable table(fill.points.size(), fill.tetrahedra, rest.surface.triangles);
  const std::size_t n = fill.tetrahedra.size();
  const auto corners = [&](std::size_t t) {
    const auto& c = fill.tetrahedra[t];
    return Corners{fill.points[c[0]], fill.points[c[1]], fill.points[c[2]], fill.points[c[3]]};
  };
  std::vector<double> on_front(rest.n_front, 0);
  std::vector<Parts> parts((n + kInBlock - 1) / kInBlock);
  parallel_blocks(n, kInBlock, [&](std::size_t begin, std::size_t end) {
    Parts& part = parts[begin / kInBlock];
    for (std::size_t t = begin; t < end; ++t) {
      const Corners p = corners(t);
      const double volume = volume_of(p);
      part.dihedral.add(geometry::to_degrees(smallest_dihedral(p)));
      part.radius_edge.add(radius_edge(p));
      for (int k = 0; k < 4; ++k) {
        const std::uint32_t beyond = table.beyond(t, k);
        if (beyond == FaceTable::kNothing) continue;
        if (beyond & FaceTable::kBoundary) {
          const std::uint32_t triangle = beyond & ~FaceTable::kBoundary;
          const auto& c = kFaceCorners[k];
          const Vec3 base = cross(p[static_cast<std::size_t>(c[1])] - p[static_cast<std::size_t>(c[0])],
                                  p[static_cast<std::size_t>(c[2])] - p[static_cast<std::size_t>(c[0])]);
          if (triangle < rest.n_front) on_front[triangle] = 6 * volume / norm(base);
        } else if (beyond > t) {
          const double other = volume_of(corners(beyond));
          part.size_ratio.add(std::cbrt(std::max(volume, other) / std::min(volume, other)));
        }
      }
    }
  });
  Parts all;
  for (const Parts& part : parts) all.merge(part);
  quality::Histogram interface(quality::Binning::doublings(-kOctaves, kOctaves, kPerOctave));
  for (std::size_t t = 0; t < rest.n_front; ++t) {
    const double last = last_height(layers, rest.front_face[t]);
    if (last > 0 && on_front[t] > 0) interface.add(on_front[t] / last);
  }
  return {all.dihedral.statistics(), all.radius_edge.statistics(), all.size_ratio.statistics(), interface.statistics()};
}

}  // namespace nearwall::volume
