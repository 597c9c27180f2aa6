#pragma once

#include <optional>
#include <span>
#include <vector>

#include "nearwall/core/parallel.h"
#include "nearwall/surface/point_normals.h"
#include "surface/corner_weight.h"
#include "surface/face_normals.h"

namespace nearwall::surface {

/// What the normals of one surface are made from.
struct FanSource {
  /// \throws InputError if an option is out of range
  FanSource(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, const Features& features,
            const NormalOptions& options);

  const mesh::SurfaceMesh& surface;
  const mesh::Topology& topology;
  const Features& features;
  NormalOptions options;
  std::vector<char> is_left_out;  ///< (n_faces) faces that weighted means pass over; empty: none
  double scale = 1;               ///< power of two that brings the surface's extent near 1
};

/// Normals of one vertex after the other, from the faces round it alone, with room that is used again.
class FanNormals {
 public:
  explicit FanNormals(const FanSource& source)
      : source_(source), weight_(weight_of(source.options.method)), face_normals_(source.features) {}

  /// Normal of v for a run of the faces round it.
  /// \param faces  halfedges that leave v, one for each face, counterclockwise without a gap
  PointNormal of(VertexId v, std::span<const HalfedgeId> faces);

  /// Weighted mean of the run's face normals, a unit vector; that of the first face where they cancel, zero without
  /// any face.
  Vec3 mean(Weight weight, VertexId v, std::span<const HalfedgeId> faces);

  /// `direction` as the normal of a vertex with these faces.
  PointNormal judge(const Vec3& direction, std::span<const HalfedgeId> faces);

 private:
  /// Calls `body(normal, corner)` for each face of the run that has an area; `corner()` measures its corner at v.
  template <class Body>
  void for_each_face(VertexId v, std::span<const HalfedgeId> faces, const Body& body) const;
  Vec3 weighted_sum(Weight weight, VertexId v, std::span<const HalfedgeId> faces) const;
  Vec3 weighted_sum_of_suitable(Weight weight, VertexId v, std::span<const HalfedgeId> faces) const;
  bool is_left_out(HalfedgeId h) const;
  bool drops_unsuitable(VertexId v) const;
  PointNormal optimal(VertexId v, std::span<const HalfedgeId> faces);
  PointNormal kallinderis(VertexId v, std::span<const HalfedgeId> faces);
  std::optional<NormalNormal> most_normal(VertexId v, std::span<const HalfedgeId> faces);
  PointNormal most_visible_or(const Vec3& direction, std::span<const Vec3> normals, bool is_fallback) const;

  const FanSource& source_;
  std::optional<Weight> weight_;  // of the method, if it is a weighted mean
  FaceNormals face_normals_;
  std::vector<Vec3> ring_;
};

/// Calls `body(v, fans)` for each vertex, in blocks on all threads, with a `FanNormals` for each block.
template <class Body>
void for_each_vertex(const FanSource& source, const Body& body) {
  parallel_blocks(source.surface.points.size(), kVertexBlock, [&](std::size_t begin, std::size_t end) {
    FanNormals fans(source);
    for (std::size_t i = begin; i < end; ++i) body(VertexId(i), fans);
  });
}

}  // namespace nearwall::surface
