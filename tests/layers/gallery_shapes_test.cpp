#include <gtest/gtest.h>

#include "nearwall/surface/admission.h"
#include "tests/support/gallery.h"
#include "tests/support/moved.h"

// Every surface of the gallery is one that may be meshed, wherever it is put: closed, oriented, free of
// self-intersection, its components nested as the fluid wants it.

namespace nearwall {
namespace {

class GalleryShapes : public testing::TestWithParam<std::size_t> {};

TEST_P(GalleryShapes, AreAdmitted) {
  const gallery::Shape& shape = gallery::shapes()[GetParam()];
  const surface::AdmissionPolicy policy{.fluid = shape.fluid_is_inside ? surface::FluidSide::Inside
                                                                       : surface::FluidSide::Outside};
  const auto fault_of = [&](mesh::SurfaceMesh made) {
    const surface::Admission admission = surface::inspect(std::move(made), policy);
    for (const surface::Component& component : admission.components) EXPECT_TRUE(component.is_wetted);
    return admission.is_usable() ? "" : std::string(surface::fault_name(admission.faults.front().kind));
  };
  EXPECT_EQ(fault_of(shape.make()), "");
  for (const gallery::Move& move : gallery::moves(2)) EXPECT_EQ(fault_of(move(shape.make())), "") << move.name;
}

TEST(GalleryShapes, DifferInEdgeLengthByFactorsOfTwenty) {
  for (const auto& make : {shapes_for_tests::dense_side, shapes_for_tests::dense_spot}) {
    const mesh::SurfaceMesh surface = make();
    const mesh::Topology topology(surface);
    double largest_jump = 0;
    for (const FaceId f : surface.faces.ids()) {
      double shortest = INFINITY, longest = 0;
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId h = mesh::Topology::halfedge(f, k);
        const double length = distance(surface.points[topology.origin(h)], surface.points[topology.target(h)]);
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
      }
      largest_jump = std::max(largest_jump, longest / shortest);
    }
    EXPECT_GT(largest_jump, 10) << "a coarse triangle stands on a dense edge";
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, GalleryShapes, testing::Range(std::size_t{0}, gallery::shapes().size()),
                         [](const auto& shape) { return gallery::shapes()[shape.param].name; });

}  // namespace
}  // namespace nearwall
