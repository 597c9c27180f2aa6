#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "nearwall/core/progress.h"
#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::certify {

/// The certificate of a layer mesh, point by point (docs/theory/certificate.md). Conformity (2) holds by construction
/// and the embedded wall (3) by admission.
struct Certificate {
  std::uint64_t n_cells = 0;
  std::uint64_t n_not_positive = 0;         ///< (1) cells whose determinant is not positive everywhere
  std::uint64_t n_front_intersections = 0;  ///< (4) pairs of front triangles that meet
  std::uint64_t n_covered_twice = 0;        ///< (5) front components whose winding number is wrong
  double cells_volume = 0;                  ///< sum of the volumes of all cells
  double enclosed_volume = 0;               ///< between wall and front, from their triangles alone
  double front_volume = 0;                  ///< inside the front, absolute
  bool is_valid() const { return n_not_positive == 0 && n_front_intersections == 0 && n_covered_twice == 0; }
  /// | cells − enclosed | / front: a check of the program rather than of the mesh.
  double closure() const;
};

}  // namespace nearwall::certify
