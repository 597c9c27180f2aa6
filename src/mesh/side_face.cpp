#include "nearwall/mesh/side_face.h"

#include <algorithm>

namespace nearwall::mesh {

namespace {

/// The level among those of one place on a line that names it.
Level named_level(const Lines& lines, LineId line, Level level) {
  const Window w = lines.windows[line];
  return !w.moves() || level <= w.start ? Level{0} : std::min(level, w.end);
}

bool are_same(const Front& front, const Lines& lines, const LineNode& a, const LineNode& b) {
  const Level level_a = named_level(lines, a.line, a.level), level_b = named_level(lines, b.line, b.level);
  if (level_a != level_b) return false;
  return a.line == b.line || (level_a == 0 && front.line_vertex[a.line] == front.line_vertex[b.line]);
}

}  // namespace

SideFace side_face(const Front& front, const Lines& lines, LineId a, LineId b, Level level) {
  const auto above = static_cast<Level>(level + 1);
  SideFace face;
  for (const LineNode& node : {LineNode{a, level}, LineNode{b, level}, LineNode{b, above}, LineNode{a, above}}) {
    const auto end = face.nodes.begin() + face.size;
    const bool repeats = std::any_of(face.nodes.begin(), end,
                                     [&](const LineNode& other) { return are_same(front, lines, node, other); });
    if (!repeats) face.nodes[static_cast<std::size_t>(face.size++)] = node;
  }
  return face;
}

std::pair<Level, Level> level_range(const Lines& lines, LineId a, LineId b) {
  const Window wa = lines.windows[a], wb = lines.windows[b];
  if (!wa.moves() && !wb.moves()) return {0, 0};
  if (!wa.moves()) return {wb.start, wb.end};
  if (!wb.moves()) return {wa.start, wa.end};
  return {std::min(wa.start, wb.start), std::max(wa.end, wb.end)};
}

}  // namespace nearwall::mesh
