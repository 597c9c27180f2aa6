#include "nearwall/mesh/side_planes.h"

#include <algorithm>
#include <cmath>

namespace nearwall::mesh {

namespace {

/// Sine of the angle between two planes below which they count as one.
constexpr double kParallel = 1e-6;

Vec3 without(const Vec3& d, int axis) {
  return {axis == 0 ? 0.0 : d.x(), axis == 1 ? 0.0 : d.y(), axis == 2 ? 0.0 : d.z()};
}

}  // namespace

Vec3 SidePlane::within(const Vec3& d) const { return axis >= 0 ? without(d, axis) : d - normal * dot(normal, d); }

double SidePlane::height(const Vec3& p) const { return dot(normal, p) - offset; }

int SidePlane::dropped_axis() const {
  if (axis >= 0) return axis;
  int longest = 0;
  for (int a = 1; a < 3; ++a) {
    if (std::abs(normal[a]) > std::abs(normal[longest])) longest = a;
  }
  return longest;
}

std::array<double, 2> SidePlane::flat(const Vec3& p) const {
  const int a = dropped_axis(), b = (a + 1) % 3, c = (a + 2) % 3;
  return normal[a] > 0 ? std::array{p[b], p[c]} : std::array{p[c], p[b]};
}

Vec3 SidePlane::lifted(double u, double v) const {
  const int a = dropped_axis(), b = (a + 1) % 3, c = (a + 2) % 3;
  Vec3 p;
  p[b] = normal[a] > 0 ? u : v;
  p[c] = normal[a] > 0 ? v : u;
  p[a] = axis >= 0 ? offset * normal[a] : (offset - normal[b] * p[b] - normal[c] * p[c]) / normal[a];
  return p;
}

bool SidePlanes::is_on(VertexId v, PlaneIndex plane) const {
  const auto all = of(v);
  return std::find(all.begin(), all.end(), plane) != all.end();
}

std::span<const PlaneIndex> SidePlanes::of(VertexId v) const {
  if (empty()) return {};
  const auto& all = of_vertex[v];
  const auto end = std::find(all.begin(), all.end(), kNoPlane);
  return {all.begin(), end};
}

Vec3 SidePlanes::within(VertexId v, const Vec3& d) const {
  const auto all = of(v);
  if (all.empty()) return d;
  const SidePlane& first = planes[all[0]];
  if (all.size() == 1) return first.within(d);
  if (all.size() > 2) return {};
  const SidePlane& second = planes[all[1]];
  if (first.axis >= 0 && second.axis >= 0) return without(without(d, first.axis), second.axis);
  Vec3 seam = cross(first.normal, second.normal);
  const double size = norm(seam);
  if (!(size > kParallel)) return first.within(d);
  // With an axis plane among the two that component is zero exactly.
  seam = seam / size;
  return seam * dot(seam, d);
}

Vec3 SidePlanes::direction_within(VertexId v, const Vec3& d) const {
  const Vec3 part = within(v, d);
  const double size = norm(part);
  return size > 0 ? part / size : Vec3();
}

}  // namespace nearwall::mesh
