#include "nearwall/io/surface_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "nearwall/core/errors.h"
#include "nearwall/io/surface_reader.h"
#include "tests/io/temporary_folder.h"

namespace nearwall::io {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// A tetrahedron of awkward coordinates; faces of three patches, not in their order.
mesh::SurfaceMesh sample() {
  mesh::SurfaceMesh mesh;
  mesh.points.raw() = {
      {0.1, 1.0 / 3, -1e-300}, {1e17, std::nextafter(1.0, 2.0), 5e-324}, {-0.0, 2, 3}, {7, 1e-5, M_PI}};
  const auto face = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t patch) {
    mesh.faces.push_back({VertexId(a), VertexId(b), VertexId(c)});
    mesh.face_patch.push_back(PatchId(patch));
  };
  face(0, 2, 1, 2);
  face(0, 1, 3, 0);
  face(1, 2, 3, 1);
  face(2, 0, 3, 2);
  mesh.patch_names.raw() = {"wing tip", "50%", "fuselage"};
  return mesh;
}

bool same_bits(const Vec3& a, const Vec3& b) {
  return a == b && std::signbit(a.x()) == std::signbit(b.x()) && std::signbit(a.y()) == std::signbit(b.y());
}

class WriteSurfaceShared : public testing::TestWithParam<std::string> {};

TEST_P(WriteSurfaceShared, KeepsPointsTrianglesAndPatches) {
  const TemporaryFolder folder;
  const auto path = folder / ("surface." + GetParam());
  const auto before = sample();
  write_surface(path, before);
  const auto after = read_surface(path);
  ASSERT_EQ(after.points.size(), before.points.size());
  for (const VertexId v : before.points.ids()) EXPECT_TRUE(same_bits(after.points[v], before.points[v])) << v.index();
  EXPECT_EQ(after.faces, before.faces);
  EXPECT_EQ(after.face_patch, before.face_patch);
  EXPECT_EQ(after.patch_names, before.patch_names);
  EXPECT_EQ(folder.n_files(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Formats, WriteSurfaceShared,
                         testing::Values("obj", "ply", "vtp", "vtk", "obj.gz", "ply.gz", "vtp.gz", "VTK.GZ"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::ranges::replace(name, '.', '_');
                           return name;
                         });

TEST(WriteSurface, KeepsPointsAndTrianglesInOff) {
  const TemporaryFolder folder;
  write_surface(folder / "a.off", sample());
  const auto after = read_surface(folder / "a.off");
  EXPECT_EQ(after.points, sample().points);
  EXPECT_EQ(after.faces, sample().faces);
  EXPECT_EQ(after.patch_names.size(), 1u);
}

TEST(WriteSurface, WritesSeveralPatchesAsAsciiSolids) {
  const TemporaryFolder folder;
  const auto before = sample();
  write_surface(folder / "a.stl", before);
  const auto after = read_surface(folder / "a.stl");
  EXPECT_EQ(after.patch_names, before.patch_names);
  const std::vector<std::size_t> order = {1, 2, 0, 3};  // by patch
  for (std::size_t i = 0; i < order.size(); ++i) {
    EXPECT_EQ(after.triangle(FaceId(i)), before.triangle(FaceId(order[i])));
  }
}

TEST(WriteSurface, WritesOnePatchAsBinaryStl) {
  const TemporaryFolder folder;
  auto mesh = sample();
  mesh.patch_names.raw() = {"all"};
  mesh.face_patch.assign(4, PatchId(0));
  write_surface(folder / "a.stl", mesh);
  EXPECT_EQ(std::filesystem::file_size(folder / "a.stl"), 84u + 4 * 50);
  const auto after = read_surface(folder / "a.stl");
  for (const FaceId f : mesh.faces.ids()) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(after.triangle(f)[k][axis], static_cast<float>(mesh.triangle(f)[k][axis]));
      }
    }
  }
}

TEST(WriteSurface, RefusesWhatBinaryStlCannotHold) {
  const TemporaryFolder folder;
  auto mesh = sample();
  mesh.patch_names.raw() = {"all"};
  mesh.face_patch.assign(4, PatchId(0));
  mesh.points[VertexId(0)] = {1e300, 0, 0};
  EXPECT_THAT([&] { write_surface(folder / "a.stl", mesh); }, ThrowsMessage<InputError>(HasSubstr("single precision")));
  EXPECT_EQ(folder.n_files(), 0u);
}

TEST(WriteSurface, RefusesUnknownEndings) {
  EXPECT_THAT([] { write_surface("a.objj", sample()); }, ThrowsMessage<InputError>(HasSubstr("did you mean .obj?")));
  EXPECT_THROW(write_surface("/no/such/folder/a.obj", sample()), IoError);
}

}  // namespace
}  // namespace nearwall::io
