#include "volume/face_table.h"

#include <algorithm>
#include <atomic>

#include "nearwall/core/parallel.h"

namespace nearwall::volume {

namespace {

/// One side of a face, filed under the least of its corners.
struct Side {
  std::uint32_t second = 0, third = 0;  ///< the other corners in the order seen from outside
  std::uint32_t owner = 0;              ///< 4 · tetrahedron + face; or triangle and kBoundary
  bool is_triangle = false;
};

struct Filed {
  std::uint32_t least;
  Side side;
};

Filed file(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t owner, bool is_triangle) {
  if (b < a && b < c) return {b, {c, a, owner, is_triangle}};
  if (c < a && c < b) return {c, {a, b, owner, is_triangle}};
  return {a, {b, c, owner, is_triangle}};
}

/// Sides by the least of their corners: offsets and sides, filled in the order of their owners.
struct Files {
  std::vector<std::size_t> begin;
  std::vector<Side> sides;
};

Files file_all(std::size_t n_points, std::span<const std::array<std::uint32_t, 4>> tetrahedra,
               std::span<const std::array<std::uint32_t, 3>> triangles) {
  const auto for_all = [&](auto&& visit) {
    for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
      for (int k = 0; k < 4; ++k) {
        const auto& v = tetrahedra[t];
        const auto& c = kFaceCorners[k];
        visit(file(v[c[0]], v[c[1]], v[c[2]], static_cast<std::uint32_t>(4 * t + k), false));
      }
    }
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      // Seen from the tetrahedron beyond it a triangle of the boundary runs the other way round.
      const auto& t = triangles[f];
      visit(file(t[0], t[2], t[1], static_cast<std::uint32_t>(f), true));
    }
  };
  Files files;
  files.begin.assign(n_points + 1, 0);
  for_all([&](const Filed& filed) { ++files.begin[filed.least + 1]; });
  for (std::size_t i = 0; i < n_points; ++i) files.begin[i + 1] += files.begin[i];
  files.sides.resize(files.begin[n_points]);
  std::vector<std::size_t> next(files.begin.begin(), files.begin.end() - 1);
  for_all([&](const Filed& filed) { files.sides[next[filed.least]++] = filed.side; });
  return files;
}

/// The one other side of the same face, which runs the other way round; nullptr if there is none, or a third.
const Side* counterpart(std::span<const Side> sides, const Side& side) {
  const Side* found = nullptr;
  for (const Side& other : sides) {
    if (&other == &side) continue;
    const bool is_opposite = other.second == side.third && other.third == side.second;
    const bool is_same = other.second == side.second && other.third == side.third;
    if (is_same || (is_opposite && found)) return nullptr;
    if (is_opposite) found = &other;
  }
  return found;
}

}  // namespace

FaceTable::FaceTable(std::size_t n_points, std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                     std::span<const std::array<std::uint32_t, 3>> triangles)
    : beyond_(4 * tetrahedra.size(), kNothing) {
  const Files files = file_all(n_points, tetrahedra, triangles);
  std::vector<char> is_matched(triangles.size(), 0);
  std::atomic<std::size_t> n_unmatched = 0;
  parallel_for(n_points, [&](std::size_t i) {
    const auto sides = std::span(files.sides).subspan(files.begin[i], files.begin[i + 1] - files.begin[i]);
    for (const Side& side : sides) {
      const Side* other = counterpart(sides, side);
      const bool is_paired = other && !(side.is_triangle && other->is_triangle);
      if (side.is_triangle) {
        is_matched[side.owner] = is_paired;
      } else if (!is_paired) {
        ++n_unmatched;
      } else {
        beyond_[side.owner] = other->is_triangle ? other->owner | kBoundary : other->owner / 4;
      }
    }
  });
  n_unmatched_faces_ = n_unmatched;
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    if (!is_matched[f]) unmatched_triangles_.push_back(f);
  }
}

}  // namespace nearwall::volume
