#include "nearwall/studies/aubry_lohner.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/studies/plot.h"
#include "nearwall/surface/features.h"
#include "nearwall/surface/point_normals.h"
#include "nearwall/surface/smoothing.h"
#include "studies/repetitions.h"
#include "studies/scenes.h"
#include "studies/stopwatch.h"

namespace nearwall::studies {

namespace {

constexpr double kMillion = 1e6;

/// A body, ready for normals.
struct Body {
  explicit Body(const Scene& scene)
      : surface(scene.mesh), topology(surface), features(surface::find_features(surface, topology)) {}

  double n_points() const { return static_cast<double>(surface.points.size()); }

  const mesh::SurfaceMesh& surface;
  mesh::Topology topology;
  surface::Features features;
};

Table body_table(const std::vector<Scene>& scenes) {
  Table table{.title = "Bodies",
              .row_title = "body",
              .columns = {"points", "convex ridge edges", "concave ridge edges", "points on ridges, %", "corners"}};
  for (const Scene& scene : scenes) {
    const Body body(scene);
    const auto& kind = body.features.kind;
    const auto n_smooth = std::count(kind.begin(), kind.end(), surface::PointKind::Smooth);
    const auto n_corners = std::count(kind.begin(), kind.end(), surface::PointKind::Corner);
    table.rows.push_back(
        {fmt::format("{}: {}", scene.name, scene.contents),
         {body.n_points(), static_cast<double>(body.features.n_convex), static_cast<double>(body.features.n_concave),
          100 * (1 - static_cast<double>(n_smooth) / body.n_points()), static_cast<double>(n_corners)}});
  }
  return table;
}

const SweepResult& result_of(SweepKind kind, const std::vector<SweepResult>& results) {
  const auto at = std::find_if(results.begin(), results.end(), [&](const SweepResult& r) { return r.kind == kind; });
  expect(at != results.end(), "every kind of sweep has a result");
  return *at;
}

std::string name_of(SweepKind kind) { return std::string(kSweepNames[static_cast<std::size_t>(kind)]); }

Table sweep_table(const Scene& scene, const std::vector<SweepResult>& results) {
  Table table{.title = fmt::format("Five sweeps over \"{}\"", scene.name),
              .row_title = "sweep",
              .columns = {"seconds", "over plain", "million points/s", "searched, %", "iterations", "not converged, %",
                          "worst angle, °", "blind points", "mean angle at ridges, °"}};
  const double plain = result_of(SweepKind::Plain, results).seconds;
  const auto n = static_cast<double>(scene.mesh.points.size()) * kSweeps;
  for (const SweepResult& r : results) {
    table.rows.push_back(
        {name_of(r.kind),
         {r.seconds, r.seconds / plain, n / r.seconds / kMillion, r.direct_percent, r.mean_iterations,
          r.not_converged_percent, r.worst_angle_deg, static_cast<double>(r.n_blind), r.edge_angle_deg}});
  }
  return table;
}

struct Smoothing {
  std::string name;
  surface::SmoothingOptions options;
};

std::vector<Smoothing> smoothings() {
  // A whole step to the neighbours, as in the paper.
  const surface::SmoothingOptions whole{.iterations = kSweeps, .lambda = 1};
  auto laplacian = whole, direct = whole, triggered = whole, iterative = whole;
  laplacian.filter = surface::SmoothingFilter::Laplacian;
  triggered.filter = direct.filter = iterative.filter = surface::SmoothingFilter::MostVisible;
  direct.trigger = iterative.trigger = 1;
  iterative.search = surface::SearchMethod::Iterative;
  return {{"plain", laplacian}, {"direct", direct}, {"triggered", triggered}, {"iterative, β chosen", iterative}};
}

/// Worst and mean visibility angle [degrees] and number of blind points.
std::array<double, 3> quality(const IdVector<VertexId, surface::PointNormal>& normals) {
  double worst = 0, sum = 0, n_blind = 0;
  for (const surface::PointNormal& n : normals) {
    worst = std::max(worst, geometry::to_degrees(n.max_angle));
    sum += geometry::to_degrees(n.max_angle);
    n_blind += n.is_visible ? 0 : 1;
  }
  return {worst, sum / static_cast<double>(normals.size()), n_blind};
}

Table library_table(const Scene& scene, int repetitions, ProgressSink& progress) {
  const Body body(scene);
  const auto start = surface::point_normals(body.surface, body.topology, body.features);
  Table table{
      .title =
          fmt::format("The same by smooth_normals on \"{}\": ridges and corners held, no point loses sight; λ = 1, "
                      "preparation included",
                      scene.name),
      .row_title = "filter",
      .columns = {"seconds", "over plain", "million points/s", "worst angle, °", "mean angle, °", "blind points"}};
  const auto all = smoothings();
  std::vector<std::vector<double>> seconds(all.size());
  std::vector<std::array<double, 3>> qualities(all.size());
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      progress.update(static_cast<double>(repetition) / repetitions);
      auto normals = start;
      seconds[i].push_back(seconds_of(
          [&] { surface::smooth_normals(body.surface, body.topology, body.features, all[i].options, normals); }));
      qualities[i] = quality(normals);
    }
  }
  const double plain = median(seconds[0]);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double s = median(seconds[i]);
    const auto& [worst, mean, n_blind] = qualities[i];
    table.rows.push_back({all[i].name, {s, s / plain, kSweeps * body.n_points() / s / kMillion, worst, mean, n_blind}});
  }
  return table;
}

