#pragma once

#include <optional>
#include <span>
#include <vector>

#include "nearwall/surface/point_normals.h"
#include "surface/corner_weight.h"

namespace nearwall::surface {

/// Normals of one vertex after the other, from the faces round it alone, with room that is used again.
class FanNormals {
 public:
  /// \param is_left_out  (n_faces) faces that weighted means pass over; empty: none
  FanNormals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, const Features& features,
             const NormalOptions& options, const std::vector<char>& is_left_out)
      : surface_(surface),
        topology_(topology),
        features_(features),
        options_(options),
        is_left_out_(is_left_out),
        weight_(weight_of(options.method)) {}

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
  void gather(std::span<const HalfedgeId> faces);
  PointNormal optimal(VertexId v, std::span<const HalfedgeId> faces);
  std::optional<NormalNormal> most_normal(VertexId v, std::span<const HalfedgeId> faces);
  PointNormal answer_or_most_visible(const std::optional<VisibleNormal>& answer, VertexId v,
                                     std::span<const HalfedgeId> faces);
  PointNormal most_visible_or(const Vec3& direction, bool is_fallback);

  const mesh::SurfaceMesh& surface_;
  const mesh::Topology& topology_;
  const Features& features_;
  const NormalOptions& options_;
  const std::vector<char>& is_left_out_;
  std::optional<Weight> weight_;  // of the method, if it is a weighted mean
  std::vector<Vec3> ring_;
  std::vector<Vec3> room_;
  std::span<const Vec3> normals_;  // of the run's faces with an area, in room_
};

}  // namespace nearwall::surface
