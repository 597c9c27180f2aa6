#include "nearwall/mesh/layer_neighbours.h"

#include <algorithm>
#include <limits>
#include <string>

#include "nearwall/core/errors.h"
#include "nearwall/mesh/side_face.h"

namespace nearwall::mesh {

namespace {

constexpr std::uint32_t kNothing = std::numeric_limits<std::uint32_t>::max();

/// An edge of a face of the front, from line a to line b.
struct FrontEdge {
  std::uint32_t a, b, code;
  friend bool operator<(const FrontEdge& x, const FrontEdge& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; }
};

LineId line_of(const FrontFace& face, int k) { return face.lines[static_cast<std::size_t>(k % face.size())]; }

std::vector<FrontEdge> edges_of(const Front& front) {
  std::vector<FrontEdge> edges;
  edges.reserve(3 * front.faces.size());
  for (const FrontFaceId f : front.faces.ids()) {
    for (int k = 0; k < front.faces[f].size(); ++k) {
      edges.push_back({line_of(front.faces[f], k).index(), line_of(front.faces[f], k + 1).index(),
                       4 * f.index() + static_cast<std::uint32_t>(k)});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Nodes of a face of a cell of a batch.
FaceNodes nodes_of(const CellBatch& cells, std::size_t c, const CellFace& face) {
  FaceNodes nodes{0, 0, 0, kNoNode};
  for (std::size_t k = 0; k < face.size; ++k) nodes[k] = static_cast<std::uint32_t>(cells.nodes[c][face.corners[k]]);
  return nodes;
}

/// The column that holds a cell.
std::size_t column_of(const LayerMesh& layers, CellIndex cell) {
  std::size_t begin = 0;
  for (std::size_t end = layers.n_columns(); begin < end;) {
    const std::size_t middle = begin + (end - begin) / 2;
    if (layers.column_end(FrontFaceId(middle)) <= cell) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  return begin;
}

bool has_all(const CellBatch& cells, std::size_t c, const FaceNodes& face) {
  const auto begin = cells.nodes[c].begin(), end = begin + size_of(cells.type[c]);
  return std::all_of(face.begin(), face.begin() + size_of(face),
                     [&](std::uint32_t node) { return std::find(begin, end, node) != end; });
}

}  // namespace

LayerNeighbours::LayerNeighbours(const LayerMesh& layers) : layers_(&layers), across_(layers.front().faces.size()) {
  if (layers.n_nodes() >= kNoNode) {
    throw InputError("formats that list faces hold at most " + std::to_string(kNoNode) + " points, the layers have " +
                     std::to_string(layers.n_nodes()));
  }
  const std::vector<FrontEdge> edges = edges_of(layers.front());
  for (auto& row : across_) row.fill(kNothing);
  for (const FrontEdge& edge : edges) {
    const FrontEdge back{edge.b, edge.a, 0};
    const auto found = std::lower_bound(edges.begin(), edges.end(), back);
    if (found == edges.end() || found->a != back.a || found->b != back.b) continue;
    across_[edge.code / 4][edge.code % 4] = found->code;
  }
}

std::optional<LayerNeighbours::Side> LayerNeighbours::across(Side side) const {
  const std::uint32_t code = across_[side.face.index()][static_cast<std::size_t>(side.edge)];
  if (code == kNothing) return std::nullopt;
  return Side{FrontFaceId(code / 4), static_cast<int>(code % 4)};
}

std::optional<CellIndex> LayerNeighbours::top_cell(FrontFaceId f) const {
  if (layers_->column_offset(f) == layers_->column_end(f)) return std::nullopt;
  return layers_->column_end(f) - 1;
}

/// The cell of a column at a level; nullopt where there is none.
std::optional<CellIndex> LayerNeighbours::cell_at(FrontFaceId f, Level level) const {
  const Front& front = layers_->front();
  const Lines& lines = layers_->lines();
  const auto [first, last] = level_range(front, lines, f);
  if (level < first || level >= last) return std::nullopt;
  const CellIndex offset = layers_->column_offset(f);
  if (layers_->column_end(f) - offset == static_cast<CellIndex>(last - first)) return offset + (level - first);
  if (!column_cell(front, lines, f, level)) return std::nullopt;
  CellIndex n = 0;
  for (Level j = first; j < level; ++j) n += column_cell(front, lines, f, j) ? 1 : 0;
  return offset + n;
}

/// Nodes of the face over an edge of the front, in the order of its key; nullopt where it has no area.
std::optional<FaceNodes> LayerNeighbours::side_nodes(Side side, Level level) const {
  const FrontFace& face = layers_->front().faces[side.face];
  const SideFace wall =
      side_face(layers_->front(), layers_->lines(), line_of(face, side.edge), line_of(face, side.edge + 1), level);
  if (wall.size < 3) return std::nullopt;
  FaceNodes nodes{0, 0, 0, kNoNode};
  for (std::size_t k = 0; k < static_cast<std::size_t>(wall.size); ++k) {
    nodes[k] = static_cast<std::uint32_t>(layers_->node(wall.nodes[k]));
  }
  return key_of(nodes).nodes;
}

/// The cell on the other side of the face over an edge. Where a column has no cell at that level, its neighbours share
/// the face: the search goes on through it.
std::optional<CellIndex> LayerNeighbours::cell_beyond(Side side, Level level) const {
  const auto nodes = side_nodes(side, level);
  for (auto other = across(side); nodes && other;) {
    if (const auto cell = cell_at(other->face, level)) return cell;
    std::optional<Side> onward;
    for (int k = 0; k < layers_->front().faces[other->face].size(); ++k) {
      const Side exit{other->face, k};
      if (k != other->edge && side_nodes(exit, level) == nodes) onward = across(exit);
    }
    other = onward;
  }
  return std::nullopt;
}

void LayerNeighbours::read_wedges(const Run& run, const Beyond& beyond, NeighbourBatch& out) const {
  const Front& front = layers_->front();
  const CellIndex offset = layers_->column_offset(run.column), column_end = layers_->column_end(run.column);
  const auto faces = cell_faces(CellType::Wedge);
  constexpr std::size_t kBottom = 0, kTop = 1, kFirstSide = 2;  // as cell_faces has them
  const auto outer = [&](std::size_t i, std::size_t k) { return beyond(nodes_of(run.cells, i, faces[k])); };
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const CellIndex cell = run.cells.first + i;
    out[i][kBottom] = cell > offset ? Neighbour::cell(cell - 1) : outer(i, kBottom);
    out[i][kTop] = cell + 1 < column_end ? Neighbour::cell(cell + 1) : outer(i, kTop);
  }
  for (int k = 0; k < 3; ++k) {
    const auto place = kFirstSide + static_cast<std::size_t>(k);
    const auto other = across({run.column, k});
    const bool is_plain = other && has_wedges_only(front, layers_->lines(), other->face);
    for (std::size_t i = run.begin; i < run.end; ++i) {
      const CellIndex j = run.cells.first + i - offset;
      if (is_plain) {
        out[i][place] = Neighbour::cell(layers_->column_offset(other->face) + j);
        continue;
      }
      const auto found = cell_beyond({run.column, k}, static_cast<Level>(j));
      out[i][place] = found ? Neighbour::cell(*found) : outer(i, place);
    }
  }
}

void LayerNeighbours::read_mixed(const Run& run, const Beyond& beyond, NeighbourBatch& out) const {
  const int n_edges = layers_->front().faces[run.column].size();
  std::array<std::optional<FaceNodes>, 4> sides;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const auto level = static_cast<Level>(run.cells.layer[i] - 1);
    for (int k = 0; k < n_edges; ++k) sides[static_cast<std::size_t>(k)] = side_nodes({run.column, k}, level);
    const auto faces = cell_faces(run.cells.type[i]);
    for (std::size_t k = 0; k < faces.size(); ++k) {
      const FaceNodes nodes = nodes_of(run.cells, i, faces[k]);
      const auto side = std::find(sides.begin(), sides.begin() + n_edges, key_of(nodes).nodes);
      std::optional<CellIndex> found;
      if (side != sides.begin() + n_edges) {
        found = cell_beyond({run.column, static_cast<int>(side - sides.begin())}, level);
      } else if (i > run.begin && has_all(run.cells, i - 1, nodes)) {
        found = run.cells.first + i - 1;
      } else if (i + 1 < run.end && has_all(run.cells, i + 1, nodes)) {
        found = run.cells.first + i + 1;
      }
      out[i][k] = found ? Neighbour::cell(*found) : beyond(nodes);
    }
  }
}

void LayerNeighbours::read(const CellBatch& cells, const Beyond& beyond, NeighbourBatch& out) const {
  out.resize(cells.size());
  std::size_t column = column_of(*layers_, cells.first);
  for (std::size_t begin = 0; begin < cells.size(); ++column) {
    const FrontFaceId f(column);
    const std::size_t end = static_cast<std::size_t>(layers_->column_end(f) - cells.first);
    const Run run{cells, f, begin, end};
    if (begin < end) {
      if (has_wedges_only(layers_->front(), layers_->lines(), f)) {
        read_wedges(run, beyond, out);
      } else {
        read_mixed(run, beyond, out);
      }
    }
    begin = end;
  }
}

}  // namespace nearwall::mesh
