#include <gmpxx.h>

#include <gtest/gtest.h>

#include "nearwall/mesh/mesh_source.h"
#include "tests/support/gallery.h"

// On small shapes the volumes of all cells, summed in rationals, are exactly the volume between wall and front.

namespace nearwall {
namespace {

using growing_for_tests::options_for;
using growing_for_tests::TestWall;

struct Exact {
  mpq_class x, y, z;
  explicit Exact(const Vec3& p) : x(p.x()), y(p.y()), z(p.z()) {}
};

mpq_class det(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1, const Vec3& c0, const Vec3& c1) {
  const Exact p(a0), q(a1), r(b0), s(b1), t(c0), u(c1);
  const mpq_class ax = q.x - p.x, ay = q.y - p.y, az = q.z - p.z;
  const mpq_class bx = s.x - r.x, by = s.y - r.y, bz = s.z - r.z;
  const mpq_class cx = u.x - t.x, cy = u.y - t.y, cz = u.z - t.z;
  return ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx);
}

/// Six times the tetrahedron over a triangle about the origin.
mpq_class cone(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 o;
  return det(o, a, o, b, o, c);
}

/// Six times the flux volume of a bilinear face: the mean over both ways of cutting it.
mpq_class cone(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (cone(a, b, c) + cone(a, c, d) + cone(a, b, d) + cone(b, c, d)) / 2;
}

/// Six times the integral of det J, independent of predicates and measures: by Bernstein means where they are simple.
mpq_class sixfold_volume(mesh::CellType type, const std::array<Vec3, 8>& p) {
  switch (type) {
    case mesh::CellType::Tetrahedron:
      return det(p[0], p[1], p[0], p[2], p[0], p[3]);
    case mesh::CellType::Pyramid: {
      mpq_class sum = 0;
      for (std::size_t k = 0; k < 4; ++k) sum += det(p[k], p[(k + 1) % 4], p[k], p[(k + 3) % 4], p[k], p[4]);
      return sum / 2;
    }
    case mesh::CellType::Wedge: {
      mpq_class sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        sum += det(p[0], p[1], p[0], p[2], p[k], p[k + 3]);
        sum += det(p[3], p[4], p[3], p[5], p[k], p[k + 3]);
        sum += (det(p[0], p[1], p[3], p[5], p[k], p[k + 3]) + det(p[3], p[4], p[0], p[2], p[k], p[k + 3])) / 2;
      }
      return sum / 3;
    }
    case mesh::CellType::Hexahedron:
      return cone(p[0], p[3], p[2], p[1]) + cone(p[4], p[5], p[6], p[7]) + cone(p[0], p[1], p[5], p[4]) +
             cone(p[1], p[2], p[6], p[5]) + cone(p[2], p[3], p[7], p[6]) + cone(p[3], p[0], p[4], p[7]);
  }
  return 0;
}

/// Larger shapes take seconds.
constexpr std::size_t kMostFaces = 1200;

class ExactVolume : public testing::TestWithParam<std::size_t> {};

TEST_P(ExactVolume, OfAllCellsIsThatBetweenWallAndFront) {
  const gallery::Shape& shape = gallery::shapes()[GetParam()];
  const TestWall wall(gallery::into_the_fluid(shape), shape.fluid_is_inside);
  const mesh::SurfaceMesh& surface = wall.surface();
  if (surface.faces.size() > kMostFaces) GTEST_SKIP() << "too large for rationals";
  auto options = options_for(surface, growing_for_tests::geometric(0.02 * gallery::diagonal(surface), 1.2, 4));
  // A patch without layers brings pyramids and tetrahedra in, where there are several patches.
  if (surface.patch_names.size() > 1) options.schedules[PatchId(1)].has_layers = false;
  const layers::Growth growth = layers::grow(wall.wall(), options);
  const mesh::LayerMesh layers(growth.front, growth.lines);

  mpq_class cells = 0;
  const mesh::LayerSource source(layers, surface.face_patch, surface.points.raw());
  mesh::CellBatch batch;
  for (std::size_t b = 0; b < source.n_cell_batches(); ++b) {
    source.read_cells(b, batch);
    for (std::size_t k = 0; k < batch.size(); ++k) {
      const mpq_class volume = sixfold_volume(batch.type[k], batch.corners[k]);
      ASSERT_GT(volume, 0);
      cells += volume;
    }
  }
  mpq_class between = 0;
  const certify::FrontSurface front = certify::front_surface(growth.front, growth.lines);
  for (const auto& [a, b, c] : front.triangles) between += cone(front.points[a], front.points[b], front.points[c]);
  for (const FaceId f : surface.faces.ids()) {
    const auto t = surface.triangle(f);
    between -= cone(t[0], t[1], t[2]);
  }
  EXPECT_GT(cells, 0);
  EXPECT_EQ(cells, between);
}

INSTANTIATE_TEST_SUITE_P(Shapes, ExactVolume, testing::Range(std::size_t{0}, gallery::shapes().size()),
                         [](const auto& shape) { return gallery::shapes()[shape.param].name; });

}  // namespace
}  // namespace nearwall
