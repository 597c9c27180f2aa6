#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "nearwall/core/parallel.h"
#include "nearwall/studies/bohdal.h"
#include "nearwall/studies/plot.h"
#include "studies/repetitions.h"
#include "studies/test_functions.h"

namespace nearwall::studies {

namespace {

constexpr std::array<std::size_t, 4> kSizes = {4900, 2500, 900, 100};  // the largest first, for the threads' sake
constexpr std::size_t kMeshes = kSizes.size() * kTestFunctions;
constexpr std::size_t kMethods = kBohdalMethods.size();

/// Errors of one set of 36 meshes, or of several sets one after the other.
using Errors = std::vector<BohdalErrors>;

Errors errors_of_set(std::uint64_t seed) {
  Errors errors(kMeshes);
  parallel_blocks(kMeshes, 1, [&](std::size_t i, std::size_t) {
    errors[i] = bohdal_errors(static_cast<int>(i % kTestFunctions) + 1, kSizes[i / kTestFunctions], seed);
  });
  return errors;
}

using Value = std::function<double(const BohdalErrors&)>;
using Choice = std::function<bool(const BohdalErrors&)>;

bool every(const BohdalErrors&) { return true; }

Choice of_size(std::size_t n) {
  return [n](const BohdalErrors& e) { return e.n_points == n; };
}
Choice of_function(int number) {
  return [number](const BohdalErrors& e) { return e.function == number; };
}

double geometric_mean(const Errors& errors, const Value& value, const Choice& is_chosen = every) {
  double sum = 0;
  std::size_t n = 0;
  for (const BohdalErrors& e : errors) {
    if (is_chosen(e)) sum += std::log(value(e)), ++n;
  }
  return std::exp(sum / static_cast<double>(n));
}

Value normals_of(std::size_t method, BohdalRemoval removal = BohdalRemoval::None) {
  return [=](const BohdalErrors& e) { return e.normals_deg[static_cast<std::size_t>(removal)][method]; };
}
Value clough_of(std::size_t method) {
  return [=](const BohdalErrors& e) { return e.clough_tocher[method]; };
}
Value powell_of(std::size_t method) {
  return [=](const BohdalErrors& e) { return e.powell_sabin[method]; };
}

std::string name_of(std::size_t method) { return std::string(kBohdalMethods[method].name); }

std::vector<std::size_t> methods_of_paper() {
  std::vector<std::size_t> methods;
  for (std::size_t m = 0; m < kMethods; ++m) {
    if (kBohdalMethods[m].is_of_paper) methods.push_back(m);
  }
  return methods;
}

Table summary(const std::vector<Errors>& sets, const Errors& all) {
  Table table{
      .title = fmt::format("Geometric means over the 36 meshes and {} sets of them: RMSE of the normals [degrees], of "
                           "the Clough-Tocher and of the Powell-Sabin interpolant",
                           sets.size()),
      .row_title = "method",
      .columns = {"normals", "best set", "worst set", "Clough-Tocher", "Powell-Sabin", "no answer, %"}};
  for (std::size_t m = 0; m < kMethods; ++m) {
    std::vector<double> of_sets;
    of_sets.reserve(sets.size());
    for (const Errors& errors : sets) of_sets.push_back(geometric_mean(errors, normals_of(m)));
    const auto [best, worst] = std::minmax_element(of_sets.begin(), of_sets.end());
    double fallbacks = 0;
    for (const BohdalErrors& e : all) fallbacks += e.fallback_percent[m] / static_cast<double>(all.size());
    table.rows.push_back({name_of(m),
                          {geometric_mean(all, normals_of(m)), *best, *worst, geometric_mean(all, clough_of(m)),
                           geometric_mean(all, powell_of(m)), fallbacks}});
  }
  const double none = std::nan("");
  table.rows.push_back({"true normals",
                        {0, 0, 0, geometric_mean(all, [](const auto& e) { return e.clough_tocher_of_truth; }),
                         geometric_mean(all, [](const auto& e) { return e.powell_sabin_of_truth; }), none}});
  return table;
}

Table removal_table(const Errors& all) {
  Table table{.title = "What removal does: geometric means over the 36 meshes, RMSE of the normals [degrees]",
              .row_title = "method",
              .columns = {kBohdalRemovals.begin(), kBohdalRemovals.end()}};
  for (std::size_t m = 0; m < kMethods; ++m) {
    Table::Row row{name_of(m), {}};
    for (std::size_t r = 0; r < kBohdalRemovals.size(); ++r) {
      row.values.push_back(geometric_mean(all, normals_of(m, static_cast<BohdalRemoval>(r))));
    }
    table.rows.push_back(row);
  }
  return table;
}

Table function_table(const Errors& all) {
  Table table{.title = "By function: geometric means over the numbers of points, RMSE of the normals [degrees]",
              .row_title = "method"};
  for (int f = 1; f <= kTestFunctions; ++f) table.columns.push_back(fmt::format("f{}", f));
  table.columns.push_back("without f7, f8");
  for (std::size_t m = 0; m < kMethods; ++m) {
    Table::Row row{name_of(m), {}};
    for (int f = 1; f <= kTestFunctions; ++f) row.values.push_back(geometric_mean(all, normals_of(m), of_function(f)));
    row.values.push_back(
        geometric_mean(all, normals_of(m), [](const auto& e) { return e.function < 7 || e.function > 8; }));
    table.rows.push_back(row);
  }
  return table;
}

Table size_table(const Errors& all) {
  Table table{.title = "By number of points: geometric means over the functions, RMSE of the normals [degrees]",
              .row_title = "method"};
  for (auto n = kSizes.rbegin(); n != kSizes.rend(); ++n) table.columns.push_back(fmt::format("{}", *n));
  for (std::size_t m = 0; m < kMethods; ++m) {
    Table::Row row{name_of(m), {}};
    for (auto n = kSizes.rbegin(); n != kSizes.rend(); ++n) {
      row.values.push_back(geometric_mean(all, normals_of(m), of_size(*n)));
    }
    table.rows.push_back(row);
  }
  return table;
}

/// Each of the 36 meshes by the methods of the paper.
Table mesh_table(const std::string& title, const Errors& all, const std::function<Value(std::size_t)>& value_of) {
  Table table{.title = title, .row_title = "mesh"};
  for (const std::size_t m : methods_of_paper()) table.columns.push_back(name_of(m));
  for (int f = 1; f <= kTestFunctions; ++f) {
    for (auto n = kSizes.rbegin(); n != kSizes.rend(); ++n) {
      const auto is_mesh = [&](const BohdalErrors& e) { return e.function == f && e.n_points == *n; };
      Table::Row row{fmt::format("f{}, {}", f, *n), {}};
      for (const std::size_t m : methods_of_paper()) row.values.push_back(geometric_mean(all, value_of(m), is_mesh));
      table.rows.push_back(row);
    }
  }
  return table;
}

/// How often each of the paper's methods is the best and the second best of them.
Table rank_table(const Errors& all) {
  const auto methods = methods_of_paper();
  const std::array<std::function<Value(std::size_t)>, 3> judged = {[](std::size_t m) { return normals_of(m); },
                                                                   [](std::size_t m) { return clough_of(m); },
                                                                   [](std::size_t m) { return powell_of(m); }};
  Table table{
      .title = "Share of all meshes where a method of the paper is the best of the eight, or the second best [percent]",
      .row_title = "method",
      .columns = {"normals, best", "second", "Clough-Tocher, best", "second", "Powell-Sabin, best", "second"}};
  for (const std::size_t m : methods) table.rows.push_back({name_of(m), std::vector<double>(6, 0)});
  const double share = 100.0 / static_cast<double>(all.size());
  for (const BohdalErrors& e : all) {
    for (std::size_t j = 0; j < judged.size(); ++j) {
      std::vector<std::pair<double, std::size_t>> order;
      for (std::size_t i = 0; i < methods.size(); ++i) order.emplace_back(judged[j](methods[i])(e), i);
      std::sort(order.begin(), order.end());
      table.rows[order[0].second].values[2 * j] += share;
      table.rows[order[1].second].values[2 * j + 1] += share;
    }
  }
  return table;
}

Table time_table(std::uint64_t seed) {
  constexpr std::array<std::size_t, 2> kTimedSizes = {4900, 8100};  // of the paper's table 1
  constexpr double kMilli = 1e3;
  Table table{
      .title = "Processor time for all normals [ms]", .row_title = "method", .columns = {"4900 points", "8100 points"}};
  const auto small = bohdal_seconds(kTimedSizes[0], seed), large = bohdal_seconds(kTimedSizes[1], seed);
  for (std::size_t m = 0; m < kMethods; ++m) {
    table.rows.push_back({name_of(m), {kMilli * small[m], kMilli * large[m]}});
  }
  return table;
}

Picture size_plot(const Errors& all) {
  LinePlot plot{.title = "Error of the normals, geometric mean over the functions",
                .x_label = "points",
                .y_label = "RMSE [degrees]",
                .is_log_x = true,
                .is_log_y = true};
  auto shown_methods = methods_of_paper();
  for (std::size_t m = 0; m < kMethods; ++m) {
    const bool is_fit =
        kBohdalMethods[m].method == surface::NormalMethod::Nielson ||
        (kBohdalMethods[m].method == surface::NormalMethod::ThinPlate && kBohdalMethods[m].n_rings == 2);
    if (is_fit) shown_methods.push_back(m);
  }
  for (const std::size_t m : shown_methods) {
    Series series{name_of(m), {}};
    for (auto n = kSizes.rbegin(); n != kSizes.rend(); ++n) {
      series.points.emplace_back(static_cast<double>(*n), geometric_mean(all, normals_of(m), of_size(*n)));
    }
    plot.series.push_back(series);
  }
  return {"study-bohdal-points.svg", plot.title, to_svg(plot)};
}

Picture function_plot(const std::string& file, const std::string& title, const std::string& y_label, const Errors& all,
                      const std::function<Value(std::size_t)>& value_of) {
  BarPlot plot{.title = title, .y_label = y_label, .is_log_y = true};
  for (int f = 1; f <= kTestFunctions; ++f) plot.groups.push_back(fmt::format("f{}", f));
  for (const std::size_t m : methods_of_paper()) {
    std::vector<double> bars;
    for (int f = 1; f <= kTestFunctions; ++f) bars.push_back(geometric_mean(all, value_of(m), of_function(f)));
    plot.series.emplace_back(name_of(m), bars);
  }
  return {file, title, to_svg(plot)};
}

Picture removal_plot(const Errors& all) {
  BarPlot plot{.title = "What removal does to weighted means", .y_label = "RMSE of the normals [degrees]"};
  std::vector<std::size_t> weights;
  for (const std::size_t m : methods_of_paper()) {
    if (surface::weight_of(kBohdalMethods[m].method)) weights.push_back(m);
  }
  plot.groups.reserve(weights.size());
  for (const std::size_t m : weights) plot.groups.push_back(name_of(m));
  for (std::size_t r = 0; r < kBohdalRemovals.size(); ++r) {
    std::vector<double> bars(weights.size());
    std::transform(weights.begin(), weights.end(), bars.begin(),
                   [&](std::size_t m) { return geometric_mean(all, normals_of(m, static_cast<BohdalRemoval>(r))); });
    plot.series.emplace_back(std::string(kBohdalRemovals[r]), bars);
  }
  return {"study-bohdal-removal.svg", plot.title, to_svg(plot)};
}

}  // namespace

Report study_bohdal(const BohdalOptions& options, ProgressSink& progress) {
  check_repetitions("bohdal", options.repetitions);
  std::vector<Errors> sets;
  Errors all;
  progress.begin_stage("height fields");
  for (int i = 0; i < options.repetitions; ++i) {
    progress.update(static_cast<double>(i) / options.repetitions);
    sets.push_back(errors_of_set(options.seed + static_cast<std::uint64_t>(i)));
    all.insert(all.end(), sets.back().begin(), sets.back().end());
  }
  progress.end_stage();

  Report report{
      .name = "bohdal",
      .settings = fmt::format("Bohdal 2017: {} sets of 36 meshes, seeds from {}.", options.repetitions, options.seed)};
  const auto normals = [](std::size_t m) { return normals_of(m); };
  report.tables = {summary(sets, all),
                   rank_table(all),
                   removal_table(all),
                   function_table(all),
                   size_table(all),
                   mesh_table("All meshes: RMSE of the normals [degrees]", all, normals),
                   mesh_table("All meshes: RMSE of the Clough-Tocher interpolant", all, clough_of),
                   mesh_table("All meshes: RMSE of the Powell-Sabin interpolant", all, powell_of),
                   time_table(options.seed)};
  report.pictures = {
      size_plot(all),
      function_plot("study-bohdal-normals.svg", "Error of the normals by function", "RMSE [degrees]", all, normals),
      function_plot("study-bohdal-interpolant.svg", "Error of the Clough-Tocher interpolant by function", "RMSE", all,
                    clough_of),
      removal_plot(all)};
  return report;
}

}  // namespace nearwall::studies