Table face_table(const Scene& scene, int repetitions, ProgressSink& progress) {
  using surface::NormalMethod;
  const Body body(scene);
  Table table{.title = fmt::format("Normals from the faces of \"{}\"", scene.name),
              .row_title = "method",
              .columns = {"seconds", "million points/s", "worst angle, °", "mean angle, °", "blind points"}};
  for (const NormalMethod method :
       {NormalMethod::Uniform, NormalMethod::Angle, NormalMethod::Max, NormalMethod::MostVisible,
        NormalMethod::MostNormal, NormalMethod::Kallinderis, NormalMethod::Iterative, NormalMethod::Pirzadeh}) {
    std::vector<double> seconds;
    IdVector<VertexId, surface::PointNormal> normals;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
      progress.update(static_cast<double>(repetition) / repetitions);
      seconds.push_back(seconds_of(
          [&] { normals = surface::point_normals(body.surface, body.topology, body.features, {.method = method}); }));
    }
    const auto& [worst, mean, n_blind] = quality(normals);
    table.rows.push_back({std::string(surface::method_name(method)),
                          {median(seconds), body.n_points() / median(seconds) / kMillion, worst, mean, n_blind}});
  }
  return table;
}

/// What the paper measured; NaN where it did not.
struct PaperTime {
  SweepKind kind;
  double seconds;  ///< of five sweeps
};
constexpr double kPaperPoints = 121'000;
constexpr std::array<PaperTime, 5> kPaperTimes = {{{SweepKind::Streaming, std::numeric_limits<double>::quiet_NaN()},
                                                   {SweepKind::Plain, 1},
                                                   {SweepKind::Triggered, 3},
                                                   {SweepKind::Direct, 8},
                                                   {SweepKind::IterativeFull, 14}}};

Picture rate_plot(const std::vector<Scene>& scenes, const std::vector<std::vector<SweepResult>>& results) {
  BarPlot plot{.title = "Sweeps on one thread", .y_label = "million points/s", .is_log_y = true};
  auto& [paper, paper_rates] = plot.series.emplace_back("paper, 2007", std::vector<double>());
  for (const PaperTime& time : kPaperTimes) {
    plot.groups.push_back(name_of(time.kind));
    paper_rates.push_back(kPaperPoints * kSweeps / time.seconds / kMillion);
  }
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    std::vector<double> rates;
    const auto n = static_cast<double>(scenes[i].mesh.points.size()) * kSweeps;
    for (const PaperTime& time : kPaperTimes) {
      rates.push_back(n / result_of(time.kind, results[i]).seconds / kMillion);
    }
    plot.series.emplace_back(scenes[i].name, rates);
  }
  return {"study-aubry-lohner.svg", plot.title, to_svg(plot)};
}

}  // namespace

Report study_aubry_lohner(const AubryLohnerOptions& options, ProgressSink& progress) {
  check_repetitions("aubry-lohner", options.repetitions);
  const ThreadLimit one_thread(1);
  progress.begin_stage("bodies");
  const std::vector<Scene> scenes = {flyer_scene(), block_scene()};
  progress.end_stage();

  Report report{.name = "aubry-lohner",
                .settings = fmt::format("Aubry & Löhner 2008: processor times of one thread, medians of {} repetitions "
                                        "(of the iterative sweeps in the first table of each body: one).",
                                        options.repetitions)};
  report.tables.push_back(body_table(scenes));
  std::vector<std::vector<SweepResult>> results;
  for (const Scene& scene : scenes) {
    progress.begin_stage(scene.name + ": sweeps");
    results.push_back(compare_sweeps(scene.mesh, options, progress));
    report.tables.push_back(sweep_table(scene, results.back()));
    progress.end_stage();
    progress.begin_stage(scene.name + ": smoothing");
    report.tables.push_back(library_table(scene, options.repetitions, progress));
    progress.end_stage();
    progress.begin_stage(scene.name + ": normals");
    report.tables.push_back(face_table(scene, options.repetitions, progress));
    progress.end_stage();
  }
  report.pictures.push_back(rate_plot(scenes, results));
  return report;
}

}  // namespace nearwall::studies
