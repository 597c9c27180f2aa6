#include "io/volume_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "io/vtk_cells.h"
#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

constexpr std::size_t kMostPoints = std::numeric_limits<std::uint32_t>::max();

/// What a cell of a type that is refused is called, and what helps.
std::string_view name_of_refused(unsigned code) {
  if (code == 15 || code == 16) return "a prism over a pentagon or hexagon: cut it into wedges";
  if (code == 41 || code == 42) return "a polyhedron: cut it into tetrahedra";
  if ((code >= 21 && code <= 37) || (code >= 60 && code <= 81))
    return "of higher order: save the mesh with linear cells";
  return "unknown: take it out of the mesh";
}

/// Room for `more` entries; for those of many small pieces it grows by half at least, so that each moves a few times.
template <class T>
void make_room(std::vector<T>& values, std::size_t more) {
  const std::size_t needed = values.size() + more;
  if (needed > values.capacity()) values.reserve(std::max(needed, values.capacity() + values.capacity() / 2));
}

}  // namespace

void VolumeBuilder::fail(const std::string& what) const { throw GeometryError(fmt::format("{}: {}", file_, what)); }

void VolumeBuilder::refuse(std::size_t cell, unsigned code) const {
  throw InputError(
      fmt::format("{}: cell {} has VTK's type {}, expected linear tetrahedra (10), pyramids (14), wedges "
                  "(13) and hexahedra (12); this one is {}",
                  file_, cells_before_ + cell, code, name_of_refused(code)));
}

void VolumeBuilder::expect_points(std::size_t more) { make_room(volume_.mesh.points, more); }

void VolumeBuilder::expect_cells(std::size_t more) {
  make_room(codes_, more);
  make_room(volume_.mesh.type, more);
  make_room(volume_.mesh.first_node, more);
  make_room(volume_.mesh.file_cell, more);
}

void VolumeBuilder::expect_nodes(std::size_t more) { make_room(volume_.mesh.nodes, more); }

void VolumeBuilder::add_coordinates(std::span<const double> run) {
  std::vector<Vec3>& points = volume_.mesh.points;
  for (const double value : run) {
    const auto axis = static_cast<int>(n_coordinates_++ % 3);
    if (axis == 0) {
      if (points.size() >= kMostPoints) fail(fmt::format("more than {} points", kMostPoints));
      points.emplace_back();
    }
    if (!std::isfinite(value)) {
      fail(fmt::format("point {}: expected finite coordinates, found a NaN or an infinity", points.size() - 1));
    }
    points.back()[axis] = value;
  }
}

void VolumeBuilder::add_types(std::span<const std::int64_t> run) {
  for (const std::int64_t type : run) {
    if (type < 0 || static_cast<std::uint64_t>(type) >= kNVtkCodes) {
      fail(fmt::format("cell {} has the type {}: the types are damaged", cells_before_ + codes_.size(), type));
    }
    const auto code = static_cast<std::uint8_t>(type);
    if (kVtkMeanings[code].use == VtkCellMeaning::Use::Refused) refuse(codes_.size(), code);
    codes_.push_back(code);
  }
}

void VolumeBuilder::add_ends(std::span<const std::int64_t> run) {
  std::vector<std::uint64_t>& ends = volume_.mesh.first_node;
  for (const std::int64_t end : run) {
    const std::uint64_t last = ends.back() - first_node_;
    if (end < 0 || static_cast<std::uint64_t>(end) < last) {
      fail(fmt::format("cell {}: its nodes end at entry {}, those of the cell before at {}: the offsets are damaged",
                       cells_before_ + n_ends(), end, last));
    }
    ends.push_back(first_node_ + static_cast<std::uint64_t>(end));
  }
}

/// The cell of the piece to which the entry of that number belongs.
std::size_t VolumeBuilder::cell_of_node(std::size_t node) const {
  const auto begin = volume_.mesh.first_node.begin() + static_cast<std::ptrdiff_t>(first_cell_) + 1;
  const auto found = std::upper_bound(begin, volume_.mesh.first_node.end(), first_node_ + node);
  return static_cast<std::size_t>(found - begin);
}

