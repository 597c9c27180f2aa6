#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nearwall/core/errors.h"
#include "nearwall/core/progress.h"
#include "nearwall/core/vec3.h"

namespace nearwall::volume {

/// Closed surface round the region to be filled: one component or many (far field, fronts of bodies, vessels). Each
/// triangle is counterclockwise seen from outside the region, so normals point out of it: away from the fluid.
struct FillBoundary {
  std::vector<Vec3> points;                             ///< (n_points) each a corner of some triangle
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< (n_triangles) indices into points
};

struct FillOptions {
  /// Largest wanted edge at x: the least, over the points p of the boundary, of the mean length of the edges at p plus
  /// (growth − 1) |x − p|. > 1; from 1.1 (slow) to 2. Source: docs/theory/fill.md, Eq. (1).
  double growth = 1.3;
  std::optional<double> largest;  ///< no larger than this [length], > 0; the edges of the boundary stay as they are
};

struct Fill {
  std::vector<Vec3> points;                              ///< the boundary's first, bit for bit, then added ones
  std::vector<std::array<std::uint32_t, 4>> tetrahedra;  ///< in the order of predicates/cells.h, all exactly positive
};

/// The region cannot be filled.
class FillFailed : public BackendError {
 public:
  FillFailed(const std::string& what, std::vector<std::uint32_t> concerned)
      : BackendError(what), triangles(std::move(concerned)) {}
  std::vector<std::uint32_t> triangles;  ///< of the boundary: those concerned, sorted; empty if it is not known which
};

/// Tetrahedra that fill the region, by TetGen in a process of its own (the program nearwall-tetgen). The triangles of
/// the boundary are kept, all of them; which parts are holes is found here. The result is checked exactly: every
/// tetrahedron is positive, and the faces that belong to one tetrahedron alone are the triangles of the boundary. The
/// same bits for the same input, whatever ran before.
/// \param progress  no stage is begun; `update` is called some times a second, and may throw Interrupted, which ends
///                  the process
/// \throws InputError  an option out of its range, a coordinate that is not finite, or an index out of range
/// \throws FillFailed  the boundary is open, crosses itself, does not bound a region, or TetGen fails on it
/// \throws BackendError  the program is missing, crashed or was killed
/// Cost: 3 to 12 s a million tetrahedra (docs/theory/fill.md). Source: docs/theory/fill.md; si2015.
Fill fill_with_tetgen(const FillBoundary& boundary, const FillOptions& options = {},
                      ProgressSink& progress = silent_progress());

}  // namespace nearwall::volume
