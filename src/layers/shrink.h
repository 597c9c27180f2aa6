#pragma once

#include <array>
#include <vector>

#include "nearwall/certify/certificate.h"
#include "nearwall/geometry/box.h"
#include "vertex_field.h"

namespace nearwall::layers {

/// Lowers the vertices that a failed part of the certificate names. Each may be lowered so many times, then it is
/// blocked: so the loop of certify and shrink ends.
class Shrinker {
 public:
  Shrinker(const Wall& wall, const LinePlan& plan, VertexField& field)
      : wall_(wall),
        plan_(plan),
        front_(plan.front),
        field_(field),
        strikes_(field.thickness.size(), 0),
        factor_(strikes_.size(), 1.0) {}

  /// Each returns the vertices lowered, in increasing order.
  std::vector<VertexId> shrink(const mesh::Lines& lines, const std::vector<certify::BadColumn>& bad);
  std::vector<VertexId> shrink(const certify::FrontSurface& front,
                               const std::vector<std::pair<FrontFaceId, FrontFaceId>>& intersections);
  std::vector<VertexId> shrink(const certify::FrontSurface& front, const std::vector<ComponentId>& covered_twice,
                               const IdVector<FaceId, ComponentId>& face_component);
  /// All lines that move, where what failed names none of them: what a plane's trace has gone round stays where it is.
  std::vector<VertexId> shrink_all();

  /// From now on what fails is blocked at once.
  void lose_patience() { patience_ = 0; }

 private:
  using Corners = std::array<char, 3>;

  void mark(VertexId v, double factor);
  /// All corners but those that are far below the highest one.
  void mark(FrontFaceId f, double factor);
  /// The corners of a wall face that are to blame; all of it if none of these can be lowered or they were too often.
  void mark(FrontFaceId f, const Corners& to_blame, double factor);
  /// Those whose lines cross; none if that is not why the cell failed.
  Corners crossing_corners(FrontFaceId f) const;
  Corners bearing_corners_of(const certify::FrontSurface& front, FrontFaceId f, FrontFaceId other) const;
  bool can_be_lowered(FrontFaceId f) const;
  ComponentId component_under(FrontFaceId f, const IdVector<FaceId, ComponentId>& face_component) const;
  geometry::Box column_box(FrontFaceId f, const certify::FrontSurface& front) const;
  std::vector<VertexId> lower_marked(mesh::LimitReason why);

  const Wall& wall_;
  const LinePlan& plan_;
  const mesh::Front& front_;
  VertexField& field_;
  std::vector<int> strikes_;    // (n_vertices)
  std::vector<double> factor_;  // (n_vertices) 1: not marked
  std::vector<VertexId> marked_;
  // 0.75^40 = 1e-5. With 16, six of 220 real surfaces lost layers to it that they keep with 40, at the same time.
  int patience_ = 40;
};

}  // namespace nearwall::layers
