#pragma once

#include "nearwall/mesh/front.h"

namespace nearwall::mesh {

/// Some faces of a front as a front of its own: with the vertices they stand on, each with all of its lines, numbered
/// anew in the order in which they are taken over. Memory: O(lines of the whole front). The whole must outlive it.
class FrontPart {
 public:
  explicit FrontPart(const Front& whole);

  /// Takes a face over; wall faces before virtual ones.
  void add(FrontFaceId face);
  /// Whether all vertices of a face have been taken over.
  bool has_vertices_of(FrontFaceId face) const;

  const Front& front() const { return front_; }
  /// Line of the whole front that a line of the part is: (n_lines of the part).
  const IdVector<LineId, LineId>& original_line() const { return original_line_; }
  /// Vertex of the wall that a vertex of the part is.
  VertexId original_vertex(VertexId v) const { return whole_.line_vertex[original_line_[front_.line_of(v)]]; }

 private:
  LineId take(LineId line);

  const Front& whole_;
  Front front_;
  IdVector<LineId, LineId> original_line_;
  IdVector<LineId, LineId> number_;  // in the part, (n_lines of the whole)
};

}  // namespace nearwall::mesh
