#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "nearwall/geometry/angles.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/predicates/orientation.h"
#include "nearwall/studies/aubry_lohner.h"
#include "nearwall/surface/features.h"
#include "nearwall/surface/iterative_normals.h"
#include "nearwall/surface/point_normals.h"
#include "studies/repetitions.h"
#include "studies/stopwatch.h"

namespace nearwall::studies {

namespace {

using Directions = std::vector<Vec3>;

/// The neighbours of all points in one array, so that every kind of sweep reads the same memory.
struct Rings {
  std::vector<std::uint32_t> offset;  // (n_points + 1)
  std::vector<std::uint32_t> neighbour;

  explicit Rings(const mesh::Topology& topology) {
    offset.push_back(0);
    for (std::size_t v = 0; v < topology.n_vertices(); ++v) {
      for (const HalfedgeId h : topology.fan(VertexId(v))) neighbour.push_back(topology.target(h).index());
      offset.push_back(static_cast<std::uint32_t>(neighbour.size()));
    }
  }
  std::size_t n_points() const { return offset.size() - 1; }
  std::span<const std::uint32_t> of(std::size_t v) const {
    return {neighbour.data() + offset[v], neighbour.data() + offset[v + 1]};
  }
};

/// What the searches of all sweeps add up to.
struct Counts {
  std::size_t n_searches = 0, n_iterations = 0, n_not_converged = 0;
};

Vec3 unit(const Vec3& sum, const Vec3& otherwise) {
  const double size = norm(sum);
  return size > 0 ? sum / size : otherwise;
}

Vec3 mean_of(std::span<const Vec3> normals, const Vec3& otherwise) {
  Vec3 sum;
  for (const Vec3& n : normals) sum += n;
  return unit(sum, otherwise);
}

bool sees_well(const Vec3& direction, std::span<const Vec3> normals) {
  for (const Vec3& n : normals) {
    if (!(dot(direction, n) > surface::kVisibilityTrigger)) return false;
  }
  return true;
}

/// New normal of a point from a copy of its neighbours' normals and its own.
using Search = std::function<Vec3(std::span<const Vec3>, const Vec3& own, Counts&)>;

Vec3 direct_search(std::span<const Vec3> normals, const Vec3& own, Counts& counts) {
  ++counts.n_searches;
  const auto best = surface::most_visible_normal(normals);
  return best ? best->direction : mean_of(normals, own);
}

Vec3 triggered_search(std::span<const Vec3> normals, const Vec3& own, Counts& counts) {
  const Vec3 mean = mean_of(normals, own);
  return sees_well(mean, normals) ? mean : direct_search(normals, own, counts);
}

Search iterative_search(const std::optional<double>& relaxation) {
  return [options = surface::IterationOptions{.relaxation = relaxation}](std::span<const Vec3> normals, const Vec3& own,
                                                                         Counts& counts) {
    const surface::IterativeNormal found = surface::iterative_normal(normals, options);
    ++counts.n_searches;
    counts.n_iterations += static_cast<std::size_t>(found.n_iterations);
    counts.n_not_converged += found.has_converged ? 0 : 1;
    return found.direction != Vec3() ? found.direction : own;
  };
}

/// Sweeps that differ in one thing only: `of_point(v, from)`, the new normal of a point.
template <class OfPoint>
void sweep_all(std::size_t n_points, Directions& from, Directions& to, const OfPoint& of_point) {
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t v = 0; v < n_points; ++v) to[v] = of_point(v, from);
    std::swap(from, to);
  }
}

/// A kind of sweep: does all sweeps over `from`, which has the result then.
struct Kind {
  SweepKind kind;
  std::function<Counts(const Rings&, Directions& from, Directions& to)> run;
  bool is_slow = false;       ///< measured once
  bool is_iterative = false;  ///< has iterations to tell of
};

Kind plain_kind() {
  return {SweepKind::Plain, [](const Rings& rings, Directions& from, Directions& to) {
            sweep_all(rings.n_points(), from, to, [&](std::size_t v, const Directions& normals) {
              Vec3 sum;
              for (const std::uint32_t w : rings.of(v)) sum += normals[w];
              return unit(sum, normals[v]);
            });
            return Counts();
          }};
}

