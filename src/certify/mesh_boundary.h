#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nearwall/certify/mesh_certificate.h"

namespace nearwall::certify {

/// The boundary of a mesh as patches, seen counterclockwise from outside.
std::vector<mesh::FaceNodes> boundary_corners(const mesh::VolumeMesh& mesh, const Conformity& faces);

/// Points at which another node of these faces lies, bit for bit: how many nodes are there too often.
std::uint64_t count_coincident_points(std::span<const Vec3> points, std::span<const mesh::FaceNodes> faces);

/// Part of the boundary that each face belongs to: faces that are the only two at an edge belong to one. Parts are
/// numbered in the order of their first faces.
std::vector<std::uint32_t> boundary_parts(std::span<const mesh::FaceNodes> faces);

/// Point 5. \param part  as boundary_parts gives it
struct Covers {
  std::vector<std::uint32_t> twice;  ///< the first face of each part behind which points are covered more than once
  std::uint64_t n_undecided = 0;     ///< parts of which no face could be looked behind
};

Covers count_covers(const search::PatchTree& tree, std::span<const std::uint32_t> part);

}  // namespace nearwall::certify
