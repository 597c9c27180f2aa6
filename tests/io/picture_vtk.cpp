#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <cstdlib>
#include <set>

#include "io/picture_arguments.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/picture.h"
#include "nearwall/io/polydata_writer.h"
#include "nearwall/io/surface_writer.h"
#include "nearwall/io/vtu_writer.h"
#include "tests/io/mesh_for_tests.h"
#include "tests/io/temporary_folder.h"

namespace nearwall::io {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// An environment variable for the time of one test.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    ::setenv(name, value.c_str(), 1);
  }
  ~Environment() { old_ ? ::setenv(name_, old_->c_str(), 1) : ::unsetenv(name_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::optional<std::string> old_;
};

using Pixel = std::array<int, 3>;

struct Image {
  int width = 0, height = 0;
  std::vector<Pixel> pixels;  // row by row from below

  Pixel at(double x, double y) const {
    return pixels[static_cast<std::size_t>(y * (height - 1)) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x * (width - 1))];
  }
  std::size_t n_colours() const { return std::set<Pixel>(pixels.begin(), pixels.end()).size(); }
};

Image read_png(const std::filesystem::path& path) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* data = reader->GetOutput();
  Image image{data->GetDimensions()[0], data->GetDimensions()[1], {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto* p = static_cast<const unsigned char*>(data->GetScalarPointer(x, y, 0));
      image.pixels.push_back({p[0], p[1], p[2]});
    }
  }
  return image;
}

constexpr Pixel kWhite = {255, 255, 255};

class RenderPicture : public testing::Test {
 protected:
  PictureRequest request(const std::filesystem::path& input) const {
    PictureRequest r;
    r.input = input;
    r.output = folder / "out.png";
    r.size = {320, 200};
    return r;
  }
  Image render(const PictureRequest& r) const {
    const PictureResult result = render_picture(r);
    EXPECT_TRUE(result.made) << result.reason;
    return result.made ? read_png(r.output) : Image{1, 1, {kWhite}};
  }
  std::filesystem::path block() const {
    const CellArray x = {"X", [](const mesh::CellBatch& cells, std::span<double> out) {
                           for (std::size_t i = 0; i < out.size(); ++i) out[i] = cells.corners[i][0].x();
                         }};
    write_vtu(folder / "block.vtu", wedge_block(8, 40), std::span(&x, 1), {{"floor"}});
    return folder / "block.vtu";
  }

  TemporaryFolder folder;
  Environment helper{"NEARWALL_RENDER", NEARWALL_RENDER_PROGRAM};
};

TEST_F(RenderPicture, ShowsASurfaceOnWhite) {
  mesh::SurfaceMesh square;
  square.points.raw() = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (const auto& f : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
    square.faces.push_back({VertexId(f[0]), VertexId(f[1]), VertexId(f[2])});
    square.face_patch.push_back(PatchId(0));
  }
  square.patch_names.push_back("square");
  write_surface(folder / "a.obj", square);
  auto r = request(folder / "a.obj");
  r.view = Vec3(0, 0, 1);
  r.edges = false;
  const Image image = render(r);
  EXPECT_EQ(image.width, 320);
  EXPECT_EQ(image.height, 200);
  EXPECT_EQ(image.at(0, 0), kWhite);
  EXPECT_NE(image.at(0.5, 0.5), kWhite);
  EXPECT_NE(image.at(0.5, 0.1), kWhite) << "the height is filled";
  EXPECT_EQ(image.at(0.1, 0.5), kWhite) << "a square in a broad picture";
  EXPECT_EQ(folder.n_files(), 2u);
}

TEST_F(RenderPicture, ColoursASectionByItsCells) {
  auto r = request(block());
  r.colour_by = "X";
  r.clip = ClipPlane{{0, -1, 0}, std::nullopt};
  r.edges = false;
  const Image image = render(r);
  EXPECT_GT(image.n_colours(), 10u);
  r.colour_by = "Y";
  EXPECT_THAT([&] { render_picture(r); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("no array 'Y'"), HasSubstr("Layer"))));
}

TEST_F(RenderPicture, FillsThePictureWithTheZoomBox) {
  auto r = request(block());
  r.clip = ClipPlane{{0, -1, 0}, std::nullopt};
  r.zoom = ZoomBox{{0.45, 0.5, 0.0}, {0.5, 0.5, 0.04}};
  const Image near = render(r);
  r.zoom.reset();
  const Image far = render(r);
  EXPECT_NE(near.pixels, far.pixels);
}

