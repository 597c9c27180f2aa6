#include <algorithm>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "nearwall/geometry/box.h"
#include "nearwall/mesh/mesh_source.h"
#include "tests/support/cell_map.h"
#include "tests/support/gallery.h"

// The certificate's claims, looked at without it: every point is covered by one cell at most, faces are shared by two
// cells or lie on wall or front, volumes add up.

namespace nearwall {
namespace {

using cells_for_tests::CellMap;
using cells_for_tests::Reference;
using growing_for_tests::options_for;
using growing_for_tests::TestWall;
using mesh::CellType;

/// Points nearer to a face than this, in the reference element, belong to neither side for sure.
constexpr double kOnFace = 1e-6;

struct Cell {
  CellType type;
  std::array<NodeIndex, 8> nodes;
  std::array<Vec3, 8> corners;

  CellMap map() const { return {type, corners}; }
  std::size_t size() const { return static_cast<std::size_t>(mesh::size_of(type)); }
};

std::vector<Cell> cells_of(const mesh::MeshSource& source) {
  std::vector<Cell> cells;
  mesh::CellBatch batch;
  for (std::size_t b = 0; b < source.n_cell_batches(); ++b) {
    source.read_cells(b, batch);
    for (std::size_t k = 0; k < batch.size(); ++k) cells.push_back({batch.type[k], batch.nodes[k], batch.corners[k]});
  }
  return cells;
}

/// Finds the cells round a point by a grid of boxes.
class CellFinder {
 public:
  explicit CellFinder(const std::vector<Cell>& cells) : cells_(cells), bins_(kBins * kBins * kBins) {
    for (const Cell& cell : cells) {
      for (std::size_t k = 0; k < cell.size(); ++k) box_.include(cell.corners[k]);
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
      geometry::Box around;
      for (std::size_t k = 0; k < cells[c].size(); ++k) around.include(cells[c].corners[k]);
      const auto low = bin_of(around.low), high = bin_of(around.high);
      for (std::size_t i = low[0]; i <= high[0]; ++i) {
        for (std::size_t j = low[1]; j <= high[1]; ++j) {
          for (std::size_t k = low[2]; k <= high[2]; ++k) bins_[(i * kBins + j) * kBins + k].push_back(c);
        }
      }
    }
  }

  const geometry::Box& box() const { return box_; }

  /// The cells in which p lies by more than kOnFace.
  std::vector<std::size_t> covering(const Vec3& p) const {
    std::vector<std::size_t> found;
    const auto [i, j, k] = bin_of(p);
    for (const std::size_t c : bins_[(i * kBins + j) * kBins + k]) {
      const auto q = cells_[c].map().inverse(p);
      if (q && cells_[c].map().depth(*q) > kOnFace) found.push_back(c);
    }
    return found;
  }

 private:
  static constexpr std::size_t kBins = 32;

  std::array<std::size_t, 3> bin_of(const Vec3& p) const {
    std::array<std::size_t, 3> bin{};
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = box_.high[axis] - box_.low[axis];
      const double at = (p[axis] - box_.low[axis]) / extent * static_cast<double>(kBins);
      bin[static_cast<std::size_t>(axis)] = std::min(static_cast<std::size_t>(std::max(at, 0.0)), kBins - 1);
    }
    return bin;
  }

  const std::vector<Cell>& cells_;
  geometry::Box box_;
  std::vector<std::vector<std::size_t>> bins_;
};

/// A point well inside the reference element.
Reference inner_point(CellType type, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.02, 0.98);
  for (;;) {
    const Reference q{unit(random), unit(random), unit(random)};
    if (CellMap(type, {}).depth(q) > 0.01) return q;
  }
}

