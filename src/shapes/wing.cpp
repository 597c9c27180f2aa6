#include "shapes/wing.h"

#include <algorithm>
#include <cmath>

#include "nearwall/geometry/angles.h"
#include "shapes/sampling.h"

namespace nearwall::shapes {
namespace {

/// Fewest stretches along the span.
constexpr int kMinSpanwise = 3;

/// Largest edge length over the shorter chord.
constexpr double kMaxSize = 0.2;

/// Where a point of the section lies at the root (y = 0) and at the flat tip.
struct SpanLine {
  Vec3 root, tip;
  double start = 0;

  Vec3 at(double fraction) const {
    const double f = start + (1 - start) * fraction;
    return f == 1 ? tip : root + (tip - root) * f;
  }
};

SpanLine span_line(const HalfWing& wing, const SectionPoint& p) {
  const Vec3 tip_edge = wing.root + Vec3(wing.half_span * std::tan(wing.sweep), wing.half_span, 0);
  SpanLine line{wing.root + Vec3(p.x, 0, p.z) * wing.root_chord, tip_edge + Vec3(p.x, 0, p.z) * wing.tip_chord};
  if (wing.start) line.start = wing.start(line.root, line.tip);
  return line;
}

/// The section's lines along the span, side by side.
struct SectionLines {
  std::vector<SpanLine> upper, lower, base;  // lower without its ends if they are shared; base without its ends
};

SectionLines section_lines(const HalfWing& wing, double size) {
  SectionLines lines;
  for (const double t : wing.t) {
    lines.upper.push_back(span_line(wing, wing.section.upper(t)));
    lines.lower.push_back(span_line(wing, wing.section.lower(t)));
  }
  if (wing.section.is_blunt) {
    const SectionPoint a = wing.section.upper(1), b = wing.section.lower(1);
    const int n = n_segments((a.z - b.z) * std::min(wing.root_chord, wing.tip_chord), size);
    const auto x = uniform(a.x, b.x, n), z = uniform(a.z, b.z, n);
    for (int i = 1; i < n; ++i) lines.base.push_back(span_line(wing, {x[i], z[i]}));
  }
  return lines;
}

SectionRows add_section(SurfaceBuilder& builder, const HalfWing& wing, const SectionLines& lines, double fraction) {
  SectionRows rows;
  const auto add = [&](Row& row, const SpanLine& line) { row.push_back(builder.add_point(line.at(fraction))); };
  for (const SpanLine& line : lines.upper) add(rows.upper, line);
  rows.lower.push_back(rows.upper.front());
  for (std::size_t i = 1; i + 1 < lines.lower.size(); ++i) add(rows.lower, lines.lower[i]);
  rows.base.push_back(rows.upper.back());
  if (wing.section.is_blunt) {
    add(rows.lower, lines.lower.back());
    for (const SpanLine& line : lines.base) add(rows.base, line);
    rows.base.push_back(rows.lower.back());
  } else {
    rows.lower.push_back(rows.upper.back());
  }
  return rows;
}

/// The half circle at the tip from a point of the upper side to its counterpart on the lower one.
Row add_tip_arc(SurfaceBuilder& builder, VertexId upper, VertexId lower, double edge) {
  if (upper == lower) return {upper};
  const Vec3 a = (builder.point(upper) - builder.point(lower)) * 0.5;
  const Vec3 centre = builder.point(lower) + a, out(0, norm(a), 0);
  // Even, so that there is a point where the tip reaches farthest.
  const int n = 2 * n_segments(0.5 * geometry::kPi * norm(a), edge);
  Row arc{upper};
  for (int i = 1; i < n; ++i) {
    const double angle = geometry::kPi * i / n;
    arc.push_back(builder.add_point(centre + (a * std::cos(angle) + out * std::sin(angle))));
  }
  arc.push_back(lower);
  return arc;
}

void add_rounded_tip(SurfaceBuilder& builder, const HalfWing& wing, const SectionRows& tip, double size) {
  const PatchId patch = builder.patch(wing.prefix + "tip");
  const auto chordwise = [&](std::size_t i) {
    return distance(builder.point(tip.upper[i - 1]), builder.point(tip.upper[i]));
  };
  Row previous{tip.upper.front()};
  for (std::size_t i = 1; i < tip.upper.size(); ++i) {
    const Row arc = add_tip_arc(builder, tip.upper[i], tip.lower[i], std::min(size, chordwise(i)));
    builder.stitch(patch, arc, previous);
    previous = arc;
  }
  if (wing.section.is_blunt) builder.stitch(builder.patch(wing.prefix + "trailing-edge"), tip.base, previous);
}

}  // namespace

double wing_size(double size, double root_chord, double tip_chord) {
  return std::min(size, kMaxSize * std::min(root_chord, tip_chord));
}

SectionRows add_half_wing(SurfaceBuilder& builder, const HalfWing& wing, double size) {
  const SectionLines lines = section_lines(wing, size);
  const PatchId upper = builder.patch(wing.prefix + "upper"), lower = builder.patch(wing.prefix + "lower");
  const int n = n_segments(wing.half_span / std::cos(wing.sweep), size, kMinSpanwise);
  const SectionRows root = add_section(builder, wing, lines, 0);
  SectionRows previous = root;
  for (int k = 1; k <= n; ++k) {
    const SectionRows next = add_section(builder, wing, lines, static_cast<double>(k) / n);
    builder.stitch_pairs(upper, previous.upper, next.upper);
    builder.stitch_pairs(lower, next.lower, previous.lower);
    if (wing.section.is_blunt)
      builder.stitch_pairs(builder.patch(wing.prefix + "trailing-edge"), previous.base, next.base);
    previous = next;
  }
  if (wing.has_rounded_tip) {
    add_rounded_tip(builder, wing, previous, size);
  } else {
    builder.fill(builder.patch(wing.prefix + "tip"), {previous.loop()},
                 plane_chart(builder.point(previous.upper.front()), {0, 1, 0}), size);
  }
  return root;
}

}  // namespace nearwall::shapes
