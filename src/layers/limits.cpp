#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "nearwall/core/parallel.h"
#include "vertex_field.h"

namespace nearwall::layers {

namespace {

using mesh::LimitReason;

/// Share of the closed-form limit that a line may use: the rest is room for the heights of single layers and for cells
/// that are still well shaped at the top.
constexpr double kCurvatureShare = 0.7;

/// Lowering one line changes the limits of its neighbours: a few sweeps settle nearly all; the certificate the rest.
constexpr int kCurvatureSweeps = 4;

/// Smallest t > 0 at which a + b t + c t² falls to zero, given a > 0; infinity if it never does.
double first_root(double a, double b, double c) {
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return std::numeric_limits<double>::infinity();
  // The numerically stable pair: q has the sign of -b, so nothing cancels.
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  const double t1 = q != 0 ? a / q : std::numeric_limits<double>::infinity();
  const double t2 = c != 0 ? q / c : std::numeric_limits<double>::infinity();
  double first = std::numeric_limits<double>::infinity();
  if (t1 > 0) first = std::min(first, t1);
  if (t2 > 0) first = std::min(first, t2);
  return first;
}

/// Largest t, at most infinity, up to which the wedge swept from the triangle x by x_k + t v_k is positive everywhere;
/// 0 if it is not even at its start. Source: docs/theory/cells.md, thick wedge.
double swept_limit(const std::array<Vec3, 3>& x, const std::array<Vec3, 3>& v) {
  const Vec3 e1 = x[1] - x[0], e2 = x[2] - x[0], g1 = v[1] - v[0], g2 = v[2] - v[0];
  const Vec3 c0 = cross(e1, e2), c1 = cross(e1, g2) + cross(g1, e2), c2 = cross(g1, g2);
  double limit = std::numeric_limits<double>::infinity();
  for (const Vec3& h : v) {
    if (squared_norm(h) == 0) continue;  // a line that stays does not sweep
    const double a = dot(c0, h);
    if (!(a > 0)) return 0;
    limit = std::min(limit, first_root(a, dot(c1, h), dot(c2, h)));
  }
  return limit;
}

/// Which share of each of its lines a triangle lets stand. Where two lines cross, the third one keeps its length if the
/// swept wedge stays positive with those two lowered: on a long triangle that ends at a narrow place, the far one.
std::array<double, 3> shares_kept(const std::array<Vec3, 3>& x, const std::array<Vec3, 3>& v) {
  const double all = kCurvatureShare * swept_limit(x, v);
  // A face without orientation from the start says nothing of heights: the certificate will judge it.
  if (!(all < 1) || all == 0) return {1.0, 1.0, 1.0};
  std::array<double, 3> shares = {all, all, all};
  double most_room = 1;
  for (std::size_t far = 0; far < 3; ++far) {
    std::array<Vec3, 3> lowered = {v[0] * all, v[1] * all, v[2] * all};
    lowered[far] = v[far];
    const double room = kCurvatureShare * swept_limit(x, lowered);
    if (room < most_room) continue;
    shares = {all, all, all};
    shares[far] = 1;
    most_room = room;
  }
  return shares;
}

}  // namespace

std::vector<VertexId> limit_by_curvature(const Wall& wall, const LinePlan& plan, VertexField& field) {
  const std::size_t n_faces = wall.surface.faces.size();
  std::vector<std::array<double, 3>> share(n_faces);
  std::vector<double> kept(field.thickness.size());
  std::vector<char> is_lowered(field.thickness.size(), 0);
  for (int sweep = 0; sweep < kCurvatureSweeps; ++sweep) {
    parallel_for(n_faces, [&](std::size_t i) {
      const FaceId f(i);
      std::array<Vec3, 3> v;
      for (std::size_t k = 0; k < 3; ++k) {
        const LineId line = plan.front.faces[FrontFaceId(i)].lines[k];
        v[k] = plan.direction[line] * (plan.stretch[line] * field.thickness[wall.surface.faces[f][k]]);
      }
      share[i] = shares_kept(wall.surface.triangle(f), v);
    });
    // The least share of the faces round a vertex, all of this sweep: shares must not multiply within one.
    std::fill(kept.begin(), kept.end(), 1.0);
    for (std::size_t i = 0; i < n_faces; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        double& least = kept[wall.surface.faces[FaceId(i)][k].index()];
        least = std::min(least, share[i][k]);
      }
    }
    bool any = false;
    for (const VertexId v : field.thickness.ids()) {
      if (kept[v.index()] == 1.0) continue;
      if (!field.lower(v, kept[v.index()] * field.thickness[v], LimitReason::Curvature)) continue;
      is_lowered[v.index()] = 1;
      any = true;
    }
    if (!any) break;
  }
  std::vector<VertexId> lowered;
  for (std::size_t v = 0; v < is_lowered.size(); ++v) {
    if (is_lowered[v]) lowered.push_back(VertexId(v));
  }
  return lowered;
}

}  // namespace nearwall::layers
