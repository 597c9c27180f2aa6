#pragma once

#include <cstddef>
#include <vector>

#include "nearwall/volume/fill.h"

namespace nearwall::benchmarks {

/// What docs/theory/fill.md says of fills.
struct FillFigures {
  std::size_t n_tetrahedra = 0, n_added_points = 0;
  struct Spread {
    double least = 0, p01 = 0, median = 0, p99 = 0, most = 0;
  };
  Spread edge_over_wanted;    ///< of edges that are not of the boundary: length over the wanted one at the middle
  Spread least_dihedral;      ///< [deg] of each tetrahedron
  std::size_t n_slivers = 0;  ///< with a dihedral angle under 10 degrees
  Spread radius_edge;         ///< circumradius over shortest edge
  Spread jump;                ///< cube root of the volumes of two neighbours, beyond the growth of the wanted size
};

FillFigures measure_fill(const volume::FillBoundary& boundary, const volume::FillOptions& options,
                         const volume::Fill& fill);

}  // namespace nearwall::benchmarks
