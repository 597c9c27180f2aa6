#include <algorithm>
#include <cmath>

#include "nearwall/predicates/orientation.h"
#include "search/patch.h"
#include "search/triangle_pairs.h"

// Rules and proofs: docs/theory/certificate.md, "Quads".

namespace nearwall::search {

namespace {

using predicates::orientation;
using predicates::Sign;

/// Nodes that two patches have in common: their places in the first and in the second.
struct Shared {
  std::array<int, 4> in_a{}, in_b{};
  int count = 0;

  Shared(const Patch& a, const Patch& b) {
    for (int i = 0; i < a.size(); ++i) {
      for (int j = 0; j < b.size(); ++j) {
        if (a.node(i) != b.node(j)) continue;
        in_a[static_cast<std::size_t>(count)] = i;
        in_b[static_cast<std::size_t>(count++)] = j;
        break;
      }
    }
  }
  bool has_in_a(int i) const { return std::find(in_a.begin(), in_a.begin() + count, i) != in_a.begin() + count; }
  bool has_in_b(int j) const { return std::find(in_b.begin(), in_b.begin() + count, j) != in_b.begin() + count; }
};

Vec3 without(const Vec3& v, const Vec3& direction) { return v - direction * dot(v, direction); }

/// Any vector across m, about as long.
Vec3 across(const Vec3& m) {
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(m[k]) < std::abs(m[axis])) axis = k;
  }
  Vec3 e;
  e[axis] = 1;
  return cross(m, e);
}

/// Whether a plane through what they share has the rest of each strictly on its own side. The plane is a guess that
/// suits neighbours on a surface; what it tells is exact, and no sign near zero has to be computed.
bool are_parted_by_a_plane(const Patch& a, const Patch& b, const Shared& shared) {
  std::array<Vec3, 3> plane;
  const Vec3 ca = a.middle(), cb = b.middle();
  if (shared.count == 2) {
    const Vec3 &p = a.point(shared.in_a[0]), &q = a.point(shared.in_a[1]);
    const Vec3 edge = normalized(q - p);
    const Vec3 m = normalized(without(ca - p, edge)) - normalized(without(cb - p, edge));
    plane = {p, q, p + cross(edge, m) * distance(p, q)};
  } else {
    const Vec3 p = shared.count == 1 ? a.point(shared.in_a[0]) : (ca + cb) * 0.5;
    const Vec3 m = normalized(normalized(ca - p) - normalized(cb - p));
    const Vec3 u = across(m);
    const double size = distance(ca, cb);
    plane = {p, p + u * size, p + cross(m, u) * size};
  }
  const auto side = [&](const Vec3& x) { return orientation(plane[0], plane[1], plane[2], x); };
  Sign side_a = Sign::Zero;
  for (int i = 0; i < a.size(); ++i) {
    if (shared.has_in_a(i)) continue;
    const Sign s = side(a.point(i));
    if (s == Sign::Zero || (side_a != Sign::Zero && s != side_a)) return false;
    side_a = s;
  }
  for (int j = 0; j < b.size(); ++j) {
    if (shared.has_in_b(j)) continue;
    const Sign s = side(b.point(j));
    if (s == Sign::Zero || s == side_a) return false;
  }
  return true;
}

/// What a patch has of the straight segment between two of its corners.
enum class Segment { Edge, InPlane, OffPatch };

Segment segment_between(const Patch& p, int i, int j) {
  if (p.size() == 3 || std::abs(i - j) != 2) return Segment::Edge;
  return p.is_warped() ? Segment::OffPatch : Segment::InPlane;
}

/// Two patches that share two nodes: whether the segment between these lies in both, but not as an edge of both.
bool share_more_than_an_edge(const Patch& a, const Patch& b, const Shared& s) {
  const Segment in_a = segment_between(a, s.in_a[0], s.in_a[1]), in_b = segment_between(b, s.in_b[0], s.in_b[1]);
  return in_a != Segment::OffPatch && in_b != Segment::OffPatch &&
         (in_a == Segment::InPlane || in_b == Segment::InPlane);
}

