#include "shapes/revolution.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nearwall/core/expect.h"
#include "nearwall/geometry/angles.h"
#include "shapes/sampling.h"

namespace nearwall::shapes {
using geometry::kPi;
namespace {

/// Samples from which the length along a closed curve is taken.
constexpr int kClosedCurveSamples = 2000;

/// A sine below this is that of a whole number of half turns.
constexpr double kZeroSine = 1e-9;

/// Unit vector in the (y, z) plane at a whole number of quarter turns, given in half turns.
Vec3 coordinate_direction(double half_turns) {
  const int quarters = static_cast<int>(2 * half_turns);
  expect(quarters >= -1 && quarters <= 1, "a sector begins and ends at -z, y or z");
  return quarters == 0 ? Vec3(0, 1, 0) : Vec3(0, 0, quarters);
}

}  // namespace

Row add_circle(SurfaceBuilder& builder, const Vec3& centre, const Vec3& a, const Vec3& b, int n, double phase) {
  Row row;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * (i + phase) / n;
    row.push_back(builder.add_point(centre + (a * std::cos(angle) + b * std::sin(angle))));
  }
  return row;
}

std::vector<double> closed_curve_parameters(const std::function<Vec3(double)>& at, double size, double phase) {
  const std::vector<double> t = uniform(0, 1, kClosedCurveSamples);
  std::vector<double> length{0};
  for (std::size_t i = 1; i < t.size(); ++i) length.push_back(length.back() + distance(at(t[i]), at(t[i - 1])));
  const int n = n_segments(length.back(), size, kMinCircle);
  std::vector<double> result;
  std::size_t i = 1;
  for (int k = 0; k < n; ++k) {
    const double target = length.back() * (k + phase) / n;
    while (length[i] < target) ++i;
    const double fraction = (target - length[i - 1]) / (length[i] - length[i - 1]);
    result.push_back(t[i - 1] + fraction * (t[i] - t[i - 1]));
  }
  return result;
}

int n_on_circle(double radius, double size) { return n_segments(2 * kPi * radius, size, kMinCircle); }

double row_distance(double size) { return size * 0.5 * std::numbers::sqrt3; }

ProfilePiece straight_piece(std::string patch, const ProfilePoint& from, const ProfilePoint& to, double size) {
  ProfilePiece piece{std::move(patch), {}};
  const int n = n_segments(std::hypot(to.x - from.x, to.r - from.r), row_distance(size));
  const auto x = uniform(from.x, to.x, n), r = uniform(from.r, to.r, n);
  for (std::size_t i = 0; i < x.size(); ++i) piece.points.push_back({x[i], r[i]});
  return piece;
}

ProfilePiece elliptic_piece(std::string patch, double x, double a, double b, double begin, double end, double size) {
  const auto at = [&](double t) {
    const double angle = begin + (end - begin) * t;
    // The axis itself is met exactly.
    const bool on_axis = (t == 0 && std::sin(begin) < kZeroSine) || (t == 1 && std::sin(end) < kZeroSine);
    return Vec3(x + a * std::cos(angle), on_axis ? 0 : b * std::sin(angle), 0);
  };
  ProfilePiece piece{std::move(patch), {}};
  for (const double t : graded_parameters(at, {.size = row_distance(size), .minimum = 3})) {
    piece.points.push_back({at(t).x(), at(t).y()});
  }
  return piece;
}

Row add_arc(SurfaceBuilder& builder, const ProfilePoint& p, const Sector& sector, double size, bool is_turned) {
  const Vec3 centre(p.x, 0, 0);
  if (p.r == 0) return {builder.add_point(centre)};
  const int minimum = static_cast<int>(std::ceil(0.5 * kMinCircle * sector.span));
  const int n = n_segments(kPi * sector.span * p.r, size, minimum);
  Row row{builder.add_point(centre + coordinate_direction(sector.begin) * p.r)};
  for (int i = is_turned ? 0 : 1; i < n; ++i) {
    const double angle = kPi * ((i + (is_turned ? 0.5 : 0.0)) / n * sector.span + sector.begin);
    row.push_back(builder.add_point({p.x, p.r * std::cos(angle), p.r * std::sin(angle)}));
  }
  row.push_back(builder.add_point(centre + coordinate_direction(sector.begin + sector.span) * p.r));
  return row;
}

void revolve_sector(SurfaceBuilder& builder, const std::vector<ProfilePiece>& profile, const Sector& sector,
                    const std::vector<std::string>& caps, double size) {
  std::size_t n_rows = 1, k = 0;
  for (const ProfilePiece& piece : profile) n_rows += piece.points.size() - 1;
  Row begin, end, previous;
  const auto continue_to = [&](const ProfilePoint& p) {
    // Every other row is turned, but not the ones round the tips: their few edges would have to be halved.
    const bool is_turned = k % 2 == 0 && k + 2 < n_rows;
    const Row next = add_arc(builder, p, sector, size, is_turned);
    ++k;
    begin.push_back(next.front());
    end.push_back(next.back());
    return next;
  };
  for (const ProfilePiece& piece : profile) {
    const PatchId patch = builder.patch(piece.patch);
    if (previous.empty()) previous = continue_to(piece.points.front());
    for (std::size_t j = 1; j < piece.points.size(); ++j) {
      const Row next = continue_to(piece.points[j]);
      builder.stitch(patch, previous, next);
      previous = next;
    }
  }
  const auto fill = [&](std::size_t cap, const Row& loop, const Vec3& normal) {
    builder.fill(builder.patch(caps[cap]), {loop}, plane_chart({0, 0, 0}, normal), size);
  };
  if (caps.size() == 1) {
    fill(0, loop_of({begin, reversed(end)}), {0, -1, 0});
  } else {
    const Row axis = builder.edge(begin.front(), begin.back(), size);
    fill(0, loop_of({begin, reversed(axis)}), {0, 0, -1});
    fill(1, loop_of({axis, reversed(end)}), {0, -1, 0});
  }
}

void revolve(SurfaceBuilder& builder, const std::vector<ProfilePiece>& profile, double size, bool is_cyclic) {
  Row first, previous;
  int k = 0;
  const auto ring = [&](const ProfilePoint& p) {
    const Vec3 centre(p.x, 0, 0);
    if (p.r == 0) return Row{builder.add_point(centre)};
    // Every other ring is turned by half a point, so that equal counts give equilateral triangles.
    return add_circle(builder, centre, {0, p.r, 0}, {0, 0, p.r}, n_on_circle(p.r, size), k++ % 2 == 0 ? 0 : 0.5);
  };
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const PatchId patch = builder.patch(profile[i].patch);
    const auto& points = profile[i].points;
    if (i == 0) first = previous = ring(points.front());
    for (std::size_t j = 1; j < points.size(); ++j) {
      const bool closes = is_cyclic && i + 1 == profile.size() && j + 1 == points.size();
      const Row next = closes ? first : ring(points[j]);
      builder.stitch_rings(patch, previous, next);
      previous = next;
    }
  }
}

}  // namespace nearwall::shapes
