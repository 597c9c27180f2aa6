// A vessel that forks: three tubes round half lines from a junction, blended smoothly where they meet. Its triangles
// are laid out in rows: the tubes meet in three seams, arcs from a point above the junction to one below it in the
// planes that halve the angles between them; rings run from two seams to the tube's cylinder. What lies on no cylinder
// is moved onto the blended surface.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "nearwall/geometry/angles.h"
#include "shapes/definition.h"
#include "shapes/heading.h"
#include "shapes/revolution.h"
#include "shapes/sampling.h"

namespace nearwall::shapes {
namespace {

using geometry::kPi;

/// Default edge length, over the smallest radius.
constexpr double kDefaultSize = 0.15;
/// Distances of tubes that differ by less than this are blended, over the smallest radius.
constexpr double kBlend = 0.7;
/// Where two tubes are blended already the third one counts up to this distance, over that of the blend: they lie up to
/// a quarter of it farther out.
constexpr double kBlendReach = 1.25;
/// Newton steps to the surface; points begin within a fraction of a radius from it, half as many reach rounding where
/// the surface is smooth.
constexpr int kProjectionSteps = 8;
/// Lines along a tube and pieces of each by which the longest one is found.
constexpr int kLineSamples = 16;

/// A tube of the vessel, from the junction at the origin.
struct Tube {
  const char* cap = nullptr;  ///< patch
  double heading = 0;         ///< [rad, from x towards z]
  double radius = 0;
  double length = 0;
  Vec3 along = heading_vector(heading);

  /// A point of the circle at a distance from the junction; turn 0 is above (+y), a quarter towards larger headings.
  Vec3 on_circle(double distance, double turn) const {
    const double angle = 2 * kPi * turn;
    return along * distance + Vec3(0, radius * std::cos(angle), 0) + across(along) * (radius * std::sin(angle));
  }
};

/// A distance and its gradient.
struct Distance {
  double value = 0;
  Vec3 gradient;
};

/// Signed distance from a tube without end.
Distance from_tube(const Tube& tube, const Vec3& p) {
  const Vec3 radial = p - tube.along * std::max(0.0, dot(p, tube.along));
  return {norm(radial) - tube.radius, normalized(radial)};
}

/// The smaller of two, with a continuous gradient: where they differ by less than `width` up to a quarter of it less.
Distance blended(const Distance& a, const Distance& b, double width) {
  const Distance &low = a.value <= b.value ? a : b, &high = a.value <= b.value ? b : a;
  const double overlap = width - (high.value - low.value);
  if (overlap <= 0) return low;
  const double weight = 0.5 * overlap / width;
  return {low.value - 0.5 * weight * overlap, low.gradient * (1 - weight) + high.gradient * weight};
}

/// The blended surface of the tubes outlet-1, inlet, outlet-2.
struct Blend {
  std::array<Tube, 3> tubes;
  double width = 0;

  Vec3 project(Vec3 p) const {
    for (int i = 0; i < kProjectionSteps; ++i) {
      const Distance outlets = blended(from_tube(tubes[0], p), from_tube(tubes[2], p), width);
      const Distance d = blended(outlets, from_tube(tubes[1], p), width);
      p -= d.gradient * (d.value / squared_norm(d.gradient));
    }
    return p;
  }

  /// Distance from the junction beyond which a tube is a cylinder, as far as its neighbour goes.
  double cylinder_begin(const Tube& tube, const Tube& other) const {
    const double angle = std::abs(other.heading - tube.heading), cosine = std::cos(angle), sine = std::sin(angle);
    // The nearest point of the circle keeps this distance from the other tube's axis.
    const double clear = other.radius + kBlendReach * width;
    const double beside = (clear + tube.radius * cosine) / sine;
    if (sine > 0 && beside * cosine + tube.radius * sine >= 0) return beside;
    return std::sqrt(std::max(0.0, clear * clear - tube.radius * tube.radius));
  }
};

/// Where two neighbouring tubes meet.
struct Seam {
  Vec3 out;           ///< direction in the (x, z) plane, halfway between theirs
  double reach = 0;   ///< of its middle from the junction
  double height = 0;  ///< of its ends above and below the junction
  Row row;            ///< from above to below

  /// The half ellipse that begins as the seam's points. \param t  0 above, 1 below
  Vec3 at(double t) const { return out * (reach * std::sin(kPi * t)) + Vec3(0, height * std::cos(kPi * t), 0); }
};

Seam seam_between(const Blend& blend, const Tube& first, const Tube& second, double height) {
  const double turn = second.heading < first.heading ? 2 * kPi : 0;
  const double half = 0.5 * (second.heading + turn - first.heading);
  // Where the cylinders meet, and from there to where they are blended.
  const double meeting = 0.5 * (first.radius + second.radius) / std::sin(half);
  const Vec3 out = heading_vector(first.heading + half);
  return {out, norm(blend.project(out * meeting)), height, {}};
}

/// The part of a tube between its seams and its cylinder.
struct Transition {
  Tube tube;
  Seam before, after;  ///< those on the sides of smaller and of larger headings
  double end = 0;      ///< distance of the cylinder's beginning from the junction

  /// \param turn  0 to 1 round the tube as on its circles   \param t  0 at the seams, 1 at the cylinder
  Vec3 at(const Blend& blend, double turn, double t) const {
    const bool is_after = turn <= 0.5;
    const Seam& seam = is_after ? after : before;
    const double s = is_after ? 2 * turn : 2 - 2 * turn;
    const Vec3 a = seam.at(s), b = tube.on_circle(end, turn);
    // Lines leave a seam across its plane, but at its ends along the tube, so that both sides agree there.
    const double middle = std::sin(kPi * s) * std::sin(kPi * s);
    const Vec3 leave = across(seam.out) * (is_after ? -1 : 1);
    const Vec3 at_a = normalized(leave * middle + tube.along * (1 - middle)) * distance(a, b);
    const Vec3 at_b = tube.along * distance(a, b);
    // The cubic with these ends and derivatives.
    const double u = 1 - t;
    return blend.project(a * (u * u * (1 + 2 * t)) + b * (t * t * (1 + 2 * u)) + at_a * (u * u * t) -
                         at_b * (t * t * u));
  }

