// A car in half a wind tunnel: the boundary of the flow round it, for fluid = "inside".
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/box.h"
#include "shapes/ahmed.h"
#include "shapes/definition.h"
#include "shapes/prism.h"
#include "shapes/sampling.h"

namespace nearwall::shapes {
namespace {

/// The floor is as fine as the car up to this far round it, over the car's height.
constexpr double kFineMargin = 0.35;
/// Samples by which an edge is cut into pieces that grow.
constexpr int kEdgeSamples = 4000;

/// Edge length wanted at a place: that of the car beside it, growing with the distance up to that of the tunnel.
struct SizeAway {
  geometry::Box fine;
  double near = 0;
  double far = 0;

  double operator()(const Vec3& p) const {
    Vec3 away;
    for (int axis = 0; axis < 3; ++axis) {
      away[axis] = std::max({0.0, fine.low[axis] - p[axis], p[axis] - fine.high[axis]});
    }
    return std::min(far, near + kEdgeGrowth * norm(away));
  }
};

/// A straight row from a to b with edges of the size wanted where they are.
Row add_graded_edge(SurfaceBuilder& builder, VertexId a, VertexId b, const SizeAway& size) {
  const Vec3 from = builder.point(a), to = builder.point(b);
  const auto at = [&](double t) { return from + (to - from) * t; };
  // The number of edges up to each sample, as a real number; the points lie where it is whole.
  std::vector<double> count{0};
  const double step = distance(from, to) / kEdgeSamples;
  for (int i = 0; i < kEdgeSamples; ++i) count.push_back(count.back() + step / size(at((i + 0.5) / kEdgeSamples)));
  const int n = n_segments(count.back(), 1);
  Row row{a};
  std::size_t i = 1;
  for (int k = 1; k < n; ++k) {
    const double target = count.back() * k / n;
    while (count[i] < target) ++i;
    const double fraction = (target - count[i - 1]) / (count[i] - count[i - 1]);
    row.push_back(builder.add_point(at((static_cast<double>(i - 1) + fraction) / kEdgeSamples)));
  }
  row.push_back(b);
  return row;
}

/// The four corners of a cross-section of the tunnel: low and high in the plane of symmetry, high and low at the side.
using Section = std::array<VertexId, 4>;

Section add_section(SurfaceBuilder& builder, double x, double width, double height) {
  return {builder.add_point({x, 0, 0}), builder.add_point({x, 0, height}), builder.add_point({x, width, height}),
          builder.add_point({x, width, 0})};
}

/// The floor: fine below and round the car, coarse elsewhere.
/// \returns its row in the plane of symmetry, from the inlet to the outlet
Row add_floor(SurfaceBuilder& b, const Section& inlet, const Section& outlet, const std::vector<Row>& outside,
              const std::vector<Row>& feet, const SizeAway& size) {
  const Vec3 &low = size.fine.low, &high = size.fine.high;
  const std::vector<VertexId> fine = {b.add_point({low.x(), 0, 0}), b.add_point({high.x(), 0, 0}),
                                      b.add_point({high.x(), high.y(), 0}), b.add_point({low.x(), high.y(), 0})};
  const auto edge = [&](std::size_t i) { return b.edge(fine[i], fine[(i + 1) % 4], size.near); };
  const Row before = add_graded_edge(b, inlet[0], fine[0], size), behind = add_graded_edge(b, fine[1], outlet[0], size);
  const Chart chart = plane_chart({0, 0, 0}, {0, 0, -1});
  const PatchId floor = b.patch("floor");

  std::vector<Row> inner = {loop_of({reversed(edge(3)), reversed(edge(2)), reversed(edge(1)), reversed(edge(0))})};
  inner.insert(inner.end(), feet.begin(), feet.end());
  b.fill(floor, inner, chart, size.near);

  const Row outer = loop_of({before, reversed(edge(3)), reversed(edge(2)), reversed(edge(1)), behind, joined(outside)});
  b.fill(floor, {reversed(outer)}, chart, size.far);
  return joined({before, edge(0), behind});
}

mesh::SurfaceMesh make_ahmed_tunnel(const Values& v, double size) {
  const double h = ahmed_size(size), width = v["width"] / 2, height = v["height"];
  const double margin = kFineMargin * kAhmedHeight;
  const double front = -v["upstream"], rear = kAhmedLength + v["downstream"];
  const SizeAway wanted{.fine = {{-margin, 0, 0}, {kAhmedLength + margin, kAhmedWidth / 2 + margin, kAhmedHeight}},
                        .near = h,
                        .far = std::max(h, v["box-size"])};
  require(v["upstream"] >= 2 * margin && v["downstream"] >= 2 * margin && width >= kAhmedWidth / 2 + 2 * margin &&
              height >= kAhmedClearance + kAhmedHeight + 2 * margin,
          "the tunnel must leave 0.2 m round the car at least: give a larger upstream, downstream, width or height");

  SurfaceBuilder b;
  const AhmedOpenings car = add_ahmed_body(b,
                                           {.slant = geometry::to_radians(v["slant-angle"]),
                                            .has_stilts = v.is_on("stilts"),
                                            .has_feet = false,
                                            .is_half = true},
                                           h);
  b.turn_over();  // normals point out of the flow
  const Section inlet = add_section(b, front, width, height), outlet = add_section(b, rear, width, height);
  std::array<Row, 3> in, out;  // round the sections, from corner to corner but for the floor
  std::array<Row, 4> along;
  for (std::size_t i = 0; i < 3; ++i) {
    in[i] = add_graded_edge(b, inlet[i], inlet[i + 1], wanted);
    out[i] = add_graded_edge(b, outlet[i], outlet[i + 1], wanted);
    along[i + 1] = add_graded_edge(b, inlet[i + 1], outlet[i + 1], wanted);
  }
  const Row in_low = add_graded_edge(b, inlet[3], inlet[0], wanted),
            out_low = add_graded_edge(b, outlet[3], outlet[0], wanted);
  along[0] = add_floor(b, inlet, outlet, {reversed(out_low), reversed(along[3]), in_low}, car.stilts, wanted);

  const auto fill = [&](const char* patch, const std::vector<Row>& loops, VertexId origin, const Vec3& normal) {
    b.fill(b.patch(patch), loops, plane_chart(b.point(origin), normal), wanted.far);
  };
  fill("inlet", {loop_of({in[0], in[1], in[2], in_low})}, inlet[0], {-1, 0, 0});
  fill("outlet", {reversed(loop_of({out[0], out[1], out[2], out_low}))}, outlet[0], {1, 0, 0});
  fill("side", {loop_of({along[2], out[2], reversed(along[3]), reversed(in[2])})}, inlet[2], {0, 1, 0});
  fill("top", {loop_of({along[1], out[1], reversed(along[2]), reversed(in[1])})}, inlet[1], {0, 0, 1});
  fill("symmetry", {loop_of({along[0], out[0], reversed(along[1]), reversed(in[0])}), car.cut}, inlet[0], {0, -1, 0});
  return b.finish();
}

}  // namespace

std::vector<Definition> tunnel_shapes() {
  return {
      {{"ahmed-tunnel",
        "the flow round half an Ahmed body over the floor of a tunnel (fluid = \"inside\"), in metres, floor at z = 0, "
        "symmetry in y = 0; patches front, roof, slant, base, side-right, underbody, stilts, floor, inlet, outlet, "
        "side, top, symmetry",
        {angle("slant-angle", 25, 1, 40, "angle of the rear slant to the roof"),
         option("stilts", false, "1: stands on its stilts; 0: hovers"),
         length("upstream", 2.1, "from the inlet to the car's front"),
         length("downstream", 4.2, "from the car's base to the outlet"),
         length("width", 1.87, "of the whole tunnel, twice that of the half"), length("height", 1.4, "of the tunnel"),
         length("box-size", 0.15, "edge length of the triangles far from the car")}},
       make_ahmed_tunnel}};
}

}  // namespace nearwall::shapes