/// The corner of a quad that two edges join to other shared corners, of the three that are shared.
int middle_of_three(const std::array<int, 4>& places) {
  const int missing = 6 - places[0] - places[1] - places[2];  // of 0 + 1 + 2 + 3
  return (missing + 2) % 4;
}

/// Two quads of which each has a diagonal across the same triangle, or a triangle and such a quad.
PatchContact contact_over_three(const Patch& a, const Patch& b, const Shared& s) {
  if (a.size() == 3 && b.size() == 3) return PatchContact::Meeting;
  if (a.size() == 3 || b.size() == 3) {
    return (a.is_warped() || b.is_warped()) ? PatchContact::Apart : PatchContact::Meeting;
  }
  if (!a.is_warped() && !b.is_warped()) return PatchContact::Meeting;
  if (a.is_warped() && b.is_warped()) {
    const auto side = [&](const Patch& p, const std::array<int, 4>& places) {
      return orientation(a.point(s.in_a[0]), a.point(s.in_a[1]), a.point(s.in_a[2]),
                         p.point(6 - places[0] - places[1] - places[2]));
    };
    return side(a, s.in_a) == side(b, s.in_b) ? PatchContact::Undecided : PatchContact::Apart;
  }
  // The warped one meets the plane of the other in two edges at its middle corner; both are edges of the planar one if
  // it has the same middle corner.
  return a.node(middle_of_three(s.in_a)) == b.node(middle_of_three(s.in_b)) ? PatchContact::Apart
                                                                            : PatchContact::Meeting;
}

/// Whether the hulls (of what is not warped: itself) meet in more than the hull of the shared nodes. Exact.
bool hulls_meet(const Patch& a, const Patch& b, const Shared& shared) {
  for (int i = 0; i < a.n_triangles(); ++i) {
    for (int j = 0; j < b.n_triangles(); ++j) {
      if (triangles_meet(a.points(), a.triangle_nodes(i), b.triangle_nodes(j))) return true;
    }
  }
  for (int i = 0; b.is_warped() && i < a.size(); ++i) {
    if (!shared.has_in_a(i) && b.hull_contains(a.point(i))) return true;
  }
  for (int j = 0; a.is_warped() && j < b.size(); ++j) {
    if (!shared.has_in_b(j) && a.hull_contains(b.point(j))) return true;
  }
  return false;
}

/// Whether an edge of `edges` that has no shared node surely crosses `other`.
template <class IsShared>
bool an_edge_crosses(const Patch& edges, const Patch& other, IsShared&& is_shared) {
  for (int i = 0; i < edges.size(); ++i) {
    const int j = (i + 1) % edges.size();
    if (!is_shared(i) && !is_shared(j) && other.is_surely_crossed(edges.point(i), edges.point(j))) return true;
  }
  return false;
}

}  // namespace

PatchContact contact(const Patch& a, const Patch& b) {
  if (a.size() == 3 && b.size() == 3) {
    return triangles_meet(a.points(), a.triangle_nodes(0), b.triangle_nodes(0)) ? PatchContact::Meeting
                                                                                : PatchContact::Apart;
  }
  const Shared shared(a, b);
  if (shared.count == 4) return PatchContact::Meeting;
  if (shared.count == 3) return contact_over_three(a, b, shared);
  if (shared.count == 2 && share_more_than_an_edge(a, b, shared)) return PatchContact::Meeting;
  if (are_parted_by_a_plane(a, b, shared)) return PatchContact::Apart;
  if (!hulls_meet(a, b, shared)) return PatchContact::Apart;
  if (!a.is_warped() && !b.is_warped()) return PatchContact::Meeting;
  const bool is_crossed = an_edge_crosses(a, b, [&](int i) { return shared.has_in_a(i); }) ||
                          an_edge_crosses(b, a, [&](int j) { return shared.has_in_b(j); });
  if (is_crossed) return PatchContact::Meeting;
  const bool are_apart = shared.count == 0 && are_surely_apart(a.corners(), b.corners());
  return are_apart ? PatchContact::Apart : PatchContact::Undecided;
}

}  // namespace nearwall::search
