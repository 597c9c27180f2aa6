#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nearwall/core/vec3.h"
#include "nearwall/volume/fill.h"
#include "volume/size_field.h"

namespace nearwall::volume {

/// What goes to the program nearwall-tetgen on its standard input.
struct TetgenProblem {
  FillBoundary boundary;
  std::vector<Vec3> holes;  ///< one inside each part that is no region; such as lie outside of everything do no harm
  std::vector<SizeSource> sizes;
  double slope = 0;
  double largest = 0;
};

void write_problem(int file, const TetgenProblem& problem);
TetgenProblem read_problem(int file);

/// The result goes back on its standard output.
void write_fill(int file, const Fill& fill);
Fill read_fill(int file);

/// How nearwall-tetgen ends where it does not crash.
enum class TetgenExit {
  Done = 0,
  OutOfMemory = 1,  ///< the first ones are TetGen's own codes
  Defect = 2,
  Crossing = 3,
  SmallFeature = 4,
  CloseFacets = 5,
  Input = 10,
  NothingInside = 20,  ///< no tetrahedra, and no word about it
  Endless = 22,        ///< the boundary could not be recovered in bounded work
  Unbounded = 23,      ///< it would refine for ever
  Exchange = 21,       ///< could not read or write
};

}  // namespace nearwall::volume
