#include "nearwall/mesh/layer_mesh.h"

#include <algorithm>

namespace nearwall::mesh {

bool has_wedges_only(const Front& front, const Lines& lines, FrontFaceId f) {
  if (!front.is_wall(f)) return false;
  const FrontFace& face = front.faces[f];
  const Window w = lines.windows[face.lines[0]];
  return w.start == 0 && w == lines.windows[face.lines[1]] && w == lines.windows[face.lines[2]];
}

std::pair<Level, Level> level_range(const Front& front, const Lines& lines, FrontFaceId f) {
  const FrontFace& face = front.faces[f];
  std::pair<Level, Level> range{0, 0};
  bool any = false;
  for (int k = 0; k < face.size(); ++k) {
    const Window w = lines.windows[face.lines[static_cast<std::size_t>(k)]];
    if (!w.moves()) continue;
    range.first = any ? std::min(range.first, w.start) : w.start;
    range.second = any ? std::max(range.second, w.end) : w.end;
    any = true;
  }
  return range;
}

LayerMesh::LayerMesh(const Front& front, const Lines& lines) : front_(&front), lines_(&lines) {
  n_nodes_ = front.first_line.size() - 1;
  line_offset_.reserve(front.n_lines());
  for (const LineId line : lines.windows.ids()) {
    line_offset_.push_back(n_nodes_);
    const Window w = lines.windows[line];
    if (w.moves()) n_nodes_ += static_cast<NodeIndex>(w.end - w.start);
  }

  column_offset_.reserve(front.faces.size() + 1);
  column_offset_.push_back(0);
  for (const FrontFaceId f : front.faces.ids()) {
    CellIndex n = 0;
    if (has_wedges_only(front, lines, f)) {
      n = lines.windows[front.faces[f].lines[0]].end;
      n_by_type_[static_cast<std::size_t>(CellType::Wedge)] += n;
    } else {
      for_each_cell(f, [&](const LayerCell& cell, Level) {
        ++n_by_type_[static_cast<std::size_t>(cell.type)];
        ++n;
      });
    }
    column_offset_.push_back(column_offset_.back() + n);
    if (has_cap(front, lines, f)) caps_.push_back(f);
  }
  n_nodes_ += caps_.size();
  n_by_type_[static_cast<std::size_t>(CellType::Pyramid)] += caps_.size();
}

}  // namespace nearwall::mesh