TEST_F(RenderPicture, ShowsLinesOfAPolyDataFile) {
  PolyDataFile data;
  data.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  data.triangles = {{0, 1, 2}};
  data.lines = {{0, 2}};
  data.triangle_data = {{"PointKind", std::vector<std::int32_t>{1}, 1}};
  data.line_data = {{"Turn", std::vector<double>{90}, 1}};
  write_polydata(folder / "a.vtp", data);
  auto r = request(folder / "a.vtp");
  r.colour_by = "PointKind";
  r.view = Vec3(0, 0, 1);
  EXPECT_GT(render(r).n_colours(), 3u);
}

TEST_F(RenderPicture, SaysWhyThereCanBeNone) {
  const Environment no_programs("PATH", folder.path().string());
  const Environment no_display("DISPLAY", "");
  const PictureResult result = render_picture(request(block()));
  EXPECT_FALSE(result.made);
  EXPECT_THAT(result.reason, HasSubstr("Xvfb is not installed"));
  EXPECT_EQ(folder.n_files(), 1u) << "no picture, not even a part of one";
}

TEST_F(RenderPicture, StartsItsOwnDisplayWhereTheGivenOneIsDead) {
  const Environment dead("DISPLAY", ":7654");
  EXPECT_GT(render(request(block())).n_colours(), 2u);
}

TEST_F(RenderPicture, RefusesWrongRequests) {
  auto r = request(folder / "none.vtu");
  EXPECT_THAT([&] { render_picture(r); }, ThrowsMessage<InputError>(HasSubstr("no such file")));
  r = request(folder.file("bad.stl", "solid\nfacet"));
  EXPECT_THAT([&] { render_picture(r); }, ThrowsMessage<GeometryError>(HasSubstr("bad.stl")));
  r.output = folder / "out.jpg";
  EXPECT_THROW(render_picture(r), InputError);
  r.output = folder / "no/out.png";
  EXPECT_THROW(render_picture(r), IoError);
  r.size = {1, 200};
  EXPECT_THROW(render_picture(r), InputError);
}

TEST_F(RenderPicture, ReportsAVtuThatVtkCannotRead) {
  const auto r = request(folder.file("bad.vtu", "<VTKFile type=\"UnstructuredGrid\"><Unstr"));
  EXPECT_THAT([&] { render_picture(r); }, ThrowsMessage<GeometryError>(HasSubstr("bad.vtu")));
}

TEST(ParseClipPlane, ReadsAxesNormalsAndPoints) {
  EXPECT_EQ(parse_clip_plane("x").normal, Vec3(1, 0, 0));
  EXPECT_EQ(parse_clip_plane("-z").normal, Vec3(0, 0, -1));
  EXPECT_FALSE(parse_clip_plane("y").point);
  EXPECT_EQ(parse_clip_plane("y=-0.25").point, Vec3(0, -0.25, 0));
  EXPECT_EQ(parse_clip_plane("1, 2,3").normal, Vec3(1, 2, 3));
  EXPECT_EQ(parse_clip_plane("1,2,3,4,5,6").point, Vec3(4, 5, 6));
  for (const char* wrong : {"", "w", "x=", "xy", "1,2", "0,0,0", "1,2,3,4", "1,2,nan", "x=1,2"}) {
    EXPECT_THAT([&] { parse_clip_plane(wrong); }, ThrowsMessage<InputError>(HasSubstr("allowed: x, y, z"))) << wrong;
  }
}

TEST(PictureArguments, CarryTheWholeRequest) {
  PictureRequest r;
  r.input = "a file=odd.vtu";
  r.output = "b.png";
  r.size = {77, 99};
  r.colour_by = "Layer";
  r.title = "layers, in all";
  r.logarithmic = true;
  r.edges = false;
  r.range = {{0.1, 1e30}};
  r.clip = ClipPlane{{1, 2, 3}, Vec3(0.1, 0.2, 0.3)};
  r.zoom = ZoomBox{{1, 2, 3}, {4, 5, 6}};
  r.view = Vec3(-1, 0, 1e-3);
  const auto words = to_arguments(r);
  EXPECT_EQ(to_arguments(request_of(words)), words);
  EXPECT_EQ(request_of(words).clip->point, r.clip->point);
  EXPECT_EQ(request_of(words).input, r.input);
  EXPECT_EQ(words.size(), 12u) << "a new field needs its word";
}

}  // namespace
}  // namespace nearwall::io