void VolumeBuilder::add_nodes(std::span<const std::int64_t> run) {
  const auto n = static_cast<std::uint64_t>(n_points());
  for (const std::int64_t node : run) {
    if (static_cast<std::uint64_t>(node) >= n) {  // negative ones become large
      fail(fmt::format("cell {} uses point {} (counted from 0), but there are {} points",
                       cells_before_ + cell_of_node(n_nodes()), node, n));
    }
    volume_.mesh.nodes.push_back(static_cast<std::uint32_t>(first_point_ + static_cast<std::uint64_t>(node)));
  }
}

void VolumeBuilder::add_layers(std::span<const std::int64_t> run) {
  // Other programs may mean something else by it: what is no layer counts as outside of them.
  constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
  for (const std::int64_t layer : run) {
    layers_.push_back(layer > 0 && layer <= kMost ? static_cast<std::int32_t>(layer) : 0);
  }
}

void VolumeBuilder::check_cells() const {
  if (n_coordinates_ % 3 != 0) fail("the points do not have 3 coordinates each");
  if (n_types() != n_ends()) {
    fail(
        fmt::format("there are {} types but {} offsets of cells; the file is cut off or damaged", n_types(), n_ends()));
  }
  if (!layers_.empty() && layers_.size() != n_types()) {
    fail(fmt::format("there are {} layers for {} cells; the file is cut off or damaged", layers_.size(), n_types()));
  }
  const std::vector<std::uint64_t>& first = volume_.mesh.first_node;
  if (first.back() != volume_.mesh.nodes.size()) {
    fail(fmt::format("the cells use {} nodes, but {} are listed; the file is cut off or damaged",
                     first.back() - first_node_, n_nodes()));
  }
  for (std::size_t c = 0; c < codes_.size(); ++c) {
    const std::uint64_t size = first[first_cell_ + c + 1] - first[first_cell_ + c];
    const std::uint8_t expected = kVtkMeanings[codes_[c]].size;
    if (expected != 0 && size != expected) {
      fail(fmt::format("cell {} of VTK's type {} has {} nodes, expected {}: the offsets or types are damaged",
                       cells_before_ + c, codes_[c], size, expected));
    }
  }
}

void VolumeBuilder::end_piece() {
  using Use = VtkCellMeaning::Use;
  check_cells();
  mesh::VolumeMesh& mesh = volume_.mesh;
  std::size_t kept = first_cell_;
  std::uint64_t from = first_node_, to = first_node_;
  for (std::size_t c = 0; c < codes_.size(); ++c) {
    const VtkCellMeaning& meaning = kVtkMeanings[codes_[c]];
    const std::uint64_t end = mesh.first_node[first_cell_ + c + 1];
    if (meaning.use == Use::Cell) {
      std::array<std::uint32_t, 8> nodes{};
      for (std::size_t k = 0; k < meaning.size; ++k) nodes[meaning.node[k]] = mesh.nodes[from + k];
      std::copy_n(nodes.begin(), meaning.size, mesh.nodes.begin() + static_cast<std::ptrdiff_t>(to));
      to += meaning.size;
      mesh.type.push_back(meaning.type);
      mesh.file_cell.push_back(cells_before_ + c);
      if (!layers_.empty()) mesh.layer.push_back(layers_[c]);
      mesh.first_node[++kept] = to;  // never ahead of what is read: kept <= first_cell_ + c + 1
    } else {
      std::uint64_t& n = meaning.use == Use::SkippedFace   ? volume_.skipped.faces
                         : meaning.use == Use::SkippedLine ? volume_.skipped.lines
                                                           : volume_.skipped.points;
      ++n;
    }
    from = end;
  }
  mesh.first_node.resize(kept + 1);
  mesh.nodes.resize(to);
  cells_before_ += codes_.size();
  codes_.clear();
  layers_.clear();
  first_point_ = mesh.points.size();
  first_cell_ = kept;
  first_node_ = to;
  n_coordinates_ = 0;
}

VolumeFile VolumeBuilder::finish(std::vector<std::string> patch_names) {
  volume_.patch_names = std::move(patch_names);
  // Known for some of the pieces only: not known.
  if (volume_.mesh.layer.size() != volume_.mesh.n_cells()) volume_.mesh.layer.clear();
  return std::move(volume_);
}

}  // namespace nearwall::io
