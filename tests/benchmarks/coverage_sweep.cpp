#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/box.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/layers/grow.h"
#include "nearwall/quality/coverage.h"
#include "pipeline/prepare.h"

// Grows layers on many surfaces and prints what share of each wall has what, and the means: the figures by which
// thresholds and defaults of the growth are chosen (docs/theory/fans.md, docs/theory/layers.md). No files are written.
//   nearwall_coverage_sweep --schedule S --set 'layers.on_conflict="stair"' FILE...

namespace nearwall {
namespace {

struct Sweep {
  std::vector<std::string> files;
  std::vector<std::string> overrides;
  std::string schedule = "S";
  double steep_angle_deg = geometry::to_degrees(layers::GrowOptions().steep_angle);
};

/// Shares of the wall's area [percent], lines for a vertex, rounds and seconds of growth.
struct Row {
  double all = 0, full = 0, any = 0, first_height = 0, mean_layers = 0, lines = 0, rounds = 0, seconds = 0;
};

constexpr double kGrowth = 1.2;

/// S: 20 layers, 1 % of the diagonal thick in all; R: 30 layers from a millionth of it on.
std::vector<double> heights_of(const std::string& schedule, double diagonal) {
  const bool is_standard = schedule == "S";
  std::vector<double> heights;
  double h = 1, sum = 0;
  for (int i = 0; i < (is_standard ? 20 : 30); ++i) heights.push_back(h), sum += h, h *= kGrowth;
  const double scale = is_standard ? 0.01 * diagonal / sum : 1e-6 * diagonal;
  for (double& height : heights) height *= scale;
  return heights;
}

layers::GrowOptions options_of(const Sweep& sweep, const Case& settings, const mesh::SurfaceMesh& surface) {
  layers::PatchSchedule schedule;
  schedule.heights = heights_of(sweep.schedule, geometry::bounding_box(surface.points.raw()).diagonal());
  schedule.on_conflict = settings.layers.on_conflict.value_or(OnConflict::Auto);
  if (settings.layers.max_level_step.value_or(0) > 0) schedule.max_level_step = settings.layers.max_level_step;
  layers::GrowOptions options;
  options.schedules.assign(surface.patch_names.size(), schedule);
  options.normals = settings.normals;
  options.filter = settings.smoothing.filter;
  options.smoothing_iterations = settings.smoothing.iterations;
  options.several_lines = settings.is_multi_allowed;
  options.multi_angle = geometry::to_radians(settings.multi_angle_deg);
  options.max_turn = geometry::to_radians(settings.max_turn_deg);
  options.steep_angle = geometry::to_radians(sweep.steep_angle_deg);
  return options;
}

Row measure(const layers::Wall& wall, const layers::Growth& growth, const std::vector<double>& heights) {
  double total = 0;
  for (const double h : heights) total += h;
  const quality::PatchRequest request{true, heights.front(), total, static_cast<Level>(heights.size())};
  const mesh::LayerMesh layers(growth.front, growth.lines);
  const auto faces = quality::face_coverage(
      layers, wall.surface, IdVector<PatchId, quality::PatchRequest>(wall.surface.patch_names.size(), request),
      {growth.asked_thickness, growth.reached_thickness, growth.reason});
  Row row;
  double area = 0;
  for (const FaceId f : wall.surface.faces.ids()) {
    if (!wall.is_wetted[f]) continue;
    const auto [a, b, c] = wall.surface.triangle(f);
    const double share = 100 * geometry::triangle_area(a, b, c), ratio = faces[f].first_height / heights.front();
    area += share / 100;
    row.all += faces[f].has_all_layers ? share : 0;
    row.full += faces[f].is_full ? share : 0;
    row.any += faces[f].has_any ? share : 0;
    row.first_height += ratio > 0.95 && ratio < 1.05 ? share : 0;
    row.mean_layers += share / 100 * faces[f].layers;
  }
  for (double* sum : {&row.all, &row.full, &row.any, &row.first_height, &row.mean_layers}) *sum /= area;
  row.lines = static_cast<double>(growth.front.n_lines()) / static_cast<double>(wall.surface.points.size());
  row.rounds = growth.rounds;
  return row;
}

Row grow_on(const Sweep& sweep, const std::string& file) {
  const std::string text = fmt::format("format = 1\n[surface]\nfile = '{}'\n[layers]\ntotal_thickness = 1\n",
                                       std::filesystem::absolute(file).string());
  const Case settings = parse_case(text, "sweep.toml", sweep.overrides);
  const pipeline::Prepared prepared = pipeline::prepare(settings, silent_progress());
  const layers::Wall wall{prepared.surface(), prepared.topology, prepared.features, prepared.is_wetted,
                          settings.surface.fluid == surface::FluidSide::Inside};
  const layers::GrowOptions options = options_of(sweep, settings, prepared.surface());
  const auto start = std::chrono::steady_clock::now();
  const layers::Growth growth = layers::grow(wall, options);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  Row row = measure(wall, growth, options.schedules[PatchId(0)].heights);
  row.seconds = taken.count();
  return row;
}

void print(const std::string& name, const Row& r) {
  fmt::print("{:<60} {:7.2f} {:7.2f} {:7.2f} {:7.2f} {:6.2f} {:6.2f} {:6.1f} {:8.3f}\n", name, r.all, r.full, r.any,
             r.first_height, r.mean_layers, r.lines, r.rounds, r.seconds);
}

int run(const Sweep& sweep) {
  fmt::print("{:<60} {:>7} {:>7} {:>7} {:>7} {:>6} {:>6} {:>6} {:>8}\n", "surface", "all %", "full %", "any %",
             "first %", "layers", "lines", "rounds", "seconds");
  Row sum;
  int n = 0;
  for (const std::string& file : sweep.files) {
    try {
      const Row row = grow_on(sweep, file);
      print(std::filesystem::path(file).filename().string(), row);
      for (double Row::*member : {&Row::all, &Row::full, &Row::any, &Row::first_height, &Row::mean_layers, &Row::lines,
                                  &Row::rounds, &Row::seconds}) {
        sum.*member += row.*member;
      }
      ++n;
    } catch (const Error& e) {
      fmt::print("{:<60} {}\n", file, e.what());
    }
  }
  if (n == 0) return 1;
  for (double Row::*member :
       {&Row::all, &Row::full, &Row::any, &Row::first_height, &Row::mean_layers, &Row::lines, &Row::rounds}) {
    sum.*member /= n;
  }
  print(fmt::format("mean of {}, sum of seconds", n), sum);
  return 0;
}

}  // namespace
}  // namespace nearwall

int main(int argc, char** argv) {
  nearwall::Sweep sweep;
  CLI::App app("coverage of many surfaces under one schedule");
  app.add_option("FILE", sweep.files, "surfaces")->required();
  app.add_option("--schedule", sweep.schedule, "S: 20 layers, 1 % of the diagonal; R: 30 from a millionth of it on")
      ->check(CLI::IsMember({"S", "R"}));
  app.add_option("--set", sweep.overrides, "key=value of a case file; may be repeated")->allow_extra_args(false);
  app.add_option("--steep-angle", sweep.steep_angle_deg, "of GrowOptions [deg]");
  CLI11_PARSE(app, argc, argv);
  return nearwall::run(sweep);
}
