#include <initializer_list>

#include "nearwall/core/expect.h"
#include "nearwall/mesh/layer_mesh.h"

// The one rule (docs/theory/columns.md): bottom nodes and top nodes of a front face, repeats dropped. What is left is
// one of the shapes below; B is a bottom node, T a top node, indices run counterclockwise seen from the fluid.

namespace nearwall::mesh {

namespace {

/// One step of a face between two levels: which lines move, and which nodes are still at the wall.
class Step {
 public:
  Step(const Front& front, const Lines& lines, FrontFaceId face, Level level)
      : front_(front), lines_(lines), face_(front.faces[face]), level_(level) {}

  int size() const { return face_.size(); }
  LineId line(int k) const { return face_.lines[static_cast<std::size_t>(k % size())]; }
  bool moves(int k) const {
    const Window w = lines_.windows[line(k)];
    return w.start <= level_ && level_ < w.end;
  }
  /// The bottom node is the wall's vertex.
  bool is_at_wall(int k) const {
    const Window w = lines_.windows[line(k)];
    return !w.moves() || level_ <= w.start;
  }
  VertexId vertex(int k) const { return front_.line_vertex[line(k)]; }
  bool shares_bottom(int i, int k) const { return vertex(i) == vertex(k) && is_at_wall(i) && is_at_wall(k); }

  LineNode bottom(int k) const { return {line(k), level_}; }
  LineNode top(int k) const { return {line(k), static_cast<Level>(level_ + 1)}; }

 private:
  const Front& front_;
  const Lines& lines_;
  const FrontFace& face_;
  Level level_;
};

LayerCell make_cell(CellType type, std::initializer_list<LineNode> nodes) {
  LayerCell cell;
  cell.type = type;
  std::size_t k = 0;
  for (const LineNode& n : nodes) cell.nodes[k++] = n;
  return cell;
}

/// Pyramid on the side face of the moving lines i and i + 1 (counterclockwise), its apex the node that stays.
LayerCell side_pyramid(const Step& s, int i, const LineNode& apex) {
  return make_cell(CellType::Pyramid, {s.bottom(i), s.top(i), s.top(i + 1), s.bottom(i + 1), apex});
}

/// Tetrahedron over the shared wall node of two lines i and i + 1 that part here, and one node that stays.
LayerCell parting_tetrahedron(const Step& s, int i, const LineNode& stays) {
  return make_cell(CellType::Tetrahedron, {s.bottom(i), stays, s.top(i), s.top(i + 1)});
}

std::optional<LayerCell> triangle_cell(const Step& s) {
  int n_moving = 0, n_shared = 0, moving = 0, staying = 0, shared = 0;
  for (int k = 0; k < 3; ++k) {
    if (s.moves(k)) {
      ++n_moving;
      moving = k;
    } else {
      staying = k;
    }
    if (s.shares_bottom(k, (k + 1) % 3)) {
      ++n_shared;
      shared = k;
    }
  }
  if (n_moving == 0) return std::nullopt;
  if (n_shared == 0) {
    if (n_moving == 3) {
      return make_cell(CellType::Wedge, {s.bottom(0), s.bottom(1), s.bottom(2), s.top(0), s.top(1), s.top(2)});
    }
    if (n_moving == 2) return side_pyramid(s, staying + 1, s.bottom(staying));
    return make_cell(CellType::Tetrahedron, {s.bottom(0), s.bottom(1), s.bottom(2), s.top(moving)});
  }
  if (n_shared == 3) {
    expect(n_moving == 3, "the lines of one vertex to share a window");
    return make_cell(CellType::Tetrahedron, {s.bottom(0), s.top(0), s.top(1), s.top(2)});
  }
  // Where only the lone line moves, three nodes are left: the two neighbours share the face.
  if (!s.moves(shared)) return std::nullopt;
  // Two lines of one vertex leave the wall here: the third must not, or the cell would be a wedge with a collapsed
  // edge.
  expect(n_moving == 2 && !s.moves(shared + 2), "the lone line at a fan's end to start late");
  return parting_tetrahedron(s, shared, s.bottom(shared + 2));
}

std::optional<LayerCell> quad_cell(const Step& s) {
  // Number the corners so that lines u and u + 3 stand on one wall vertex, u + 1 and u + 2 on the other.
  int u = s.vertex(0) == s.vertex(3) ? 0 : 1;
  expect(s.vertex(u) == s.vertex(u + 3) && s.vertex(u + 1) == s.vertex(u + 2), "a virtual quad over one ridge edge");
  if (!s.moves(u) && !s.moves(u + 1)) return std::nullopt;
  if (s.moves(u) && s.moves(u + 1)) {
    const bool first_parts = s.is_at_wall(u), second_parts = s.is_at_wall(u + 1);
    expect(first_parts == second_parts, "both ends of a ridge edge to leave the wall at one level");
    if (first_parts) {
      return make_cell(CellType::Wedge,
                       {s.bottom(u), s.top(u + 3), s.top(u), s.bottom(u + 1), s.top(u + 2), s.top(u + 1)});
    }
    return make_cell(CellType::Hexahedron,
                     {s.bottom(0), s.bottom(1), s.bottom(2), s.bottom(3), s.top(0), s.top(1), s.top(2), s.top(3)});
  }
  if (s.moves(u)) u += 2;  // now u stays and u + 1, u + 2 move
  if (s.is_at_wall(u)) {
    return s.is_at_wall(u + 1) ? parting_tetrahedron(s, u + 1, s.bottom(u)) : side_pyramid(s, u + 1, s.bottom(u));
  }
  expect(!s.is_at_wall(u + 1), "both ends of a ridge edge to leave the wall at one level");
  return make_cell(CellType::Wedge,
                   {s.bottom(u), s.top(u + 1), s.bottom(u + 1), s.bottom(u + 3), s.top(u + 2), s.bottom(u + 2)});
}

}  // namespace

std::optional<LayerCell> column_cell(const Front& front, const Lines& lines, FrontFaceId face, Level level) {
  const Step step(front, lines, face, level);
  return step.size() == 3 ? triangle_cell(step) : quad_cell(step);
}

std::array<Vec3, 8> corners_of(const Lines& lines, const LayerCell& cell) {
  std::array<Vec3, 8> corners;
  for (std::size_t k = 0; k < static_cast<std::size_t>(size_of(cell.type)); ++k) {
    corners[k] = lines.position(cell.nodes[k].line, cell.nodes[k].level);
  }
  return corners;
}

}  // namespace nearwall::mesh
