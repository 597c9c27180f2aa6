#include <algorithm>

#include "nearwall/mesh/mesh_source.h"

namespace nearwall::mesh {

namespace {

constexpr std::size_t kVerticesInBatch = 32768;
constexpr std::size_t kLinesInBatch = 1024;
constexpr std::size_t kColumnsInBatch = 1024;
constexpr std::size_t kCapsInBatch = 32768;

std::size_t n_blocks(std::size_t n, std::size_t block) { return (n + block - 1) / block; }

}  // namespace

void CellBatch::clear() {
  first = 0;
  type.clear();
  nodes.clear();
  corners.clear();
  layer.clear();
  column.clear();
  patch.clear();
}

void PointBatch::clear() {
  first = 0;
  position.clear();
  line.clear();
  level.clear();
}

LayerSource::LayerSource(const LayerMesh& layers, const IdVector<FaceId, PatchId>& face_patch,
                         std::span<const Vec3> wall_points)
    : layers_(&layers),
      face_patch_(&face_patch),
      wall_points_(wall_points),
      n_vertex_batches_(n_blocks(wall_points.size(), kVerticesInBatch)) {}

std::size_t LayerSource::n_line_batches() const { return n_blocks(layers_->lines().size(), kLinesInBatch); }
std::size_t LayerSource::n_column_batches() const { return n_blocks(layers_->n_columns(), kColumnsInBatch); }
std::size_t LayerSource::n_cap_batches() const { return n_blocks(layers_->caps().size(), kCapsInBatch); }

std::size_t LayerSource::n_point_batches() const { return n_vertex_batches_ + n_line_batches() + n_cap_batches(); }
std::size_t LayerSource::n_cell_batches() const { return n_column_batches() + n_cap_batches(); }

void LayerSource::read_points(std::size_t batch, PointBatch& out) const {
  out.clear();
  if (batch < n_vertex_batches_) return read_wall(batch, out);
  batch -= n_vertex_batches_;
  if (batch < n_line_batches()) return read_lines(batch, out);
  read_apices(batch - n_line_batches(), out);
}

void LayerSource::read_cells(std::size_t batch, CellBatch& out) const {
  out.clear();
  if (batch < n_column_batches()) return read_columns(batch, out);
  read_caps(batch - n_column_batches(), out);
}

void LayerSource::read_wall(std::size_t batch, PointBatch& out) const {
  const Front& front = layers_->front();
  const std::size_t begin = batch * kVerticesInBatch;
  const std::size_t end = std::min(wall_points_.size(), begin + kVerticesInBatch);
  out.first = begin;
  for (std::size_t v = begin; v < end; ++v) {
    const bool has_line = front.first_line[v] < front.first_line[v + 1];
    out.position.push_back(wall_points_[v]);
    out.line.push_back(has_line ? std::int64_t{front.first_line[v]} : -1);
    out.level.push_back(0);
  }
}

void LayerSource::read_lines(std::size_t batch, PointBatch& out) const {
  const Lines& lines = layers_->lines();
  const std::size_t begin = batch * kLinesInBatch;
  const std::size_t end = std::min(lines.size(), begin + kLinesInBatch);
  for (std::size_t i = begin; i < end; ++i) {
    const LineId line(i);
    const Window w = lines.windows[line];
    if (!w.moves()) continue;
    if (out.position.empty()) out.first = layers_->node(line, static_cast<Level>(w.start + 1));
    for (int level = w.start + 1; level <= w.end; ++level) {
      out.position.push_back(lines.position(line, static_cast<Level>(level)));
      out.line.push_back(static_cast<std::int64_t>(i));
      out.level.push_back(level);
    }
  }
}

void LayerSource::read_apices(std::size_t batch, PointBatch& out) const {
  const auto& caps = layers_->caps();
  const std::size_t begin = batch * kCapsInBatch;
  const std::size_t end = std::min(caps.size(), begin + kCapsInBatch);
  out.first = layers_->n_nodes() - caps.size() + begin;
  for (std::size_t i = begin; i < end; ++i) {
    out.position.push_back(cap_over(layers_->front(), layers_->lines(), caps[i])->corners[4]);
    out.line.push_back(-1);
    out.level.push_back(0);
  }
}

void LayerSource::read_columns(std::size_t batch, CellBatch& out) const {
  const std::size_t begin = batch * kColumnsInBatch;
  const std::size_t end = std::min(layers_->n_columns(), begin + kColumnsInBatch);
  out.first = layers_->column_offset(FrontFaceId(begin));
  for (std::size_t i = begin; i < end; ++i) {
    const FrontFaceId f(i);
    const bool is_wall = layers_->front().is_wall(f);
    layers_->for_each_cell(f, [&](const LayerCell& cell, Level level) {
      std::array<NodeIndex, 8> nodes{};
      for (std::size_t k = 0; k < static_cast<std::size_t>(size_of(cell.type)); ++k)
        nodes[k] = layers_->node(cell.nodes[k]);
      out.type.push_back(cell.type);
      out.nodes.push_back(nodes);
      out.corners.push_back(corners_of(layers_->lines(), cell));
      out.layer.push_back(level + 1);
      out.column.push_back(is_wall ? static_cast<std::int64_t>(i) : -1);
      out.patch.push_back(is_wall ? static_cast<std::int32_t>((*face_patch_)[FaceId(i)].index()) : -1);
    });
  }
}

void LayerSource::read_caps(std::size_t batch, CellBatch& out) const {
  const auto& caps = layers_->caps();
  const std::size_t begin = batch * kCapsInBatch;
  const std::size_t end = std::min(caps.size(), begin + kCapsInBatch);
  out.first = layers_->n_cells() - caps.size() + begin;
  for (std::size_t i = begin; i < end; ++i) {
    const Cap cap = *cap_over(layers_->front(), layers_->lines(), caps[i]);
    std::array<NodeIndex, 8> nodes{};
    std::array<Vec3, 8> corners{};
    for (std::size_t k = 0; k < 4; ++k) nodes[k] = layers_->node(cap.base[k]);
    nodes[4] = layers_->n_nodes() - caps.size() + i;
    std::copy(cap.corners.begin(), cap.corners.end(), corners.begin());
    out.type.push_back(CellType::Pyramid);
    out.nodes.push_back(nodes);
    out.corners.push_back(corners);
    out.layer.push_back(0);
    out.column.push_back(-1);
    out.patch.push_back(-1);
  }
}

}  // namespace nearwall::mesh
