#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "nearwall/studies/plot.h"
#include "nearwall/studies/ubach.h"

namespace nearwall::studies {

namespace {

constexpr std::size_t kMax = 5, kBest = 4;  // among kUbachWeights
static_assert(kUbachWeights[kMax] == surface::Weight::Max);
static_assert(kUbachWeights[kBest] == surface::Weight::AngleOverCircumArea);
constexpr double kMiddleCurvature = 0.1;

using Cells = std::vector<UbachCell>;

std::vector<std::string> weight_titles() { return {kUbachNames.begin(), kUbachNames.end()}; }

template <class Key>
Cells chosen(const Cells& cells, Key&& key) {
  Cells out;
  std::copy_if(cells.begin(), cells.end(), std::back_inserter(out), key);
  return out;
}

Table rmse_table(const Cells& cells, int n_faces) {
  Table table{
      .title = fmt::format("RMSE in degrees, n_p = {}", n_faces), .row_title = "k_max", .columns = weight_titles()};
  for (const UbachCell& cell : chosen(cells, [&](const auto& c) { return c.n_faces == n_faces; })) {
    table.rows.push_back({fmt::format("{:g}", cell.max_curvature), {cell.rmse_deg.begin(), cell.rmse_deg.end()}});
  }
  return table;
}

Table faces_table(const Cells& cells) {
  Table table{.title = "RMSE in degrees, k_max = 0.1", .row_title = "n_p", .columns = weight_titles()};
  for (const UbachCell& cell : chosen(cells, [](const auto& c) { return c.max_curvature == kMiddleCurvature; })) {
    table.rows.push_back({fmt::format("{}", cell.n_faces), {cell.rmse_deg.begin(), cell.rmse_deg.end()}});
  }
  return table;
}

/// How far the tables can be trusted.
Table spread_table(const Cells& cells) {
  Table table{.title = "Largest standard error of the RMSE over all k_max, in percent of it",
              .row_title = "n_p",
              .columns = weight_titles()};
  for (const int n : kUbachFaces) {
    std::vector<double> worst(kUbachWeights.size(), 0);
    for (const UbachCell& cell : chosen(cells, [&](const auto& c) { return c.n_faces == n; })) {
      for (std::size_t w = 0; w < worst.size(); ++w) {
        worst[w] = std::max(worst[w], 100 * cell.standard_error_deg[w] / cell.rmse_deg[w]);
      }
    }
    table.rows.push_back({fmt::format("{}", n), worst});
  }
  return table;
}

Table ratio_table(const Cells& cells) {
  Table table{.title = "RMSE of α/A∘ over that of sin α/(bc)", .row_title = "k_max"};
  for (const int n : kUbachFaces) table.columns.push_back(fmt::format("n_p = {}", n));
  for (const double k : kUbachCurvatures) {
    Table::Row row{fmt::format("{:g}", k), {}};
    for (const UbachCell& cell : chosen(cells, [&](const auto& c) { return c.max_curvature == k; })) {
      row.values.push_back(cell.rmse_deg[kBest] / cell.rmse_deg[kMax]);
    }
    table.rows.push_back(row);
  }
  return table;
}

Table torus_table(const std::vector<TorusComparison>& results) {
  Table table{.title = "Torus, R / r = (1 + √5) / 2: α/A∘ against sin α/(bc)",
              .row_title = "mesh",
              .columns = {"nodes", "α/A∘ better, %", "RMSE α/A∘, °", "RMSE sin α/(bc), °", "ratio"}};
  for (const TorusComparison& r : results) {
    table.rows.push_back({r.family,
                          {static_cast<double>(r.n_nodes), r.improved_percent, r.rmse_circle_deg, r.rmse_max_deg,
                           r.rmse_circle_deg / r.rmse_max_deg}});
  }
  return table;
}

Picture curvature_plot(const Cells& cells, int n_faces) {
  LinePlot plot{.title = fmt::format("Error of the normal, {} triangles round the point", n_faces),
                .x_label = "k_max",
                .y_label = "RMSE [degrees]",
                .is_log_x = true,
                .is_log_y = true};
  for (std::size_t w = 0; w < kUbachWeights.size(); ++w) {
    Series series{std::string(kUbachNames[w]), {}};
    for (const UbachCell& cell : chosen(cells, [&](const auto& c) { return c.n_faces == n_faces; })) {
      series.points.emplace_back(cell.max_curvature, cell.rmse_deg[w]);
    }
    plot.series.push_back(series);
  }
  return {fmt::format("study-ubach-{}.svg", n_faces), plot.title, to_svg(plot)};
}

Picture faces_plot(const Cells& cells) {
  LinePlot plot{.title = "Error of the normal, k_max = 0.1",
                .x_label = "n_p: triangles round the point",
                .y_label = "RMSE [degrees]",
                .is_log_y = true};
  for (std::size_t w = 0; w < kUbachWeights.size(); ++w) {
    Series series{std::string(kUbachNames[w]), {}};
    for (const UbachCell& cell : chosen(cells, [](const auto& c) { return c.max_curvature == kMiddleCurvature; })) {
      series.points.emplace_back(cell.n_faces, cell.rmse_deg[w]);
    }
    plot.series.push_back(series);
  }
  return {"study-ubach-faces.svg", plot.title, to_svg(plot)};
}

Picture torus_plot(const std::vector<TorusComparison>& results) {
  constexpr std::size_t kPoints = 200;  // of a line: more than the plot has pixels for is waste
  LinePlot plot{.title = "Torus: error of α/A∘ less that of sin α/(bc), nodes in order",
                .x_label = "nodes [percent]",
                .y_label = "change of the error [degrees]",
                .has_markers = false};
  for (const TorusComparison& r : results) {
    Series series{r.family, {}};
    // A few nodes at either end would set the scale for all.
    for (std::size_t i = 1; i < kPoints; ++i) {
      const double share = static_cast<double>(i) / kPoints;
      const auto at = static_cast<std::size_t>(share * static_cast<double>(r.change_deg.size()));
      series.points.emplace_back(100 * share, r.change_deg[at]);
    }
    plot.series.push_back(series);
  }
  return {"study-ubach-torus.svg", plot.title, to_svg(plot)};
}

}  // namespace

Report study_ubach(const UbachOptions& options, ProgressSink& progress) {
  Cells cells;
  progress.begin_stage("random surfaces");
  constexpr double kCells = kUbachCurvatures.size() * kUbachFaces.size();
  for (const double k : kUbachCurvatures) {
    for (const int n : kUbachFaces) {
      progress.update(static_cast<double>(cells.size()) / kCells);
      cells.push_back(ubach_cell(k, n, options));
    }
  }
  progress.end_stage();
  progress.begin_stage("torus");
  const auto torus = compare_on_torus(options.seed);
  progress.end_stage();

  Report report{
      .name = "ubach",
      .settings = fmt::format("Ubach et al. 2013: {} surfaces for each cell, seed {}.", options.samples, options.seed)};
  for (const int n : kUbachFaces) report.tables.push_back(rmse_table(cells, n));
  for (const int n : kUbachFaces) report.pictures.push_back(curvature_plot(cells, n));
  report.tables.push_back(faces_table(cells));
  report.tables.push_back(ratio_table(cells));
  report.tables.push_back(spread_table(cells));
  report.tables.push_back(torus_table(torus));
  report.pictures.push_back(faces_plot(cells));
  report.pictures.push_back(torus_plot(torus));
  return report;
}

}  // namespace nearwall::studies
