#include "shapes/ahmed.h"

#include <array>
#include <cmath>

#include "nearwall/geometry/angles.h"
#include "shapes/definition.h"
#include "shapes/prism.h"
#include "shapes/revolution.h"
#include "shapes/sampling.h"

namespace nearwall::shapes {
namespace {

using geometry::kPi;

// Dimensions in metres. Source: Ahmed, Ramm & Faltin, SAE 840300 (1984); stilts as in the ERCOFTAC data base, case 82.
constexpr double kLength = kAhmedLength;
constexpr double kWidth = kAhmedWidth;
constexpr double kHeight = kAhmedHeight;
constexpr double kClearance = kAhmedClearance;
constexpr double kFrontRadius = 0.100;
constexpr double kSlantLength = 0.222;
constexpr double kStiltRadius = 0.015;
constexpr std::array<double, 2> kStiltX = {0.202, 0.672};
constexpr double kStiltY = 0.1635;
constexpr double kDefaultSize = 0.015;

/// Largest turn from one edge to the next round the front [deg].
constexpr double kFrontTurnDeg = 15;

constexpr double kLow = kClearance, kHigh = kClearance + kHeight;

/// The front is rounded on all four sides; two roundings meet at a mitre. Along it the angle b runs from 0 at the flat
/// front to pi/2 where the flat sides begin.
double rounding_x(double b) { return kFrontRadius * (1 - std::cos(b)); }
double rounding_inset(double b) { return kFrontRadius * (1 - std::sin(b)); }

/// One rounded side of the front, unrolled. \param across  axis along the edge (1: y, 2: z)   \param side  of the other
/// axis
Chart rounding_chart(int across, double limit, double sign) {
  const int other = 3 - across;
  return {[=](const Vec3& p) {
            const double depth = kFrontRadius - sign * (limit - p[other]);
            return Point2{p[across], kFrontRadius * std::atan2(depth, kFrontRadius - p.x())};
          },
          [=](const Point2& q) {
            const double b = q.v / kFrontRadius;
            Vec3 p(rounding_x(b), 0, 0);
            p[across] = q.u;
            p[other] = limit - sign * rounding_inset(b);
            return p;
          }};
}

/// Corners of a cross-section, counterclockwise seen from the front: low right … The left ones of a half are in y = 0.
using Corners = std::array<VertexId, 4>;

Corners add_corners(SurfaceBuilder& builder, double x, double inset, bool is_half) {
  const double y = kWidth / 2 - inset, left = is_half ? 0 : -y, low = kLow + inset, high = kHigh - inset;
  return {builder.add_point({x, y, low}), builder.add_point({x, left, low}), builder.add_point({x, left, high}),
          builder.add_point({x, y, high})};
}

/// \returns the rows from the flat front's corners to those of the rim
std::array<Row, 4> add_front(SurfaceBuilder& b, const Corners& front, const Corners& rim, double size) {
  const auto mitre = [](double t) {
    const double angle = kPi / 2 * t, inset = rounding_inset(angle);
    return Vec3(rounding_x(angle), inset, inset);
  };
  const auto t = graded_parameters(mitre, {.size = size, .max_turn = geometry::to_radians(kFrontTurnDeg)});
  std::array<Row, 4> mitres;
  for (std::size_t c = 0; c < 4; ++c) {
    const Vec3 corner = b.point(rim[c]);
    // In the plane of symmetry there is no side to be rounded: the mitre is an arc in that plane.
    const double y = corner.y() == 0 ? 0 : (corner.y() > 0 ? -1 : 1), z = corner.z() > kLow ? -1 : 1;
    mitres[c].push_back(front[c]);
    for (std::size_t i = 1; i + 1 < t.size(); ++i) {
      const Vec3 m = mitre(t[i]);
      mitres[c].push_back(b.add_point({m.x(), corner.y() + y * m.y(), corner.z() + z * m.z()}));
    }
    mitres[c].push_back(rim[c]);
  }
  add_flat_face(b, "front", {front[0], front[1], front[2], front[3]}, size);
  const std::array<Chart, 4> charts = {rounding_chart(1, kLow, -1), rounding_chart(2, -kWidth / 2, -1),
                                       rounding_chart(1, kHigh, 1), rounding_chart(2, kWidth / 2, 1)};
  for (std::size_t c = 0; c < 4; ++c) {
    const std::size_t d = (c + 1) % 4;
    if (b.point(rim[c]).y() == 0 && b.point(rim[d]).y() == 0) continue;  // open there
    b.fill(b.patch("front"),
           {loop_of({b.edge(front[d], front[c], size), mitres[c], b.edge(rim[c], rim[d], size), reversed(mitres[d])})},
           charts[c], size);
  }
  return mitres;
}

/// The rows round both ends of a stilt, counterclockwise seen from above.
struct Stilt {
  Row foot, top;
};

/// A stilt under the body: a cylinder, closed below if it has a foot.
Stilt add_stilt(SurfaceBuilder& b, double x, double y, double size, bool has_foot) {
  const PatchId patch = b.patch("stilts");
  const double h = std::min(size, 2 * kPi * kStiltRadius / kMinRound);
  int k = 0;
  const auto circle = [&](double z, double r) {
    return add_circle(b, {x, y, z}, {r, 0, 0}, {0, r, 0}, n_on_circle(r, h), k++ % 2 == 0 ? 0 : 0.5);
  };
  Row previous{b.add_point({x, y, 0})};
  const auto continue_to = [&](const Row& next) {
    b.stitch_rings(patch, previous, next);
    previous = next;
  };
  const int n_disc = n_segments(kStiltRadius, row_distance(h)), n_side = n_segments(kClearance, row_distance(h));
  if (has_foot) {
    for (int i = 1; i <= n_disc; ++i) continue_to(circle(0, kStiltRadius * i / n_disc));
  } else {
    previous = circle(0, kStiltRadius);
  }
  const Row foot = previous;
  for (int i = 1; i <= n_side; ++i) continue_to(circle(i == n_side ? kLow : kLow * i / n_side, kStiltRadius));
  return {foot, previous};
}

mesh::SurfaceMesh make_ahmed(const Values& v, double size) {
  SurfaceBuilder builder;
  add_ahmed_body(builder, {.slant = geometry::to_radians(v["slant-angle"]), .has_stilts = v.is_on("stilts")},
                 ahmed_size(size));
  return builder.finish();
}

}  // namespace

double ahmed_size(double size) { return size == 0 ? kDefaultSize : std::min(size, kFrontRadius); }

AhmedOpenings add_ahmed_body(SurfaceBuilder& b, const AhmedBody& body, double h) {
  const double left_side = body.is_half ? 0 : -kWidth / 2, right_side = kWidth / 2;
  const Corners front = add_corners(b, 0, kFrontRadius, body.is_half),
                rim = add_corners(b, kFrontRadius, 0, body.is_half);
  const double slant_end = kHigh - kSlantLength * std::sin(body.slant);
  const Corners back = {b.add_point({kLength, right_side, kLow}), b.add_point({kLength, left_side, kLow}),
                        b.add_point({kLength, left_side, slant_end}), b.add_point({kLength, right_side, slant_end})};
  const double roof_end = kLength - kSlantLength * std::cos(body.slant);
  const VertexId left = b.add_point({roof_end, left_side, kHigh}), right = b.add_point({roof_end, right_side, kHigh});

  const std::array<Row, 4> mitres = add_front(b, front, rim, h);
  add_flat_face(b, "roof", {rim[3], rim[2], left, right}, h);
  add_flat_face(b, "slant", {right, left, back[2], back[3]}, h);
  add_flat_face(b, "base", {back[0], back[3], back[2], back[1]}, h);
  add_flat_face(b, "side-right", {rim[0], rim[3], right, back[3], back[0]}, h);
  AhmedOpenings openings;
  if (body.is_half) {
    openings.cut = loop_of({b.edge(rim[1], back[1], h), b.edge(back[1], back[2], h), b.edge(back[2], left, h),
                            b.edge(left, rim[2], h), reversed(mitres[2]), b.edge(front[2], front[1], h), mitres[1]});
  } else {
    add_flat_face(b, "side-left", {rim[1], back[1], back[2], left, rim[2]}, h);
  }

  std::vector<Row> underbody = {loop_of({b.edge(rim[0], back[0], h), b.edge(back[0], back[1], h),
                                         b.edge(back[1], rim[1], h), b.edge(rim[1], rim[0], h)})};
  const PatchId patch = b.patch("underbody");
  for (const double x : kStiltX) {
    for (const double y : {-kStiltY, kStiltY}) {
      if (!body.has_stilts || (body.is_half && y < 0)) continue;
      const Stilt stilt = add_stilt(b, x, y, h, body.has_feet);
      underbody.push_back(stilt.top);
      if (!body.has_feet) openings.stilts.push_back(stilt.foot);
    }
  }
  b.fill(patch, underbody, plane_chart({0, 0, kLow}, {0, 0, -1}), h);
  return openings;
}

std::vector<Definition> vehicle_shapes() {
  return {
      {{"ahmed",
        "Ahmed body in metres, ground at z = 0; patches front, roof, slant, base, side-left, side-right, underbody, "
        "stilts",
        {angle("slant-angle", 25, 1, 40, "angle of the rear slant to the roof"),
         option("stilts", false, "1: stands on its four stilts")}},
       make_ahmed}};
}

}  // namespace nearwall::shapes
