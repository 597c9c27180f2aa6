// Layers on walls that end at planes: what has to hold of all of them.
#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/certify/certificate.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/layers/grow.h"
#include "nearwall/mesh/layer_mesh.h"
#include "tests/support/gallery.h"
#include "tests/volume/open_shapes.h"

namespace nearwall {
namespace {

using namespace open_shapes;
using growing_for_tests::geometric;

/// A wall with layers on it.
struct Grown {
  TestOpenWall wall;
  layers::Growth growth;
  mesh::LayerMesh layers;

  Grown(surface::OpenWall open, const std::set<std::string>& with_layers, const std::vector<double>& heights)
      : wall(std::move(open)),
        growth(layers::grow(wall.wall(), wall.options(heights, with_layers))),
        layers(growth.front, growth.lines) {}
};

template <class Holds>
bool all_lines_of(const layers::Growth& growth, FaceId f, const Holds& holds) {
  const auto& lines = growth.front.faces[FrontFaceId(f.index())].lines;
  return std::all_of(lines.begin(), lines.begin() + 3, holds);
}

bool has_all_levels(const layers::Growth& growth, FaceId f) {
  return all_lines_of(growth, f, [&](LineId line) {
    return growth.asked_levels[line] > 0 && growth.lines.windows[line].end == growth.asked_levels[line];
  });
}

/// All layers, of full thickness.
bool has_all(const layers::Growth& growth, FaceId f) {
  constexpr double kRounding = 1e-9;
  return has_all_levels(growth, f) && all_lines_of(growth, f, [&](LineId line) {
           return growth.reached_thickness[line] >= growth.asked_thickness[line] * (1 - kRounding);
         });
}

class OpenGallery : public testing::TestWithParam<std::tuple<OpenShape, gallery::Schedule>> {};

void expect_in_planes(const Grown& grown) {
  const mesh::SidePlanes& planes = grown.wall.planes();
  const double extent = geometry::bounding_box(grown.wall.surface().points.raw()).diagonal();
  for (const LineId line : grown.growth.lines.windows.ids()) {
    const VertexId v = grown.growth.front.line_vertex[line];
    for (const mesh::PlaneIndex p : planes.of(v)) {
      const mesh::SidePlane& plane = planes.planes[p];
      for (Level level = 0; level <= grown.growth.lines.windows[line].end; ++level) {
        const Vec3 x = grown.growth.lines.position(line, level);
        if (plane.axis >= 0) {
          ASSERT_EQ(x[plane.axis], plane.offset * plane.normal[plane.axis]);
        } else {
          ASSERT_LE(std::abs(plane.height(x)), 1e-14 * extent);
        }
      }
    }
  }
}

/// Volume in front of a closed front, from its triangles alone.
double fluid_volume(const certify::FrontSurface& surface) {
  geometry::CompensatedSum six;
  const Vec3& origin = surface.points.front();
  for (const auto& [a, b, c] : surface.triangles) {
    six.add(-dot(cross(surface.points[a] - origin, surface.points[b] - origin), surface.points[c] - origin));
  }
  return six.value() / 6;
}

/// What the layers leave, and with all lines at the wall what is there before any layer.
double volume_left(const Grown& grown, bool with_layers) {
  mesh::Lines lines = grown.growth.lines;
  if (!with_layers) lines.windows.assign(lines.windows.size(), {});
  certify::FrontSurface surface = certify::front_surface(grown.growth.front, lines);
  EXPECT_TRUE(certify::close_front(grown.growth.front, grown.wall.planes(), surface).empty());
  return fluid_volume(surface);
}

TEST_P(OpenGallery, HasCertifiedLayersThatLandOnItsPlanes) {
  const auto& [shape, schedule] = GetParam();
  surface::OpenWall open = shape.make();
  const double diagonal = size_of(open.surface, shape.with_layers);
  const Grown grown(std::move(open), shape.with_layers, schedule.heights(diagonal));
  ASSERT_FALSE(grown.wall.planes().empty());
  const auto certificate = certify::certify_layers(grown.layers, grown.wall.certified_wall());
  EXPECT_EQ(certificate.n_bad_columns, 0u);
  EXPECT_EQ(certificate.n_front_intersections, 0u);
  EXPECT_EQ(certificate.n_covered_twice, 0u);
  EXPECT_LE(certificate.closure(), 1e-12);
  EXPECT_GT(certificate.n_cells, 0u);
  expect_in_planes(grown);
  const double before = volume_left(grown, false), after = volume_left(grown, true);
  EXPECT_NEAR(before - after, certificate.cells_volume, 1e-12 * before);
  EXPECT_NEAR(certificate.front_volume, after, 1e-12 * before);
}

INSTANTIATE_TEST_SUITE_P(All, OpenGallery,
                         testing::Combine(testing::ValuesIn(shapes_with_planes()),
                                          testing::ValuesIn(gallery::schedules())),
                         [](const auto& instance) {
                           return std::get<0>(instance.param).name + "_" + std::get<1>(instance.param).name;
                         });

TEST(OpenRoom, HasAllLayersOfFullThicknessBetweenUprightWalls) {
  const std::vector<double> heights = geometric(0.2, 1.2, 12);
  const Grown grown(room(2), {"wall"}, heights);
  double top = 0;
  for (const double h : heights) top += h;
  for (const LineId line : grown.growth.lines.windows.ids()) {
    const Vec3 base = grown.growth.lines.base[line];
    if (base.z() != 0) continue;
    const auto w = grown.growth.lines.windows[line];
    EXPECT_EQ(w.end, heights.size());
    const Vec3 end = grown.growth.lines.position(line, w.end);
    EXPECT_EQ(end.x(), base.x());
    EXPECT_EQ(end.y(), base.y());
    EXPECT_NEAR(end.z(), top, 1e-15);
  }
  const auto certificate = certify::certify_layers(grown.layers, grown.wall.certified_wall());
  EXPECT_EQ(certificate.n_cells, heights.size() * 32);
  EXPECT_NEAR(certificate.cells_volume, top, 1e-13);
}

/// A cube over a plane of symmetry that it does not touch, nearer than its layers are thick: lines leave a tenth free.
TEST(PlaneBesideABody, LimitsLayersAsAWallWould) {
  const double gap = 0.05;
  mesh::SurfaceMesh cube = shapes_for_tests::cube();
  for (int i = 0; i < 3; ++i) cube = shapes_for_tests::subdivided(cube);
  surface::OpenWall open = in_far_field(Closed(cube, {}, FluidSide::Outside).open(), {{2, -0.5 - gap, 1}});
  const std::vector<double> heights = geometric(3 * gap, 1.2, 10);
  const Grown grown(std::move(open), {"wall"}, heights);
  int n_below = 0;
  for (const LineId line : grown.growth.lines.windows.ids()) {
    const Vec3& base = grown.growth.lines.base[line];
    const bool is_inside_bottom = base.z() == -0.5 && std::abs(base.x()) < 0.4 && std::abs(base.y()) < 0.4;
    if (!is_inside_bottom) continue;
    ++n_below;
    const auto window = grown.growth.lines.windows[line];
    EXPECT_EQ(window.end, heights.size()) << "all layers, but thinner";
    const double left = grown.growth.lines.position(line, window.end).z() + 0.5 + gap;
    EXPECT_GE(left, 0.1 * gap * (1 - 1e-9));
    EXPECT_LE(left, 0.15 * gap);
    EXPECT_EQ(grown.growth.reason[line], mesh::LimitReason::Gap);
  }
  EXPECT_EQ(n_below, 49);
  EXPECT_TRUE(certify::certify_layers(grown.layers, grown.wall.certified_wall()).is_valid());
}

/// Both halves of a body from one: the wall and its mirror image, joined along the plane y = 0.
mesh::SurfaceMesh with_mirror_image(const mesh::SurfaceMesh& half) {
  mesh::SurfaceMesh whole = half;
  IdVector<VertexId, VertexId> image(half.points.size());
  for (const VertexId v : half.points.ids()) {
    const Vec3& p = half.points[v];
    image[v] = p.y() == 0 ? v : whole.points.push_back({p.x(), -p.y(), p.z()});
  }
  for (const FaceId f : half.faces.ids()) {
    const auto& v = half.faces[f];
    whole.faces.push_back({image[v[0]], image[v[2]], image[v[1]]});
    whole.face_patch.push_back(half.face_patch[f]);
  }
  return whole;
}

struct MirrorCase {
  std::string name;
  std::string shape;
  shapes::ParameterValues parameters;
  double size = 0;
  std::string cut;
};

class Mirror : public testing::TestWithParam<MirrorCase> {};

TEST_P(Mirror, LosesNoLayersThatTheWholeBodyHas) {
  const MirrorCase& c = GetParam();
  const Closed closed(shapes::make_shape(c.shape, c.parameters, c.size), {{c.cut, SideRole::Symmetry}},
                      FluidSide::Outside);
  const surface::OpenWall open = closed.open();
  const std::size_t n_half = open.surface.faces.size();
  std::set<std::string> patches;
  for (const std::string& name : open.surface.patch_names) patches.insert(name);
  patches.erase(c.cut);
  const double diagonal = size_of(open.surface, patches);
  for (const double thickness : {0.005, 0.02}) {
    const std::vector<double> heights = geometric(thickness * diagonal, 1.2, 10);
    const growing_for_tests::TestWall whole(with_mirror_image(open.surface));
    const auto of_whole = layers::grow(whole.wall(), growing_for_tests::options_for(whole.surface(), heights));
    const Grown half(in_far_field(open), patches, heights);
    // Trials go from face to face in their order, so the sides of the whole may differ, too: by no more may the half.
    std::size_t n_full = 0, n_uneven = 0, n_lost = 0, n_fewer = 0;
    for (std::size_t i = 0; i < n_half; ++i) {
      const bool is_full = has_all(of_whole, FaceId(i)), is_image_full = has_all(of_whole, FaceId(n_half + i));
      n_full += is_full && is_image_full;
      n_uneven += is_full != is_image_full;
      n_lost += is_full && is_image_full && !has_all(half.growth, FaceId(i));
      n_fewer += has_all_levels(of_whole, FaceId(i)) && !has_all_levels(half.growth, FaceId(i));
    }
    EXPECT_GT(n_full, n_half / 2) << "thickness " << thickness;
    EXPECT_LE(n_lost, n_uneven) << "of " << n_full << " at thickness " << thickness;
    EXPECT_EQ(n_fewer, 0u) << "of " << n_full << " at thickness " << thickness;
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, Mirror,
    testing::Values(MirrorCase{"spheres", "two-spheres", {{"half", 1}, {"gap", 0.2}}, 0.2, "symmetry"},
                    MirrorCase{"sharp_wing", "naca", {{"half", 1}}, 0.1, "root"},
                    MirrorCase{"blunt_wing", "naca", {{"half", 1}, {"blunt", 1}}, 0.1, "root"},
                    MirrorCase{"wing_body", "wing-body", {{"half", 1}}, 0.3, "symmetry"}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace nearwall
