#include "nearwall/volume/fill.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "nearwall/core/helper_process.h"
#include "volume/boundary_check.h"
#include "volume/fill_check.h"
#include "volume/hole_points.h"
#include "volume/memory_file.h"
#include "volume/tetgen_exchange.h"

namespace nearwall::volume {

namespace {

constexpr std::string_view kHelper = "nearwall-tetgen";

void check_options(const FillOptions& options) {
  constexpr double kLargestGrowth = 10;  // neighbours would no longer be of one order of magnitude
  if (!(options.growth > 1 && options.growth <= kLargestGrowth)) {
    throw InputError(fmt::format("growth of the tetrahedra is {}: over 1 and at most {} is expected", options.growth,
                                 kLargestGrowth));
  }
  if (options.largest && !(*options.largest > 0)) {
    throw InputError(fmt::format("the largest tetrahedron is {}: a length over 0 is expected", *options.largest));
  }
}

/// TetGen counts points and corners in int.
void check_counts(const FillBoundary& boundary) {
  constexpr std::size_t kMost = std::numeric_limits<int>::max() / 4;
  if (boundary.points.size() > kMost || boundary.triangles.size() > kMost) {
    throw InputError(fmt::format("the boundary to be filled has {} triangles: at most {} can be given to TetGen",
                                 boundary.triangles.size(), kMost));
  }
}

/// Waits for the end, with a sign of life now and then: how far TetGen is cannot be known, so the fraction nears 1 ever
/// more slowly, and is at a half after the time that such boundaries take in the mean.
void wait_for(HelperProcess& helper, std::size_t n_triangles, ProgressSink& progress) {
  constexpr std::chrono::milliseconds kInterval{100};
  constexpr double kSecondsPerTriangle = 1e-4, kSecondsAtLeast = 0.1;
  const double forecast = kSecondsAtLeast + kSecondsPerTriangle * static_cast<double>(n_triangles);
  const auto start = std::chrono::steady_clock::now();
  while (!helper.wait(kInterval)) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    progress.update(seconds / (seconds + forecast));
  }
}

std::string_view reason(int exit_code) {
  switch (static_cast<TetgenExit>(exit_code)) {
    case TetgenExit::OutOfMemory:
      return "there is not enough memory";
    case TetgenExit::Crossing:
      return "triangles of the boundary cross each other as far as it can tell: they are too close together";
    case TetgenExit::SmallFeature:
      return "the boundary has details too small beside its extent";
    case TetgenExit::CloseFacets:
      return "triangles of the boundary lie too close together";
    case TetgenExit::NothingInside:
      return "it found nothing inside the boundary";
    default:
      return "it gave up";
  }
}

[[noreturn]] void explain_failure(const FillBoundary&, const HelperProcess& helper) {
  const std::string words = helper.last_words();
  if (WIFSIGNALED(helper.status())) {
    throw BackendError(fmt::format("TetGen ended with signal {}: {}", WTERMSIG(helper.status()), words));
  }
  const int code = WEXITSTATUS(helper.status());
  throw FillFailed(fmt::format("TetGen cannot fill the region: {} ({}; code {})", reason(code), words, code), {});
}

Fill run_tetgen(const TetgenProblem& problem, ProgressSink& progress) {
  const auto program = find_helper(kHelper);
  if (program.empty()) {
    throw BackendError(fmt::format("the program {} is not beside this one: tetrahedra cannot be made", kHelper));
  }
  const MemoryFile input("nearwall-fill-problem"), output("nearwall-fill");
  write_problem(input.descriptor(), problem);
  input.rewind();
  HelperProcess helper(program, {std::to_string(::getpid())}, {input.descriptor(), output.descriptor()});
  if (!helper.has_started()) throw BackendError(fmt::format("{} cannot be started", program.string()));
  wait_for(helper, problem.boundary.triangles.size(), progress);
  if (helper.status() != 0) explain_failure(problem.boundary, helper);
  output.rewind();
  return read_fill(output.descriptor());
}

}  // namespace

Fill fill_with_tetgen(const FillBoundary& boundary, const FillOptions& options, ProgressSink& progress) {
  check_options(options);
  check_counts(boundary);
  check_boundary(boundary);
  progress.update(0);
  TetgenProblem problem;
  problem.boundary = boundary;
  problem.holes = hole_points(boundary);
  problem.sizes = sizes_of_edges(boundary.points, boundary.triangles);
  problem.slope = options.growth - 1;
  problem.largest = options.largest.value_or(std::numeric_limits<double>::infinity());
  Fill fill = run_tetgen(problem, progress);
  check_fill(boundary, fill);
  return fill;
}

}  // namespace nearwall::volume
