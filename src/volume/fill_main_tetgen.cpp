// The program nearwall-tetgen: reads a problem from standard input, runs TetGen once, writes the tetrahedra to standard
// output and what TetGen says to standard error. See volume/tetgen_exchange.h.

#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "nearwall/core/vec3.h"
#include "volume/memory_file.h"
#include "volume/size_field.h"
#include "volume/tetgen_exchange.h"

// TetGen defines how it gives up inline, and frees memory that it uses afterwards: ours takes its place.
#define terminatetetgen terminate_of_tetgen
#include <tetgen.h>
#undef terminatetetgen

void terminatetetgen(tetgenmesh*, int code) {
  std::fflush(nullptr);
  _exit(code);
}

namespace nearwall::volume {
namespace {

/// Circumradius over wanted edge from which a tetrahedron is split: edges of the refined mesh then have the wanted
/// length in the median. Measured: docs/theory/fill.md.
constexpr double kLargestRadius = 0.75;

const SizeField* wanted_sizes = nullptr;

Vec3 vec3(const double* p) { return {p[0], p[1], p[2]}; }

/// TetGen's question whether a tetrahedron shall be split.
bool is_too_large(double* pa, double* pb, double* pc, double* pd, double*, double) {
  const Vec3 d = vec3(pd), a = vec3(pa) - d, b = vec3(pb) - d, c = vec3(pc) - d;
  const double size = wanted_sizes->at(d + (a + b + c) * 0.25);
  const Vec3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  // |circumcentre − d| = |numerator| / (2 a·(b × c))
  const Vec3 numerator = squared_norm(a) * bc + squared_norm(b) * ca + squared_norm(c) * ab;
  return norm(numerator) > 2 * kLargestRadius * size * std::abs(dot(a, bc));
}

void give(tetgenio& io, const TetgenProblem& problem) {
  const auto& [points, triangles] = problem.boundary;
  io.numberofpoints = static_cast<int>(points.size());
  io.pointlist = new double[3 * points.size()];
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) io.pointlist[3 * i + axis] = points[i][axis];
  }
  io.numberoffacets = static_cast<int>(triangles.size());
  io.facetlist = new tetgenio::facet[triangles.size()];
  io.facetmarkerlist = new int[triangles.size()];
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    tetgenio::facet& facet = io.facetlist[f];
    tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = new tetgenio::polygon[1];
    facet.polygonlist[0].numberofvertices = 3;
    facet.polygonlist[0].vertexlist = new int[3];
    for (int k = 0; k < 3; ++k) facet.polygonlist[0].vertexlist[k] = static_cast<int>(triangles[f][k]);
    io.facetmarkerlist[f] = static_cast<int>(f) + 1;
  }
  io.numberofholes = static_cast<int>(problem.holes.size());
  io.holelist = new double[3 * problem.holes.size()];
  for (std::size_t i = 0; i < problem.holes.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) io.holelist[3 * i + axis] = problem.holes[i][axis];
  }
  io.tetunsuitable = is_too_large;
}

Fill take(const tetgenio& io) {
  Fill fill;
  fill.points.resize(static_cast<std::size_t>(io.numberofpoints));
  for (std::size_t i = 0; i < fill.points.size(); ++i) fill.points[i] = vec3(io.pointlist + 3 * i);
  fill.tetrahedra.resize(static_cast<std::size_t>(io.numberoftetrahedra));
  for (std::size_t t = 0; t < fill.tetrahedra.size(); ++t) {
    const int* v = io.tetrahedronlist + 4 * t;
    for (std::size_t k = 0; k < 4; ++k) fill.tetrahedra[t][k] = static_cast<std::uint32_t>(v[k]);
  }
  return fill;
}

/// Not left behind by a parent that is killed; and Ctrl-C is the parent's business.
void live_with_parent(int parent) {
  ::signal(SIGINT, SIG_IGN);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) _exit(static_cast<int>(TetgenExit::Exchange));
}

/// Standard output is for the result alone, but TetGen talks on it: that goes to standard error.
int output_without_talk() {
  const int output = ::dup(STDOUT_FILENO);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
  return output;
}

TetgenExit fill_once() {
  const int output = output_without_talk();
  const TetgenProblem problem = read_problem(STDIN_FILENO);
  const SizeField sizes(problem.sizes, problem.slope, problem.largest);
  wanted_sizes = &sizes;
  tetgenio in, out;
  give(in, problem);
  std::string switches = "pYqQ";
  tetrahedralize(switches.data(), &in, &out);
  if (out.numberoftetrahedra == 0) return TetgenExit::NothingInside;
  write_fill(output, take(out));
  return TetgenExit::Done;
}

}  // namespace
}  // namespace nearwall::volume

int main(int argc, char** argv) {
  using namespace nearwall::volume;
  if (argc == 2) live_with_parent(std::atoi(argv[1]));
  try {
    return static_cast<int>(fill_once());
  } catch (const std::bad_alloc&) {
    return static_cast<int>(TetgenExit::OutOfMemory);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(TetgenExit::Exchange);
  }
}
