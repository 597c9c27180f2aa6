#include "nearwall/pipeline/forecast.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace nearwall {
namespace {

std::vector<PatchSettings> one_patch(PatchType type, int count) {
  PatchSettings p;
  p.type = type;
  p.schedule.count = count;
  return {p};
}

TEST(Forecast, CountsThePrismsAndTheirPoints) {
  const mesh::SurfaceMesh cube = shapes_for_tests::cube();
  const IdVector<FaceId, char> all(cube.faces.size(), 1);
  const Forecast f = forecast(cube, one_patch(PatchType::Wall, 20), all);
  EXPECT_EQ(f.n_cells, 20 * cube.faces.size());
  EXPECT_EQ(f.n_points, 21 * cube.points.size());
  EXPECT_EQ(f.largest_count, 20);
  EXPECT_THAT(describe(f), testing::HasSubstr("20 layers"));
}

TEST(Forecast, AddsTheFilesOfAllFormats) {
  const mesh::SurfaceMesh cube = shapes_for_tests::cube();
  const IdVector<FaceId, char> all(cube.faces.size(), 1);
  const Forecast bare = forecast(cube, one_patch(PatchType::Wall, 20), all);
  for (std::size_t i = 0; i < io::kMeshFormatNames.size(); ++i) {
    const auto format = static_cast<io::MeshFormat>(i);
    Forecast one = bare, twice = bare;
    add_mesh_files(std::vector{format}, one);
    add_mesh_files(std::vector{format, format}, twice);
    EXPECT_GE(one.disk_bytes, bare.disk_bytes + 24 * bare.n_points + 10 * bare.n_cells) << io::name_of(format);
    EXPECT_NEAR(static_cast<double>(twice.disk_bytes - one.disk_bytes),
                static_cast<double>(one.disk_bytes - bare.disk_bytes), 1);
  }
}

TEST(Forecast, LeavesOutWhatGetsNoLayers) {
  const mesh::SurfaceMesh cube = shapes_for_tests::cube();
  const IdVector<FaceId, char> all(cube.faces.size(), 1), none(cube.faces.size(), 0);
  EXPECT_EQ(forecast(cube, one_patch(PatchType::NoLayer, 20), all).n_cells, 0u);
  EXPECT_EQ(forecast(cube, one_patch(PatchType::Wall, 20), none).n_cells, 0u);
}

}  // namespace
}  // namespace nearwall
