// The program nearwall-tetgen: reads a problem from standard input, runs TetGen once, writes the tetrahedra to standard
// output and what TetGen says to standard error. See volume/tetgen_exchange.h.

#include <dlfcn.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

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

namespace {

/// Calls of orient3d and incircle3d that TetGen may make for each point of the boundary before it begins to refine. It
/// needs 30 to 250, and where it goes round in circles while it recovers an edge it would make them for ever.
constexpr std::uint64_t kCallsPerPoint = 5000;
std::uint64_t calls_left = 0;
bool is_refining = false;

using Orient3d = double (*)(double*, double*, double*, double*);
using Incircle3d = double (*)(tetgenmesh*, double*, double*, double*, double*);

/// Ends the program from within TetGen, which cannot be left in another way. What it says is the parent's to tell.
[[noreturn]] void give_up(nearwall::volume::TetgenExit exit, const char* words) {
  fmt::print(stderr, "{}\n", words);
  _exit(static_cast<int>(exit));
}

void count_call() {
  if (is_refining || calls_left-- > 0) return;
  give_up(nearwall::volume::TetgenExit::Endless, "it goes round in circles");
}

}  // namespace

/// In the place of the library's own, too: on points of one circle in a plane along no axis its flips need not end.
double tetgenmesh::incircle3d(double* p, double* q, double* r, double* s) {
  static const auto original =
      reinterpret_cast<Incircle3d>(::dlsym(RTLD_NEXT, "_ZN10tetgenmesh10incircle3dEPdS0_S0_S0_"));
  count_call();
  return original(this, p, q, r, s);
}

/// In the place of the library's own, which it calls: the sign that nearly all of TetGen's decisions ask for.
double orient3d(double* a, double* b, double* c, double* d) {
  static const auto original = reinterpret_cast<Orient3d>(::dlsym(RTLD_NEXT, "_Z8orient3dPdS_S_S_"));
  count_call();
  return original(a, b, c, d);
}

namespace nearwall::volume {
namespace {

/// Circumradius over wanted edge from which a tetrahedron is split: the edges of the refined mesh then have the wanted
/// length in the median. Measured: docs/theory/fill.md.
constexpr double kLargestRadius = 0.8;
/// Radius over shortest edge from which TetGen itself splits (the switch q), with a guard against doing so for ever.
constexpr double kLargestRatio = 2;

/// p: facets are given; Y: their triangles stay; q: radius over shortest edge at most 2; o/140: faces are swapped and
/// points moved and added where a dihedral angle is over 140 degrees; Q: no talk but of errors. Measured: docs/theory/
/// fill.md.
constexpr const char* kSwitches = "pYqo/140T1e-16Q";

const SizeField* wanted_sizes = nullptr;

/// Questions that TetGen may ask for each triangle of the boundary, times the slope of sizes. It asks 1.3 for each
/// tetrahedron it makes, and makes 1 to 3 over the slope for each triangle, 50 over the slope at most in what was
/// tried; at some sharp corners of the boundary its own rule of radius over edge has no end.
constexpr double kQuestions = 600;
std::uint64_t questions_left = 0;

Vec3 vec3(const double* p) { return {p[0], p[1], p[2]}; }

double shortest_edge(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double squared = std::min({squared_norm(a), squared_norm(b), squared_norm(c), squared_norm(a - b),
                                   squared_norm(b - c), squared_norm(c - a)});
  return std::sqrt(squared);
}

/// TetGen's question whether a tetrahedron shall be split. One with a short edge is left to the switch q: at sharp
/// angles of the boundary circumcentres lie beyond it, and to split for size alone would have no end.
bool is_too_large(double* pa, double* pb, double* pc, double* pd, double*, double) {
  is_refining = true;
  if (questions_left-- == 0) {
    give_up(TetgenExit::Unbounded, "it refines without end");
  }
  const Vec3 d = vec3(pd), a = vec3(pa) - d, b = vec3(pb) - d, c = vec3(pc) - d;
  const Vec3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  // |circumcentre − d| = |numerator| / (2 a·(b × c))
  const Vec3 numerator = squared_norm(a) * bc + squared_norm(b) * ca + squared_norm(c) * ab;
  const double radius = 0.5 * norm(numerator) / std::abs(dot(a, bc));
  if (radius > kLargestRatio * shortest_edge(a, b, c)) return false;
  return wanted_sizes->is_under(d + (a + b + c) * 0.25, radius / kLargestRadius);
}

/// Points as they are numbered in one attempt: a step through them that meets each once. TetGen's recovery of the
/// boundary depends on the order, and where it goes round in circles for one it does not for another.
class Order {
 public:
  Order(std::size_t n, int attempt) : n_(n), step_(attempt == 0 ? 1 : n / static_cast<std::size_t>(attempt + 2) + 1) {
    while (std::gcd(step_, n) != 1) ++step_;
    inverse_.resize(n);
    for (std::size_t i = 0; i < n; ++i) inverse_[theirs(i)] = static_cast<std::uint32_t>(i);
  }
  std::size_t theirs(std::size_t ours) const { return ours * step_ % n_; }
  std::uint32_t ours(std::size_t theirs) const {
    return theirs < n_ ? inverse_[theirs] : static_cast<std::uint32_t>(theirs);
  }

