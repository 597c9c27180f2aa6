#include <algorithm>

#include "nearwall/certify/certificate.h"
#include "nearwall/core/parallel.h"
#include "nearwall/search/self_intersection.h"

namespace nearwall::certify {

namespace {

/// Adds the triangles of the front, a face at a time.
class FrontBuilder {
 public:
  FrontBuilder(const mesh::Front& front, const mesh::Lines& lines) : front_(front), lines_(lines) {
    surface_.points.resize(front.n_lines());
    surface_.point_of_line.resize(front.n_lines());
    surface_.is_moved.resize(front.n_lines());
    parallel_for(front.n_lines(), [&](std::size_t i) {
      const LineId line(i);
      surface_.points[i] = lines.position(line, lines.windows[line].end);
      const VertexId v = front.line_vertex[line];
      surface_.is_moved[i] = lines.windows[line].moves() ? 1 : 0;
      surface_.point_of_line[line] = lines.windows[line].moves() ? line.index() : front.line_of(v).index();
    });
    surface_.triangles.reserve(front.faces.size());
    surface_.face.reserve(front.faces.size());
  }

  void add_wall(FrontFaceId f) {
    const auto& corners = front_.faces[f].lines;
    add(f, {point_of(corners[0]), point_of(corners[1]), point_of(corners[2])});
  }

  void add_virtual(FrontFaceId f) {
    if (const auto cap = mesh::cap_over(front_, lines_, f)) return add_cap(f, *cap);
    std::array<std::uint32_t, 4> outline{};
    std::size_t n = 0;
    for (int k = 0; k < front_.faces[f].size(); ++k) {
      const std::uint32_t point = point_of(front_.faces[f].lines[static_cast<std::size_t>(k)]);
      if (std::find(outline.begin(), outline.begin() + n, point) == outline.begin() + n) outline[n++] = point;
    }
    if (n == 3) add(f, {outline[0], outline[1], outline[2]});
  }

  FrontSurface take() { return std::move(surface_); }

 private:
  std::uint32_t point_of(LineId line) const { return surface_.point_of_line[line]; }

  void add(FrontFaceId f, const std::array<std::uint32_t, 3>& corners) {
    surface_.triangles.push_back(corners);
    surface_.face.push_back(f);
  }

  void add_cap(FrontFaceId f, const mesh::Cap& cap) {
    const auto apex = static_cast<std::uint32_t>(surface_.points.size());
    surface_.points.push_back(cap.corners[4]);
    surface_.is_moved.push_back(1);
    for (std::size_t k = 0; k < 4; ++k) {
      add(f, {cap.base[k].line.index(), cap.base[(k + 1) % 4].line.index(), apex});
    }
  }

  const mesh::Front& front_;
  const mesh::Lines& lines_;
  FrontSurface surface_;
};

}  // namespace

FrontSurface front_surface(const mesh::Front& front, const mesh::Lines& lines) {
  FrontBuilder builder(front, lines);
  for (const FrontFaceId f : front.faces.ids()) {
    if (front.is_wall(f)) {
      builder.add_wall(f);
    } else {
      builder.add_virtual(f);
    }
  }
  return builder.take();
}

std::vector<std::pair<FrontFaceId, FrontFaceId>> front_intersections(const FrontSurface& front,
                                                                     std::span<const char> changed) {
  std::vector<char> moved;
  if (!changed.empty()) {
    for (const FrontFaceId f : front.face) moved.push_back(changed[f.index()]);
    moved.resize(front.triangles.size(), 1);
  }
  const auto pairs = search::self_intersections({front.points, front.triangles}, moved);
  const std::size_t n_front = front.face.size();
  std::vector<std::pair<FrontFaceId, FrontFaceId>> result;
  result.reserve(pairs.size());
  const auto add_beside = [&](std::size_t t) {
    for (const FrontFaceId f : front.rest_beside[t - n_front]) {
      if (f.is_valid()) result.emplace_back(f, f);
    }
  };
  const auto moves = [&](std::size_t t) {
    const auto& corners = front.triangles[t];
    return std::any_of(corners.begin(), corners.end(), [&](std::uint32_t p) { return front.is_moved[p] != 0; });
  };
  for (const auto& [a, b] : pairs) {
    if (b < n_front) {
      result.emplace_back(front.face[a], front.face[b]);
    } else if (a < n_front && moves(a)) {
      result.emplace_back(front.face[a], front.face[a]);
    } else {
      if (a >= n_front) add_beside(a);
      add_beside(b);
    }
  }
  return result;
}

}  // namespace nearwall::certify
