#include "nearwall/volume/fill.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <limits>
#include <regex>
#include <string>
#include <utility>
#include <variant>

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

/// Signs of life while TetGen runs: how far it is cannot be known, so the fraction nears 1 ever more slowly, and is at
/// a half after the time that such boundaries take in the mean.
class Forecast {
 public:
  explicit Forecast(std::size_t n_triangles)
      : seconds_(kSecondsAtLeast + kSecondsPerTriangle * static_cast<double>(n_triangles)) {}
  double fraction() const {
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    return elapsed / (elapsed + seconds_);
  }

 private:
  static constexpr double kSecondsPerTriangle = 1e-4, kSecondsAtLeast = 0.1;
  double seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

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
    case TetgenExit::Endless:
      return "edges of the boundary could not be recovered, in whatever order: they may be too close together";
    case TetgenExit::Unbounded:
      return "at some corner of the boundary it would go on refining for ever: look for sharp angles between patches "
             "without layers, planes and fronts";
    case TetgenExit::NothingInside:
      return "it found nothing inside the boundary";
    default:
      return "it gave up";
  }
}

/// How one run ended that gave nothing.
struct Failure {
  int status = 0;  ///< as of waitpid
  std::string last_words;
  std::vector<std::uint32_t> triangles;  ///< that TetGen named
};

/// TetGen names triangles and edges by their points, as in "1st: [3, 17, 4] #2": the triangles that have them all.
std::vector<std::uint32_t> triangles_named(const std::string& words, const FillBoundary& boundary) {
  static const std::regex group(R"([\[(](\d+), *(\d+)(?:, *(\d+))?[\])])");
  std::vector<std::uint32_t> named;
  for (std::sregex_iterator it(words.begin(), words.end(), group), end; it != end; ++it) {
    std::vector<std::uint32_t> points;
    for (std::size_t k = 1; k < it->size(); ++k) {
      if ((*it)[k].matched) points.push_back(static_cast<std::uint32_t>(std::stoul((*it)[k])));
    }
    for (std::size_t f = 0; f < boundary.triangles.size(); ++f) {
      const auto& t = boundary.triangles[f];
      const auto has = [&t](std::uint32_t p) { return std::find(t.begin(), t.end(), p) != t.end(); };
      if (std::all_of(points.begin(), points.end(), has)) named.push_back(static_cast<std::uint32_t>(f));
    }
  }
  std::sort(named.begin(), named.end());
  named.erase(std::unique(named.begin(), named.end()), named.end());
  return named;
}

[[noreturn]] void report(const Failure& failure) {
  if (WIFSIGNALED(failure.status)) {
    const int signal = WTERMSIG(failure.status);
    throw BackendError(fmt::format("TetGen {} (signal {}){}{}", signal == SIGKILL ? "was killed" : "crashed", signal,
                                   failure.last_words.empty() ? "" : ": ", failure.last_words));
  }
  const int code = WEXITSTATUS(failure.status);
  throw FillFailed(
      fmt::format("TetGen cannot fill the region: {} ({}; code {})", reason(code), failure.last_words, code),
      failure.triangles);
}

/// Whether another order of the points may help: TetGen crashes or gives up on some orders only.
bool is_worth_another(const Failure& failure) {
  if (WIFSIGNALED(failure.status)) return WTERMSIG(failure.status) != SIGKILL;
  const auto exit = static_cast<TetgenExit>(WEXITSTATUS(failure.status));
  return exit != TetgenExit::OutOfMemory && exit != TetgenExit::Unbounded && exit != TetgenExit::Exchange &&
         exit != TetgenExit::NothingInside;
}

/// One run of TetGen with the points in one order.
class TetgenRuns {
 public:
  TetgenRuns(const TetgenProblem& problem, ProgressSink& progress)
      : program_(find_helper(kHelper)),
        problem_(problem),
        progress_(progress),
        forecast_(problem.boundary.triangles.size()) {
    if (program_.empty()) {
      throw BackendError(fmt::format("the program {} is not beside this one: tetrahedra cannot be made", kHelper));
    }
  }

  std::variant<Fill, Failure> run(int attempt) const {
    constexpr std::chrono::milliseconds kInterval{100};
    const MemoryFile input("nearwall-fill-problem"), output("nearwall-fill");
    write_problem(input.descriptor(), problem_);
    input.rewind();
    HelperProcess helper(program_, {std::to_string(::getpid()), std::to_string(attempt)},
                         {input.descriptor(), output.descriptor()});
    if (!helper.has_started()) throw BackendError(fmt::format("{} cannot be started", program_.string()));
    while (!helper.wait(kInterval)) progress_.update(forecast_.fraction());
    if (helper.status() != 0) {
      // Points are numbered as here in the first attempt alone.
      auto named = attempt == 0 ? triangles_named(helper.talk(), problem_.boundary) : std::vector<std::uint32_t>();
      return Failure{helper.status(), helper.last_words(), std::move(named)};
    }
    output.rewind();
    return read_fill(output.descriptor());
  }

 private:
  std::filesystem::path program_;
  const TetgenProblem& problem_;
  ProgressSink& progress_;
  Forecast forecast_;
};

/// \throws what the first attempt ended with, if none of them gives a fill that stands the check
Fill first_good_fill(const TetgenProblem& problem, ProgressSink& progress) {
  constexpr int kAttempts = 8;
  const TetgenRuns runs(problem, progress);
  std::exception_ptr first;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    auto result = runs.run(attempt);
    try {
      if (const auto* failure = std::get_if<Failure>(&result)) {
        if (!is_worth_another(*failure)) attempt = kAttempts;
        report(*failure);
      }
      check_fill(problem.boundary, std::get<Fill>(result));
      return std::move(std::get<Fill>(result));
    } catch (const BackendError&) {
      if (!first) first = std::current_exception();
    }
  }
  std::rethrow_exception(first);
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
  return first_good_fill(problem, progress);
}

}  // namespace nearwall::volume
