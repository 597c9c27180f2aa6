#include "io/surface_builder.h"

#include <fmt/format.h>

#include <limits>

#include "io/triangulate.h"

namespace nearwall::io {
namespace {

/// Ids have 32 bits, and halfedge 3 f + k must have one.
constexpr std::size_t kMostPoints = std::numeric_limits<std::uint32_t>::max() - 1;
constexpr std::size_t kMostFaces = std::numeric_limits<std::uint32_t>::max() / 3 - 1;

}  // namespace

void SurfaceBuilder::reserve(std::size_t n_points, std::size_t n_faces) {
  mesh_.points.reserve(n_points);
  mesh_.faces.reserve(n_faces);
  mesh_.face_patch.reserve(n_faces);
}

VertexId SurfaceBuilder::add_point(const Vec3& point, const FilePosition& where) {
  if (!is_finite(point)) fail_at(where, "expected finite coordinates, found a NaN or an infinity");
  if (mesh_.points.size() >= kMostPoints) fail_at(where, fmt::format("more than {} points", kMostPoints));
  return mesh_.points.push_back(point);
}

void SurfaceBuilder::begin_patch(std::string_view name) {
  const auto found = patch_of_name_.find(name);
  if (found != patch_of_name_.end()) {
    patch_ = found->second;
  } else {
    patch_ = mesh_.patch_names.push_back(std::string(name));
    patch_of_name_.emplace(name, patch_);
  }
}

void SurfaceBuilder::add_triangle(const std::array<VertexId, 3>& corners, const FilePosition& where) {
  if (mesh_.faces.size() >= kMostFaces) fail_at(where, fmt::format("more than {} triangles", kMostFaces));
  if (!patch_.is_valid()) begin_patch(kNamelessPatch);
  mesh_.faces.push_back(corners);
  mesh_.face_patch.push_back(patch_);
}

void SurfaceBuilder::add_face(std::span<const std::int64_t> corners, const FilePosition& where) {
  if (corners.size() < 3) fail_at(where, fmt::format("expected a face of 3 corners or more, found {}", corners.size()));
  if (corners.size() > kMostCorners) {
    fail_at(where, fmt::format("a face of {} corners; up to {} can be triangulated", corners.size(), kMostCorners));
  }
  for (const std::int64_t corner : corners) {
    if (corner < 0 || static_cast<std::uint64_t>(corner) >= n_points()) {
      fail_at(where, fmt::format("a face uses point {} (counted from 0), but there are {} points", corner, n_points()));
    }
  }
  const auto id = [&](std::size_t i) { return VertexId(static_cast<std::size_t>(corners[i])); };
  if (corners.size() == 3) return add_triangle({id(0), id(1), id(2)}, where);

  polygon_.clear();
  triangles_.clear();
  for (std::size_t i = 0; i < corners.size(); ++i) polygon_.push_back(mesh_.points[id(i)]);
  triangulate(polygon_, triangles_);
  for (const auto& t : triangles_) add_triangle({id(t[0]), id(t[1]), id(t[2])}, where);
}

void SurfaceBuilder::assign_patches(std::span<const std::int64_t> numbers, std::span<const std::string> names) {
  std::map<std::int64_t, PatchId> patch_of_number;
  for (const std::int64_t number : numbers) patch_of_number.emplace(number, PatchId());
  mesh_.patch_names.clear();
  patch_of_name_.clear();
  for (auto& [number, patch] : patch_of_number) {
    const bool has_name = number >= 0 && static_cast<std::uint64_t>(number) < names.size();
    begin_patch(has_name ? names[static_cast<std::size_t>(number)] : fmt::format("patch{}", number));
    patch = patch_;
  }
  for (const FaceId f : mesh_.face_patch.ids()) mesh_.face_patch[f] = patch_of_number.at(numbers[f.index()]);
}

mesh::SurfaceMesh SurfaceBuilder::finish(const FilePosition& where) {
  if (mesh_.faces.empty()) fail_at(where, "the file holds no triangle");
  IdVector<PatchId, char> used(mesh_.patch_names.size(), 0);
  for (const PatchId patch : mesh_.face_patch) used[patch] = 1;
  IdVector<PatchId, PatchId> new_patch(used.size());
  IdVector<PatchId, std::string> names;
  for (const PatchId patch : used.ids()) {
    if (used[patch]) new_patch[patch] = names.push_back(std::move(mesh_.patch_names[patch]));
  }
  for (PatchId& patch : mesh_.face_patch) patch = new_patch[patch];
  mesh_.patch_names = std::move(names);
  return std::move(mesh_);
}

}  // namespace nearwall::io
