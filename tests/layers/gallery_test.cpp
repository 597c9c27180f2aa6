#include <cmath>

#include <gtest/gtest.h>

#include "nearwall/core/parallel.h"
#include "nearwall/mesh/mesh_source.h"
#include "nearwall/predicates/cells.h"
#include "tests/support/gallery.h"

// Properties of the layers over all shapes × all schedules.

namespace nearwall {
namespace {

using growing_for_tests::options_for;
using growing_for_tests::TestWall;
using mesh::LimitReason;

using Parameter = std::tuple<std::size_t, std::size_t>;  // shape, schedule

class Gallery : public testing::TestWithParam<Parameter> {
 protected:
  const gallery::Shape& shape() const { return gallery::shapes()[std::get<0>(GetParam())]; }
  std::vector<double> heights(const mesh::SurfaceMesh& surface) const {
    return gallery::schedules()[std::get<1>(GetParam())].heights(gallery::diagonal(surface));
  }
};

predicates::Positivity positivity(mesh::CellType type, const std::array<Vec3, 8>& p) {
  const std::span<const Vec3, 8> all(p);
  switch (type) {
    case mesh::CellType::Tetrahedron:
      return predicates::tetrahedron(all.first<4>());
    case mesh::CellType::Pyramid:
      return predicates::pyramid(all.first<5>());
    case mesh::CellType::Wedge:
      return predicates::wedge(all.first<6>());
    case mesh::CellType::Hexahedron:
      return predicates::hexahedron(all);
  }
  return predicates::Positivity::Undecided;
}

TEST_P(Gallery, LayersAreCertifiedAndWhatIsMissingHasAReason) {
  const TestWall wall(gallery::into_the_fluid(shape()), shape().fluid_is_inside);
  const mesh::SurfaceMesh& surface = wall.surface();
  const std::vector<double> asked = heights(surface);
  const layers::Growth growth = layers::grow(wall.wall(), options_for(surface, asked));
  const mesh::LayerMesh layers(growth.front, growth.lines);

  const certify::Certificate certificate = certify::certify_layers(layers, wall.certified_wall());
  EXPECT_EQ(certificate.n_bad_columns, 0u);
  EXPECT_EQ(certificate.n_front_intersections, 0u);
  EXPECT_EQ(certificate.n_covered_twice, 0u);
  EXPECT_LE(certificate.closure(), 1e-12);
  EXPECT_GT(certificate.cells_volume, 0);

  // Cell by cell, from what is written rather than from the columns.
  const mesh::LayerSource source(layers, surface.face_patch, surface.points.raw());
  mesh::CellBatch cells;
  for (std::size_t b = 0; b < source.n_cell_batches(); ++b) {
    source.read_cells(b, cells);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      ASSERT_EQ(positivity(cells.type[k], cells.corners[k]), predicates::Positivity::Positive);
    }
  }

  // The wall is the input, triangle for triangle.
  mesh::PointBatch points;
  source.read_points(0, points);
  ASSERT_GE(points.size(), surface.points.size());
  for (const VertexId v : surface.points.ids()) ASSERT_EQ(points.position[v.index()], surface.points[v]);

  for (const LineId line : growth.front.line_vertex.ids()) {
    const double reached = growth.reached_thickness[line];
    if (growth.reason[line] == LimitReason::None) {
      // As scheduled: every height, to rounding, along a direction that sees the wall.
      EXPECT_EQ(reached, growth.asked_thickness[line]);
      ASSERT_EQ(growth.lines.windows[line].end, asked.size());
      ASSERT_TRUE(growth.lines.windows[line].moves());
      double sum = 0;
      for (std::size_t j = 0; j < asked.size(); ++j) {
        sum += asked[j];
        if (j + 1 <= growth.lines.windows[line].start) continue;  // the line at a fan's end starts late
        EXPECT_NEAR(growth.lines.height(line, static_cast<Level>(j + 1)), sum, 1e-12 * sum);
      }
    } else {
      EXPECT_LT(reached, growth.asked_thickness[line]);
      EXPECT_EQ(reached > 0, growth.lines.windows[line].moves());
    }
  }
}

std::string parameter_name(const testing::TestParamInfo<Parameter>& info) {
  return gallery::shapes()[std::get<0>(info.param)].name + "__" + gallery::schedules()[std::get<1>(info.param)].name;
}

INSTANTIATE_TEST_SUITE_P(ShapesAndSchedules, Gallery,
                         testing::Combine(testing::Range(std::size_t{0}, gallery::shapes().size()),
                                          testing::Range(std::size_t{0}, gallery::schedules().size())),
                         parameter_name);

}  // namespace
}  // namespace nearwall