/// Corners of the faces of a cell, triangles with the last one repeated.
std::vector<std::array<std::size_t, 4>> faces_of(CellType type) {
  switch (type) {
    case CellType::Tetrahedron:
      return {{0, 2, 1, 1}, {0, 1, 3, 3}, {1, 2, 3, 3}, {2, 0, 3, 3}};
    case CellType::Pyramid:
      return {{0, 3, 2, 1}, {0, 1, 4, 4}, {1, 2, 4, 4}, {2, 3, 4, 4}, {3, 0, 4, 4}};
    case CellType::Wedge:
      return {{0, 2, 1, 1}, {3, 4, 5, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
    case CellType::Hexahedron:
      return {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  }
  return {};
}

/// A face by its nodes in order, the first repeated for a triangle.
using FaceKey = std::array<NodeIndex, 4>;

FaceKey key_of(FaceKey nodes) {
  std::sort(nodes.begin(), nodes.end());
  const auto last = std::unique(nodes.begin(), nodes.end());
  if (last != nodes.end()) std::rotate(nodes.begin(), nodes.end() - 1, nodes.end());
  nodes[0] = last != nodes.end() ? nodes[1] : nodes[0];
  return nodes;
}

class Covers : public testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {
 protected:
  const gallery::Shape& shape() const { return gallery::shapes()[std::get<0>(GetParam())]; }
  const gallery::Schedule& schedule() const { return gallery::schedules()[std::get<1>(GetParam())]; }
  TestWall wall{gallery::into_the_fluid(shape()), shape().fluid_is_inside};
  const mesh::SurfaceMesh& surface = wall.surface();
  layers::Growth growth =
      layers::grow(wall.wall(), options_for(surface, schedule().heights(gallery::diagonal(surface))));
  mesh::LayerMesh layers{growth.front, growth.lines};
  std::vector<Cell> cells = cells_of(mesh::LayerSource(layers, surface.face_patch, surface.points.raw()));

  void expect_one_cover_at_most() const;
  void expect_shared_faces() const;
  void expect_volumes_that_add_up() const;
};

void Covers::expect_one_cover_at_most() const {
  constexpr int kSamples = 300;
  const CellFinder finder(cells);
  std::mt19937 random(7);
  std::uniform_int_distribution<std::size_t> any_cell(0, cells.size() - 1);
  for (int i = 0; i < kSamples; ++i) {
    const std::size_t c = any_cell(random);
    const Vec3 p = cells[c].map().at(inner_point(cells[c].type, random));
    // In a cell that is a hair thin, coordinates are too coarse to tell where in it a point lies.
    if (!cells[c].map().inverse(p)) continue;
    ASSERT_EQ(finder.covering(p), std::vector<std::size_t>{c}) << i;
  }
  const geometry::Box& box = finder.box();
  for (int i = 0; i < kSamples; ++i) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = std::uniform_real_distribution<double>(box.low[axis], box.high[axis])(random);
    }
    ASSERT_LE(finder.covering(p).size(), 1u);
  }
}

void Covers::expect_shared_faces() const {
  std::map<FaceKey, int> owners;
  for (const Cell& cell : cells) {
    for (const auto& face : faces_of(cell.type)) {
      ++owners[key_of({cell.nodes[face[0]], cell.nodes[face[1]], cell.nodes[face[2]], cell.nodes[face[3]]})];
    }
  }
  std::size_t n_outer = 0;
  for (const auto& [face, n] : owners) {
    ASSERT_LE(n, 2);
    if (n == 2) continue;
    ASSERT_EQ(face[0], face[1]) << "a quadrangle belongs to one cell only";
    ++n_outer;
  }
  // Each column with cells stands on its wall triangle; the others leave theirs bare.
  std::size_t n_wall = 0;
  for (const FaceId f : surface.faces.ids()) {
    const auto& [a, b, c] = surface.faces[f];
    const auto found = owners.find(key_of({a.index(), b.index(), c.index(), c.index()}));
    if (layers.column_offset(FrontFaceId(f.index())) == layers.column_end(FrontFaceId(f.index()))) continue;
    ASSERT_NE(found, owners.end());
    EXPECT_EQ(found->second, 1);
    ++n_wall;
  }
  EXPECT_GE(n_outer, 2 * n_wall) << "wall and front";
}

void Covers::expect_volumes_that_add_up() const {
  const Vec3 centre = geometry::bounding_box(surface.points.raw()).centre();
  double cells_volume = 0, scale = 0;
  for (const Cell& cell : cells) {
    const double volume = cell.map().volume();
    ASSERT_GT(volume, 0);
    cells_volume += volume;
  }
  // From the front's triangles and the wall's: cones from the centre.
  double between = 0;
  const auto add_cone = [&](const Vec3& a, const Vec3& b, const Vec3& c, double sign) {
    const double cone = dot(a - centre, cross(b - centre, c - centre)) / 6;
    between += sign * cone;
    scale += std::abs(cone);
  };
  const certify::FrontSurface front = certify::front_surface(growth.front, growth.lines);
  for (const auto& [a, b, c] : front.triangles) add_cone(front.points[a], front.points[b], front.points[c], 1);
  for (const FaceId f : surface.faces.ids()) {
    const auto [a, b, c] = surface.triangle(f);
    add_cone(a, b, c, -1);
  }
  EXPECT_NEAR(cells_volume, between, 1e-12 * scale);
  EXPECT_NEAR(certify::certify_layers(layers, wall.certified_wall()).cells_volume, cells_volume, 1e-12 * scale);
}

TEST_P(Covers, AreOneAtMostAndCellsConform) {
  ASSERT_FALSE(cells.empty());
  expect_one_cover_at_most();
  expect_shared_faces();
  expect_volumes_that_add_up();
}

INSTANTIATE_TEST_SUITE_P(ShapesAndSchedules, Covers,
                         testing::Combine(testing::Range(std::size_t{0}, gallery::shapes().size()),
                                          testing::Range(std::size_t{0}, gallery::schedules().size())),
                         [](const auto& parameter) {
                           return gallery::shapes()[std::get<0>(parameter.param)].name + "__" +
                                  gallery::schedules()[std::get<1>(parameter.param)].name;
                         });

}  // namespace
}  // namespace nearwall
