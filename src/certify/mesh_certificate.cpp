#include "nearwall/certify/mesh_certificate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "certify/mesh_boundary.h"
#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/box.h"
#include "nearwall/geometry/measures.h"

namespace nearwall::certify {

namespace {

using mesh::FaceNodes;
using mesh::size_of;

constexpr std::size_t kBlock = 4096;

/// Pairs of boundary faces from which on no more are looked for: a mesh of which no points were made one has some
/// dozens for each face.
constexpr std::size_t kMaxPairs = 1'000'000;

std::uint64_t sum(const std::array<std::uint64_t, mesh::kNCellTypes>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

/// Sums over [0, n) in blocks, joined in order: the same bits at any number of threads.
template <class Term>
double block_sum(std::size_t n, Term&& term) {
  std::vector<double> by_block((n + kBlock - 1) / kBlock);
  parallel_blocks(n, kBlock, [&](std::size_t begin, std::size_t end) {
    geometry::CompensatedSum part;
    for (std::size_t i = begin; i < end; ++i) part.add(term(i));
    by_block[begin / kBlock] = part.value();
  });
  geometry::CompensatedSum all;
  for (const double v : by_block) all.add(v);
  return all.value();
}

/// Twelve times the volume of the cone from a point over a triangle or bilinear patch: docs/theory/cells.md, Eq. (4).
double twelve_cones(std::span<const Vec3> points, const FaceNodes& face, const Vec3& tip) {
  const auto det = [](const Vec3& a, const Vec3& b, const Vec3& c) { return dot(cross(a, b), c); };
  const Vec3 a = points[face[0]] - tip, b = points[face[1]] - tip, c = points[face[2]] - tip;
  if (size_of(face) == 3) return 2 * det(a, b, c);
  const Vec3 d = points[face[3]] - tip;
  return (det(a, b, c) + det(a, c, d)) + (det(a, b, d) + det(b, c, d));
}

geometry::Box box_of(std::span<const Vec3> points, std::span<const FaceNodes> faces) {
  geometry::Box box;
  for (const FaceNodes& face : faces) {
    for (int k = 0; k < size_of(face); ++k) box.include(points[face[static_cast<std::size_t>(k)]]);
  }
  return box;
}

void measure(const mesh::VolumeMesh& mesh, std::span<const FaceNodes> boundary, MeshCertificate& result) {
  const Vec3 centre = box_of(mesh.points, boundary).centre();
  const auto cone = [&](std::size_t i) { return twelve_cones(mesh.points, boundary[i], centre) / 12; };
  result.cells_volume =
      block_sum(mesh.n_cells(), [&](std::size_t i) { return mesh::cell_volume(mesh.type[i], mesh.corners_of(i)); });
  result.enclosed_volume = block_sum(boundary.size(), cone);
  result.summed_volume = block_sum(boundary.size(), [&](std::size_t i) { return std::abs(cone(i)); });
}

bool are_finite(std::span<const Vec3> points, const FaceNodes& face) {
  return std::all_of(face.begin(), face.begin() + size_of(face),
                     [&](std::uint32_t node) { return is_finite(points[node]); });
}

/// Points 4 and 5.
void look_at_boundary(const mesh::VolumeMesh& mesh, std::span<const FaceNodes> boundary, MeshCertificate& result) {
  const bool is_finite_boundary = std::all_of(boundary.begin(), boundary.end(),
                                              [&](const FaceNodes& face) { return are_finite(mesh.points, face); });
  if (!is_finite_boundary) return;
  const search::PatchTree tree({mesh.points, boundary});
  result.intersections = tree.intersections(kMaxPairs);
  if (!result.intersections->meeting.empty() || !result.intersections->undecided.empty()) {
    result.n_coincident_points = count_coincident_points(mesh.points, boundary);
    return;
  }
  if (!result.closes()) return;
  const Covers covers = count_covers(tree, boundary_parts(boundary));
  result.n_undecided_parts = covers.n_undecided;
  result.covered_twice.emplace();
  for (const std::uint32_t face : covers.twice) result.covered_twice->push_back(result.faces.boundary[face]);
}

}  // namespace

std::uint64_t MeshCertificate::n_cells() const { return sum(cells.count); }
std::uint64_t MeshCertificate::n_not_positive() const { return sum(cells.not_positive); }
std::uint64_t MeshCertificate::n_undecided() const { return sum(cells.undecided); }

bool MeshCertificate::closes() const {
  return std::none_of(faces.nonconforming.begin(), faces.nonconforming.end(), [](const NonconformingFace& f) {
    return f.fault == FaceFault::ManyCells || f.fault == FaceFault::SameSide || f.fault == FaceFault::RepeatedNode;
  });
}

std::optional<double> MeshCertificate::closure() const {
  if (!closes() || !(summed_volume > 0)) return std::nullopt;
  return std::abs(cells_volume - enclosed_volume) / summed_volume;
}

bool MeshCertificate::is_valid() const {
  return !faces.boundary.empty() && cells.offenders.empty() && faces.nonconforming.empty() && intersections &&
         intersections->is_complete && intersections->meeting.empty() && intersections->undecided.empty() &&
         covered_twice && covered_twice->empty() && n_undecided_parts == 0;
}

MeshCertificate certify_mesh(const mesh::VolumeMesh& mesh, ProgressSink& progress) {
  if (mesh.n_cells() == 0) {
    throw InputError("expected tetrahedra, pyramids, wedges or hexahedra to certify, found no cell of these");
  }
  const auto stage = [&](const char* name, auto&& work) {
    progress.begin_stage(name);
    work();
    progress.end_stage();
  };
  MeshCertificate result;
  stage("cells", [&] { result.cells = cell_verdicts(mesh); });
  stage("faces", [&] { result.faces = conformity(mesh); });
  stage("boundary", [&] {
    const std::vector<FaceNodes> boundary = boundary_corners(mesh, result.faces);
    measure(mesh, boundary, result);
    progress.update(0.5);
    look_at_boundary(mesh, boundary, result);
  });
  return result;
}

}  // namespace nearwall::certify
