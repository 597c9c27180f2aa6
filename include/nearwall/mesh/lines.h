#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nearwall/core/id_vector.h"
#include "nearwall/core/ids.h"
#include "nearwall/core/vec3.h"

namespace nearwall::mesh {

/// Stacks of heights that lines refer to: row r holds the distances from the wall of levels 0 … n_levels, in the
/// unit of the surface. Within the rows of one schedule, row r + 1 is a slightly flatter stack of the same first
/// height.
class HeightTable {
 public:
  HeightTable() = default;
  /// \param rows  (n_rows) distances of the levels 0 … n_levels from the wall, the first of them 0; all of one length
  explicit HeightTable(const std::vector<std::vector<double>>& rows);

  std::size_t n_rows() const { return n_levels_ == 0 && data_.empty() ? 0 : data_.size() / (n_levels_ + 1u); }
  Level n_levels() const { return n_levels_; }
  const double* row(std::size_t r) const { return data_.data() + r * (n_levels_ + 1u); }

 private:
  std::vector<double> data_;
  Level n_levels_ = 0;
};

/// How far up its line each level lies: a blend of two neighbouring rows of the table, weight_0 row[r] + weight_1
/// row[r + 1]. Both rows begin with the same first height, so a blend keeps it and its thickness is continuous.
struct Heights {
  std::uint32_t row = 0;
  double weight_0 = 1;
  double weight_1 = 0;
};

/// The line moves between its levels start and end only: it stays at the wall up to `start` and at P(end) from `end`
/// on.
struct Window {
  Level start = 0;
  Level end = 0;
  bool moves() const { return end > start; }
  friend bool operator==(const Window&, const Window&) = default;
};

/// One straight piece of a line, from the distance `from` along the line on.
struct Piece {
  Vec3 direction;   ///< unit vector, times the factor by which heights are stretched on this line
  double from = 0;  ///< distance (of the height table) at which the piece begins; 0 for the first
};

/// The extrusion lines: base point, straight pieces, heights and window of each; never their points.
class Lines {
 public:
  IdVector<LineId, Vec3> base;             ///< (n_lines)
  std::vector<std::uint32_t> first_piece;  ///< (n_lines + 1)
  std::vector<Piece> pieces;
  IdVector<LineId, Heights> heights;  ///< (n_lines)
  IdVector<LineId, Window> windows;   ///< (n_lines)
  HeightTable table;

  std::size_t size() const { return base.size(); }

  /// Distance of a level from the wall in the measure of the height table, windows applied.
  double height(LineId line, Level level) const {
    const Window w = windows[line];
    if (!w.moves() || level <= w.start) return 0;
    const Level j = level < w.end ? level : w.end;
    const Heights& h = heights[line];
    const double* row = table.row(h.row);
    return h.weight_1 == 0 ? h.weight_0 * row[j] : h.weight_0 * row[j] + h.weight_1 * row[table.n_levels() + 1u + j];
  }

  /// The one source of coordinates: the point of `line` at `level`. Certificate, front and writers all call it.
  Vec3 position(LineId line, Level level) const { return point_at(line, height(line, level)); }

  /// Points of the levels first … last, into x, y, z (last − first + 1 each): bit for bit `position` of each.
  void positions(LineId line, Level first, Level last, double* x, double* y, double* z) const;

 private:
  Vec3 point_at(LineId line, double t) const {
    const Vec3& b = base[line];
    if (t == 0) return b;
    const std::uint32_t begin = first_piece[line.index()];
    const std::uint32_t end = first_piece[line.index() + 1];
    Vec3 p = b;
    for (std::uint32_t i = begin; i < end && pieces[i].from < t; ++i) {
      const double stop = i + 1 < end && pieces[i + 1].from < t ? pieces[i + 1].from : t;
      p += pieces[i].direction * (stop - pieces[i].from);
    }
    return p;
  }
};

}  // namespace nearwall::mesh