 private:
  std::size_t n_, step_;
  std::vector<std::uint32_t> inverse_;
};

void give(tetgenio& io, const TetgenProblem& problem, const Order& order) {
  const auto& [points, triangles] = problem.boundary;
  io.numberofpoints = static_cast<int>(points.size());
  io.pointlist = new double[3 * points.size()];
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) io.pointlist[3 * order.theirs(i) + axis] = points[i][axis];
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
    for (int k = 0; k < 3; ++k) facet.polygonlist[0].vertexlist[k] = static_cast<int>(order.theirs(triangles[f][k]));
    io.facetmarkerlist[f] = static_cast<int>(f) + 1;
  }
  io.numberofholes = static_cast<int>(problem.holes.size());
  io.holelist = new double[3 * problem.holes.size()];
  for (std::size_t i = 0; i < problem.holes.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) io.holelist[3 * i + axis] = problem.holes[i][axis];
  }
  io.tetunsuitable = is_too_large;
}

Fill take(const tetgenio& io, const Order& order) {
  Fill fill;
  fill.points.resize(static_cast<std::size_t>(io.numberofpoints));
  for (std::size_t i = 0; i < fill.points.size(); ++i) fill.points[order.ours(i)] = vec3(io.pointlist + 3 * i);
  fill.tetrahedra.resize(static_cast<std::size_t>(io.numberoftetrahedra));
  for (std::size_t t = 0; t < fill.tetrahedra.size(); ++t) {
    const int* v = io.tetrahedronlist + 4 * t;
    for (std::size_t k = 0; k < 4; ++k) fill.tetrahedra[t][k] = order.ours(static_cast<std::size_t>(v[k]));
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

TetgenExit fill_once(int attempt) {
  const int output = output_without_talk();
  const TetgenProblem problem = read_problem(STDIN_FILENO);
  const SizeField sizes(problem.sizes, problem.slope, problem.largest);
  wanted_sizes = &sizes;
  tetgenio in, out;
  const Order order(problem.boundary.points.size(), attempt);
  give(in, problem, order);
  const double n_triangles = static_cast<double>(problem.boundary.triangles.size());
  questions_left = static_cast<std::uint64_t>(kQuestions / problem.slope * n_triangles);
  calls_left = kCallsPerPoint * problem.boundary.points.size();
  std::string switches = kSwitches;
  tetrahedralize(switches.data(), &in, &out);
  if (out.numberoftetrahedra == 0) return TetgenExit::NothingInside;
  write_fill(output, take(out, order));
  return TetgenExit::Done;
}

}  // namespace
}  // namespace nearwall::volume

int main(int argc, char** argv) {
  using namespace nearwall::volume;
  if (argc != 3) return static_cast<int>(TetgenExit::Exchange);
  live_with_parent(std::atoi(argv[1]));
  try {
    return static_cast<int>(fill_once(std::atoi(argv[2])));
  } catch (const std::bad_alloc&) {
    return static_cast<int>(TetgenExit::OutOfMemory);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(TetgenExit::Exchange);
  }
}
