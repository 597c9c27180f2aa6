#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/mesh/topology.h"

namespace nearwall::surface {

/// The numbers are those of the output files (PointKind).
enum class PointKind : std::uint8_t { Smooth = 0, Ridge = 1, Corner = 2, RidgeEnd = 3, Tip = 4 };

struct FeatureOptions {
  double ridge_angle = 0.698131700797731837;  ///< turn from which an edge is a ridge [rad], (0, pi); default 40 degrees
  /// A ridge that bends by more than this at a vertex makes it a corner [rad]; default 45 degrees.
  double corner_angle = 0.785398163397448310;
  /// A vertex without ridges whose best normal sees its worst face under more than this is a tip [rad]; default 60
  /// degrees.
  double tip_angle = 1.047197551196597746;
};

/// Ridges and point kinds. Source: Aubry & Loehner 2008, section 2; docs/surface.md.
struct Features {
  IdVector<HalfedgeId, double>
      turn;  ///< (3 n_faces) signed turn of the edge [rad], the same for both halfedges; 0 on a boundary
  IdVector<HalfedgeId, char> is_ridge;  ///< (3 n_faces)
  IdVector<VertexId, PointKind> kind;   ///< (n_vertices)
  IdVector<FaceId, Vec3> face_normal;   ///< (n_faces) unit normals
  std::size_t n_convex = 0;             ///< ridges, counted once per edge
  std::size_t n_concave = 0;
};

/// \throws InputError if an angle of the options is out of range.    Cost: O(n_faces), on all threads.
Features find_features(const mesh::SurfaceMesh& surface, const mesh::Topology& topology,
                       const FeatureOptions& options = {});

/// Discrete patch of each face round v, in the order of topology.fan(v): 0, 1, … , faces between two ridges share one.
/// A closed vertex with fewer than two ridges has one patch; on a boundary, which separates like a ridge, every ridge
/// begins another patch.
std::vector<int> discrete_patches(const mesh::Topology& topology, const Features& features, VertexId v);

}  // namespace nearwall::surface