Kind kind_of(SweepKind kind, const Search& search, bool is_iterative) {
  const auto run = [search](const Rings& rings, Directions& from, Directions& to) {
    Counts counts;
    std::vector<Vec3> copies;
    sweep_all(rings.n_points(), from, to, [&](std::size_t v, const Directions& normals) {
      copies.clear();
      for (const std::uint32_t w : rings.of(v)) copies.push_back(normals[w]);
      return search(copies, normals[v], counts);
    });
    return counts;
  };
  return {kind, run, is_iterative, is_iterative};
}

/// Reads and writes what a sweep does, with hardly anything in between.
Kind stream_kind() {
  return {SweepKind::Streaming, [](const Rings& rings, Directions& from, Directions& to) {
            std::uint32_t sum = 0;
            sweep_all(rings.n_points(), from, to, [&](std::size_t v, const Directions& normals) {
              for (const std::uint32_t w : rings.of(v)) sum += w;
              return normals[v];
            });
            // Something must depend on what was read, or the compiler leaves the reading out.
            [[maybe_unused]] const volatile std::uint32_t read = sum;
            return Counts();
          }};
}

/// Fills in how well the normals see the faces; those without area do not count.
void judge(const Directions& normals, const mesh::Topology& topology, const surface::Features& features,
           SweepResult& result) {
  double edge_sum = 0;
  std::size_t n_edge = 0;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    double worst = 0;
    bool is_blind = false;
    for (const HalfedgeId h : topology.fan(VertexId(v))) {
      const Vec3& face = features.face_normal[mesh::Topology::face(h)];
      if (face == Vec3()) continue;
      worst = std::max(worst, geometry::angle_between(normals[v], face));
      is_blind = is_blind || predicates::sign_of_dot(face, normals[v]) != predicates::Sign::Positive;
    }
    result.worst_angle_deg = std::max(result.worst_angle_deg, geometry::to_degrees(worst));
    if (is_blind) ++result.n_blind;
    if (features.kind[VertexId(v)] != surface::PointKind::Smooth) edge_sum += geometry::to_degrees(worst), ++n_edge;
  }
  result.edge_angle_deg = edge_sum / static_cast<double>(std::max<std::size_t>(n_edge, 1));
}

SweepResult result_of(const Kind& kind, const Counts& counts, std::size_t n_points) {
  const auto n_searches = static_cast<double>(counts.n_searches);
  const double none = std::nan("");
  return {.kind = kind.kind,
          .direct_percent = 100 * n_searches / static_cast<double>(kSweeps * n_points),
          .mean_iterations = kind.is_iterative ? static_cast<double>(counts.n_iterations) / n_searches : none,
          .not_converged_percent =
              kind.is_iterative ? 100 * static_cast<double>(counts.n_not_converged) / n_searches : none};
}

}  // namespace

std::vector<SweepResult> compare_sweeps(const mesh::SurfaceMesh& surface, const AubryLohnerOptions& options,
                                        ProgressSink& progress) {
  check_repetitions("aubry-lohner", options.repetitions);
  const mesh::Topology topology(surface);
  const surface::Features features = surface::find_features(surface, topology);
  Directions start;
  for (const auto& n : surface::point_normals(surface, topology, features)) start.push_back(n.direction);
  const Rings rings(topology);

  const std::vector<Kind> kinds = {stream_kind(),
                                   plain_kind(),
                                   kind_of(SweepKind::Direct, direct_search, false),
                                   kind_of(SweepKind::Triggered, triggered_search, false),
                                   kind_of(SweepKind::IterativeFull, iterative_search(1.0), true),
                                   kind_of(SweepKind::IterativeHalf, iterative_search(0.5), true),
                                   kind_of(SweepKind::IterativeChosen, iterative_search(std::nullopt), true)};
  std::vector<SweepResult> results(kinds.size());
  std::vector<std::vector<double>> seconds(kinds.size());
  // All kinds by turns: what slows the machine for a while slows them all.
  for (int repetition = 0; repetition < options.repetitions; ++repetition) {
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      progress.update(static_cast<double>(repetition) / options.repetitions);
      if (repetition > 0 && kinds[i].is_slow) continue;
      Directions normals = start, other = start;
      Counts counts;
      seconds[i].push_back(seconds_of([&] { counts = kinds[i].run(rings, normals, other); }));
      if (repetition > 0) continue;
      results[i] = result_of(kinds[i], counts, rings.n_points());
      judge(normals, topology, features, results[i]);
    }
  }
  for (std::size_t i = 0; i < kinds.size(); ++i) results[i].seconds = median(seconds[i]);
  return results;
}

}  // namespace nearwall::studies
