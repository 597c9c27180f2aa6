#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "nearwall/mesh/cap.h"
#include "nearwall/mesh/cell.h"
#include "nearwall/mesh/front.h"
#include "nearwall/mesh/lines.h"

namespace nearwall::mesh {

/// The cell of the column over one front face between `level` and `level + 1`, by the one rule: take the bottom nodes
/// and the top nodes and drop repeats. nullopt where three nodes or fewer are left. Source: docs/theory/columns.md.
std::optional<LayerCell> column_cell(const Front& front, const Lines& lines, FrontFaceId face, Level level);

/// Whether all cells over a wall triangle are wedges from the wall up, as nearly always: its lines move alike.
bool has_wedges_only(const Front& front, const Lines& lines, FrontFaceId face);

/// Levels [first, last) between which at least one line of the face may move.
std::pair<Level, Level> level_range(const Front& front, const Lines& lines, FrontFaceId face);

/// Coordinates of the nodes of a cell; the first size_of(type) are set.
std::array<Vec3, 8> corners_of(const Lines& lines, const LayerCell& cell);

/// All layers and the caps on them: front and lines, and the numbering of nodes and cells that follows from them. Cells
/// are derived, never stored. Memory: O(n_lines + n_front_faces). The referred front and lines must outlive it and keep
/// their windows.
class LayerMesh {
 public:
  LayerMesh(const Front& front, const Lines& lines);

  const Front& front() const { return *front_; }
  const Lines& lines() const { return *lines_; }

  NodeIndex n_nodes() const { return n_nodes_; }
  CellIndex n_cells() const { return column_offset_.back() + caps_.size(); }
  std::size_t n_columns() const { return column_offset_.size() - 1; }
  const std::array<CellIndex, kNCellTypes>& n_cells_by_type() const { return n_by_type_; }

  /// Number of a node: base vertices first (0 … n_vertices − 1), then the moving levels line by line.
  NodeIndex node(LineId line, Level level) const {
    const Window w = lines_->windows[line];
    if (!w.moves() || level <= w.start) return front_->line_vertex[line].index();
    const Level j = level < w.end ? level : w.end;
    return line_offset_[line.index()] + static_cast<NodeIndex>(j - w.start - 1);
  }
  NodeIndex node(const LineNode& n) const { return node(n.line, n.level); }

  /// First cell of a column; cells of column f are column_offset(f) … column_offset(f + 1) − 1, from the wall up.
  CellIndex column_offset(FrontFaceId f) const { return column_offset_[f.index()]; }
  CellIndex column_end(FrontFaceId f) const { return column_offset_[f.index() + 1]; }

  /// Virtual faces with a cap, in increasing order. Cap i is cell n_cells() − caps().size() + i, its apex the node
  /// n_nodes() − caps().size() + i.
  const std::vector<FrontFaceId>& caps() const { return caps_; }

  /// Calls visit(const LayerCell&, Level) for the cells of a column from the wall up; level is that of the bottom.
  template <class Visit>
  void for_each_cell(FrontFaceId f, Visit&& visit) const {
    const auto [first, last] = level_range(*front_, *lines_, f);
    for (Level level = first; level < last; ++level) {
      if (const auto cell = column_cell(*front_, *lines_, f, level)) visit(*cell, level);
    }
  }

 private:
  const Front* front_;
  const Lines* lines_;
  std::vector<NodeIndex> line_offset_;    // (n_lines)
  std::vector<CellIndex> column_offset_;  // (n_front_faces + 1)
  std::vector<FrontFaceId> caps_;
  std::array<CellIndex, kNCellTypes> n_by_type_{};
  NodeIndex n_nodes_ = 0;
};

}  // namespace nearwall::mesh
