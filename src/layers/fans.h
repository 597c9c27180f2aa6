#pragma once

#include <vector>

#include "cut_wall.h"

namespace nearwall::layers {

/// The directions of the lines that stand at one end of a cut edge, from the face on its left to the one on its right.
struct Fan {
  HalfedgeId edge;              ///< leaves the vertex that the lines stand on
  std::vector<Vec3> direction;  ///< unit vectors, two or more; the first and the last are those of the two groups
};

/// Fans of all cut edges at the vertices that have several groups: at each end of the edge, of as many lines as at the
/// other, so many all along a ridge that no two neighbours turn by more than `max_turn`.
/// Source: docs/theory/fans.md.
class Fans {
 public:
  /// \param normal  (n_copies) directions of the groups
  Fans(const Wall& wall, const CutWall& cut, const IdVector<VertexId, Vec3>& normal, double max_turn);

  /// The fan at the beginning of h; none where h is not cut or all faces round that vertex are one group.
  const Fan* at(HalfedgeId h) const { return number_.empty() || number_[h] == kNone ? nullptr : &fans_[number_[h]]; }
  /// The other cut edge at the beginning of h where just two cuts meet: one set of lines serves both. Invalid
  /// elsewhere.
  HalfedgeId onwards(HalfedgeId h) const;
  /// Vertices round which no fan turns the right way at some edge, exactly: their lines cannot leave the wall.
  const std::vector<VertexId>& twisted() const { return twisted_; }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  void count_lines(double max_turn);
  void lay(Fan& fan, std::size_t n_lines);
  bool turns_along_edges(const Fan& fan) const;

  const Wall& wall_;
  const CutWall& cut_;
  const IdVector<VertexId, Vec3>& normal_;
  std::vector<Fan> fans_;
  IdVector<HalfedgeId, std::uint32_t> number_;  // of the fan, (3 n_faces) or empty
  std::vector<std::size_t> n_lines_;            // (n_fans)
  std::vector<VertexId> twisted_;
};

}  // namespace nearwall::layers
