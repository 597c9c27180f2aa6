#include "nearwall/quality/wall_layers.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "nearwall/core/parallel.h"
#include "nearwall/geometry/measures.h"

namespace nearwall::quality {

namespace {

using mesh::CellType;
using mesh::FaceName;

constexpr double kPercent = 100;
constexpr std::uint8_t kNone = 0xff;

/// Blocks of work on one patch, and so of histograms in memory: a fixed number, so that results do not depend on the
/// threads.
constexpr std::size_t kNBlocks = 32;

/// As for the layers of a run: docs/theory/quality.md.
Binning growth_bins() { return Binning::doublings(-2, 2, 4096); }

/// How a column goes through a cell: in by one face, out by another; for each node of the first one the node of the
/// second one that lies over it.
struct Passage {
  std::size_t exit = 0;
  std::array<std::uint8_t, 8> over{};
  bool is_layer = false;  ///< all nodes move
};

/// \param pairs  nodes over each other
Passage passage(std::size_t exit, bool is_layer, std::initializer_list<std::array<std::uint8_t, 2>> pairs) {
  Passage p{exit, {}, is_layer};
  p.over.fill(kNone);
  for (const auto& [from, to] : pairs) p.over[from] = to;
  return p;
}

/// By the faces of mesh::cell_faces.
std::optional<Passage> passage_through(CellType type, std::size_t entry) {
  static const std::array<Passage, 2> kWedge{passage(1, true, {{0, 3}, {1, 4}, {2, 5}}),
                                             passage(0, true, {{3, 0}, {4, 1}, {5, 2}})};
  static const std::array<Passage, 6> kHexahedron{
      passage(1, true, {{0, 4}, {1, 5}, {2, 6}, {3, 7}}), passage(0, true, {{4, 0}, {5, 1}, {6, 2}, {7, 3}}),
      passage(4, true, {{0, 3}, {1, 2}, {5, 6}, {4, 7}}), passage(5, true, {{1, 0}, {2, 3}, {6, 7}, {5, 4}}),
      passage(2, true, {{3, 0}, {2, 1}, {6, 5}, {7, 4}}), passage(3, true, {{0, 1}, {3, 2}, {7, 6}, {4, 5}})};
  static const std::array<Passage, 4> kPyramid{
      passage(3, false, {{0, 3}, {1, 2}, {4, 4}}), passage(4, false, {{1, 0}, {2, 3}, {4, 4}}),
      passage(1, false, {{2, 1}, {3, 0}, {4, 4}}), passage(2, false, {{3, 2}, {0, 1}, {4, 4}})};
  if (type == CellType::Wedge && entry < kWedge.size()) return kWedge[entry];
  if (type == CellType::Hexahedron) return kHexahedron[entry];
  if (type == CellType::Pyramid && entry > 0) return kPyramid[entry - 1];
  return std::nullopt;
}

/// The nodes over one corner of a wall triangle, as far as the column goes.
struct Corner {
  std::uint32_t node = 0;
  Vec3 base, last;
  std::optional<Vec3> first;  ///< the first that is not the corner itself
  double step = 0;            ///< length of the last one
};

struct Column {
  std::uint32_t layers = 0;
  double first_height = 0;
  double thickness = 0;
};

/// Goes one node up; the ratio of the steps is counted where there were two.
void climb(Corner& corner, std::uint32_t node, const Vec3& place, Histogram& growth) {
  if (node == corner.node) return;
  const double step = distance(place, corner.last);
  if (corner.step > 0) growth.add(step / corner.step);
  corner.node = node;
  corner.last = place;
  corner.step = step;
  if (!corner.first) corner.first = place;
}

/// No column is higher.
constexpr std::uint32_t kMostLayers = 65535;

/// The three corners of a triangle as nodes of the face that it was found to be.
std::array<Corner, 3> corners_on(const mesh::VolumeMesh& mesh, FaceName face, const std::array<Vec3, 3>& triangle) {
  const mesh::FaceNodes nodes = nodes_of(mesh, face);
  std::array<Corner, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto nearer = [&](std::uint32_t a, std::uint32_t b) {
      return distance(mesh.points[a], triangle[k]) < distance(mesh.points[b], triangle[k]);
    };
    corners[k].node = *std::min_element(nodes.begin(), nodes.begin() + mesh::size_of(nodes), nearer);
    corners[k].base = corners[k].last = mesh.points[corners[k].node];
  }
  return corners;
}

/// Through a tetrahedron, where two lines start late: out by the face on which a wedge stands, if there is just one.
std::optional<Passage> passage_to_wedge(const mesh::VolumeMesh& mesh, const mesh::FaceIndex& index, FaceName entry) {
  std::optional<Passage> way;
  for (std::size_t exit = 0; exit < mesh::cell_faces(CellType::Tetrahedron).size(); ++exit) {
    const FaceName out(entry.cell(), exit), next = index.opposite(mesh, out);
    if (exit == entry.face() || next == out || mesh.type[next.cell()] != CellType::Wedge || next.face() > 1) continue;
    if (way) return std::nullopt;
    // Three nodes of the entry, three of the exit: two stay, and the fourth lies over the third.
    way = passage(exit, false, {{0, 0}, {1, 1}, {2, 2}, {3, 3}});
    const auto corners_of = [](std::size_t f) { return mesh::cell_faces(CellType::Tetrahedron)[f].corners; };
    const auto missing = [&](std::size_t f) {
      const auto c = corners_of(f);
      return static_cast<std::uint8_t>(6 - c[0] - c[1] - c[2]);
    };
    way->over[missing(exit)] = missing(entry.face());
  }
  return way;
}

/// Through one cell. \returns  whether there was a way
bool pass(const mesh::VolumeMesh& mesh, const mesh::FaceIndex& index, FaceName& face, std::array<Corner, 3>& corners,
          bool& is_layer, Histogram& growth) {
  const CellType type = mesh.type[face.cell()];
  const auto way =
      type == CellType::Tetrahedron ? passage_to_wedge(mesh, index, face) : passage_through(type, face.face());
  if (!way) return false;
  const auto nodes = mesh.nodes_of(face.cell());
  for (Corner& corner : corners) {
    const auto at = static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), corner.node) - nodes.begin());
    const std::uint32_t over = nodes[way->over[at]];
    climb(corner, over, mesh.points[over], growth);
  }
  face = FaceName(face.cell(), way->exit);
  is_layer = way->is_layer;
  return true;
}