  double longest_line(const Blend& blend) const {
    double longest = 0;
    for (int i = 0; i < kLineSamples; ++i) {
      const double turn = static_cast<double>(i) / kLineSamples;
      const auto point = [&](int k) { return at(blend, turn, static_cast<double>(k) / kLineSamples); };
      double length = 0;
      for (int k = 1; k <= kLineSamples; ++k) length += distance(point(k), point(k - 1));
      longest = std::max(longest, length);
    }
    return longest;
  }
};

void add_seam(SurfaceBuilder& builder, const Blend& blend, Seam& seam, VertexId above, VertexId below, double size) {
  const auto at = [&](double t) { return blend.project(seam.at(t)); };
  const std::vector<double> t = graded_parameters(at, {.size = size, .minimum = kMinCircle / 2});
  seam.row = {above};
  for (std::size_t i = 1; i + 1 < t.size(); ++i) seam.row.push_back(builder.add_point(at(t[i])));
  seam.row.push_back(below);
}

void add_tube(SurfaceBuilder& builder, const Blend& blend, const Transition& transition, double size) {
  const Tube& tube = transition.tube;
  int k = 1;
  Row previous = loop_of({transition.after.row, reversed(transition.before.row)});
  const auto continue_to = [&](const char* patch, const Row& next) {
    builder.stitch_rings(builder.patch(patch), previous, next);
    previous = next;
  };
  const auto phase = [&k] { return k++ % 2 == 0 ? 0 : 0.5; };
  const auto circle = [&](double at, double radius) {
    const Vec3 centre = tube.along * at;
    if (radius == 0) return Row{builder.add_point(centre)};
    return add_circle(builder, centre, Vec3(0, radius, 0), across(tube.along) * radius, n_on_circle(radius, size),
                      phase());
  };
  const int n = n_segments(transition.longest_line(blend), row_distance(size), 2);
  for (int i = 1; i < n; ++i) {
    const auto ring = [&](double turn) { return transition.at(blend, turn, static_cast<double>(i) / n); };
    Row row;
    for (const double turn : closed_curve_parameters(ring, size, phase())) row.push_back(builder.add_point(ring(turn)));
    continue_to("wall", row);
  }
  const double rest = tube.length - transition.end;
  for (const double at : uniform(transition.end, tube.length, n_segments(rest, row_distance(size)))) {
    continue_to("wall", circle(at, tube.radius));
  }
  const std::vector<double> radii = uniform(tube.radius, 0, n_segments(tube.radius, row_distance(size)));
  for (std::size_t i = 1; i < radii.size(); ++i) continue_to(tube.cap, circle(tube.length, radii[i]));
}

mesh::SurfaceMesh make_vessel(const Values& v, double size) {
  const double inlet = v["radius"], outlet = v["outlet-radius"], half = geometry::to_radians(v["angle"]) / 2;
  const double smallest = std::min(inlet, outlet), largest = std::max(inlet, outlet);
  const double h = size == 0 ? kDefaultSize * smallest : std::min(size, 2 * kPi * smallest / kMinRound);
  require(largest <= 2 * smallest, "the radii of a vessel's inlet and outlets must differ by a factor of 2 at most");
  // By heading, all round.
  const Blend blend{{Tube{"outlet-1", half, outlet, v["outlet-length"]}, Tube{"inlet", kPi, inlet, v["inlet-length"]},
                     Tube{"outlet-2", 2 * kPi - half, outlet, v["outlet-length"]}},
                    kBlend * smallest};

  SurfaceBuilder builder;
  builder.patch("wall");
  const VertexId above = builder.add_point(blend.project({0, largest, 0})),
                 below = builder.add_point(blend.project({0, -largest, 0}));
  std::array<Seam, 3> seams;  // after each tube
  for (std::size_t i = 0; i < 3; ++i) {
    seams[i] = seam_between(blend, blend.tubes[i], blend.tubes[(i + 1) % 3], norm(builder.point(above)));
    add_seam(builder, blend, seams[i], above, below, h);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Tube& tube = blend.tubes[i];
    Transition transition{tube, seams[(i + 2) % 3], seams[i], 0};
    for (const Seam* seam : {&transition.before, &transition.after}) {
      transition.end = std::max(transition.end, seam->reach * dot(seam->out, tube.along) + tube.radius);
    }
    for (std::size_t j = 0; j < 3; ++j) {
      if (j != i) transition.end = std::max(transition.end, blend.cylinder_begin(tube, blend.tubes[j]));
    }
    require(transition.end < tube.length,
            "a tube of the vessel ends within its junction: give a larger inlet-length, outlet-length or angle");
    add_tube(builder, blend, transition, h);
  }
  return builder.finish();
}

}  // namespace

Definition vessel() {
  return {
      {"vessel",
       "lumen of a vessel that forks in the (x, z) plane, the inlet along x; patches wall, inlet, outlet-1, outlet-2",
       {length("radius", 0.5, "radius of the inlet"), length("outlet-radius", 0.4, "radius of both outlets"),
        angle("angle", 70, 40, 180, "between the outlets"), length("inlet-length", 2, "from the junction to the inlet"),
        length("outlet-length", 2.5, "from the junction to the outlets")}},
      make_vessel};
}

}  // namespace nearwall::shapes
