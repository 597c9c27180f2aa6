#pragma once

#include <vector>

#include "nearwall/mesh/front.h"
#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/mesh/limit_reason.h"
#include "nearwall/mesh/lines.h"
#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::quality {

/// A square of side 2 in the plane z = 0 cut along the diagonal from (0, 0) to (2, 2): one patch, two triangles of
/// area 2.
inline mesh::SurfaceMesh square_plate() {
  mesh::SurfaceMesh m;
  m.points = IdVector<VertexId, Vec3>(std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  const auto v = [](int i) { return VertexId(static_cast<std::size_t>(i)); };
  m.faces.push_back({v(0), v(1), v(2)});
  m.faces.push_back({v(0), v(2), v(3)});
  m.face_patch = IdVector<FaceId, PatchId>(2, PatchId(0));
  m.patch_names.push_back("plate");
  return m;
}

/// Layers of the heights 1, 2, 4 straight up from the plate.
struct PlateLayers {
  mesh::SurfaceMesh wall = square_plate();
  mesh::Front front = mesh::plain_front(wall);
  mesh::Lines lines = straight_up();
  IdVector<LineId, double> asked_thickness{4, 7.0};
  IdVector<LineId, double> reached_thickness{4, 7.0};
  IdVector<LineId, mesh::LimitReason> reason{4, mesh::LimitReason::None};

  mesh::Lines straight_up() const {
    mesh::Lines l;
    l.table = mesh::HeightTable({{0, 1, 3, 7}});
    l.first_piece.push_back(0);
    for (const Vec3& p : wall.points) {
      l.base.push_back(p);
      l.pieces.push_back({{0, 0, 1}, 0});
      l.first_piece.push_back(static_cast<std::uint32_t>(l.pieces.size()));
      l.heights.push_back({});
      l.windows.push_back({0, 3});
    }
    return l;
  }

  /// Ends a line early, as growing would.
  void limit(std::size_t line, Level end, mesh::LimitReason why) {
    lines.windows[LineId(line)] = {0, end};
    reached_thickness[LineId(line)] = lines.height(LineId(line), end);
    reason[LineId(line)] = why;
  }
};

}  // namespace nearwall::quality