Column climb_column(const mesh::VolumeMesh& mesh, const mesh::FaceIndex& index, FaceName face,
                    const std::array<Vec3, 3>& triangle, Histogram& growth) {
  std::array<Corner, 3> corners = corners_on(mesh, face, triangle);
  Column column;
  bool is_layer = false;
  for (std::uint32_t n = 1; pass(mesh, index, face, corners, is_layer, growth); ++n) {
    // A way that leads round in a ring, as through the fans of a ridge, is no column.
    if (n > kMostLayers) return {};
    if (is_layer) column.layers = n;
    const FaceName next = index.opposite(mesh, face);
    if (next == face) break;
    face = next;
  }
  const Vec3 normal = geometry::triangle_normal(corners[0].base, corners[1].base, corners[2].base);
  const auto mean_height = [&](auto&& node_of) {
    const auto height = [&](const Corner& c) { return dot(node_of(c) - c.base, normal); };
    return std::abs(sum3(height(corners[0]), height(corners[1]), height(corners[2]))) / 3;
  };
  if (column.layers == 0) return {};
  column.first_height = mean_height([](const Corner& c) { return c.first.value_or(c.base); });
  column.thickness = mean_height([](const Corner& c) { return c.last; });
  return column;
}

/// Layers that most of the area with layers has; of equal ones the most.
std::uint32_t most_common(const std::vector<Column>& columns, const std::vector<double>& areas) {
  std::map<std::uint32_t, double> area_with;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].layers > 0) area_with[columns[i].layers] += areas[i];
  }
  std::uint32_t best = 0;
  for (const auto& [layers, area] : area_with) {
    if (best == 0 || area >= area_with[best]) best = layers;
  }
  return best;
}

WallPatchLayers sum_up(const std::vector<Column>& columns, const std::vector<double>& areas,
                       const std::vector<char>& is_matched, std::optional<std::uint32_t> count) {
  WallPatchLayers patch;
  patch.count = count ? *count : most_common(columns, areas);
  geometry::CompensatedSum total, matched, all, any, layers;
  std::vector<double> first_heights, thicknesses;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    total.add(areas[i]);
    if (is_matched[i]) matched.add(areas[i]);
    if (columns[i].layers > 0) any.add(areas[i]);
    if (columns[i].layers > 0 && columns[i].layers >= patch.count) all.add(areas[i]);
    layers.add(areas[i] * columns[i].layers);
    first_heights.push_back(columns[i].first_height);
    thicknesses.push_back(columns[i].thickness);
  }
  patch.area = total.value();
  if (!(patch.area > 0)) return patch;
  const auto percent = [&](const geometry::CompensatedSum& sum) { return kPercent * (sum.value() / patch.area); };
  patch.matched_percent = percent(matched);
  patch.all_layers_percent = percent(all);
  patch.any_percent = percent(any);
  patch.mean_layers = layers.value() / patch.area;
  patch.first_height = weighted_statistics(first_heights, areas, true);
  patch.thickness = weighted_statistics(thicknesses, areas, true);
  return patch;
}

}  // namespace

IdVector<PatchId, WallPatchLayers> wall_layers(const mesh::VolumeMesh& mesh, const mesh::SurfaceMesh& wall,
                                               const IdVector<FaceId, std::optional<FaceName>>& start,
                                               std::optional<std::uint32_t> count) {
  const mesh::FaceIndex index(mesh);
  IdVector<PatchId, std::vector<FaceId>> members(wall.patch_names.size());
  for (const FaceId f : wall.faces.ids()) members[wall.face_patch[f]].push_back(f);
  IdVector<PatchId, WallPatchLayers> patches(members.size());
  for (const PatchId p : patches.ids()) {
    const std::size_t n = members[p].size();
    std::vector<Column> columns(n);
    std::vector<double> areas(n);
    std::vector<char> is_matched(n);
    std::vector<Histogram> growth(kNBlocks, Histogram(growth_bins()));
    const std::size_t block = std::max<std::size_t>(1, (n + kNBlocks - 1) / kNBlocks);
    parallel_blocks(n, block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const FaceId f = members[p][i];
        const auto triangle = wall.triangle(f);
        areas[i] = geometry::triangle_area(triangle[0], triangle[1], triangle[2]);
        is_matched[i] = start[f].has_value();
        if (start[f]) columns[i] = climb_column(mesh, index, *start[f], triangle, growth[begin / block]);
      }
    });
    patches[p] = sum_up(columns, areas, is_matched, count);
    for (std::size_t b = 1; b < kNBlocks; ++b) growth[0].merge(growth[b]);
    patches[p].growth = growth[0].statistics();
  }
  return patches;
}

}  // namespace nearwall::quality
