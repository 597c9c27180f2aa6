#include "sweep_measure.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "nearwall/certify/certificate.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/box.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/pipeline/report.h"
#include "nearwall/quality/coverage.h"

namespace nearwall::sweep {

namespace {

constexpr double kPercent = 100;
constexpr double kGrowth = 1.2;
constexpr double kThicknessOfS = 0.01;
constexpr double kFirstHeightOfR = 1e-6;
constexpr int kLayersOfS = 20;
constexpr int kLayersOfR = 30;
/// As in pipeline/run.cpp.
constexpr double kLargestClosure = 1e-9;

std::vector<double> heights_of(Standard standard, double diagonal) {
  const bool is_s = standard == Standard::S;
  std::vector<double> heights;
  double h = 1, sum = 0;
  for (int i = 0; i < (is_s ? kLayersOfS : kLayersOfR); ++i) heights.push_back(h), sum += h, h *= kGrowth;
  const double scale = is_s ? kThicknessOfS * diagonal / sum : kFirstHeightOfR * diagonal;
  for (double& height : heights) height *= scale;
  return heights;
}

Case settings_for(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  const std::string text = fmt::format("format = 1\n[surface]\nfile = '{}'\n[layers]\ntotal_thickness = 1\n",
                                       std::filesystem::absolute(file).string());
  return parse_case(text, "sweep.toml", overrides);
}

layers::GrowOptions options_of(const Case& settings, const mesh::SurfaceMesh& surface, Standard standard) {
  layers::PatchSchedule schedule;
  schedule.heights = heights_of(standard, geometry::bounding_box(surface.points.raw()).diagonal());
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
  return options;
}

/// The largest ratio of the lengths of successive steps along any line, bends included.
double largest_growth(const mesh::Lines& lines) {
  double largest = 0;
  for (const LineId line : lines.base.ids()) {
    const mesh::Window window = lines.windows[line];
    Vec3 below = lines.base[line];
    double step_below = 0;
    for (int j = window.start + 1; j <= window.end; ++j) {
      const Vec3 place = lines.position(line, static_cast<Level>(j));
      const double step = distance(place, below);
      if (step_below > 0) largest = std::max(largest, step / step_below);
      below = place;
      step_below = step;
    }
  }
  return largest;
}

bool starts_late(const layers::Growth& growth, FaceId f) {
  const auto& lines = growth.front.faces[FrontFaceId(f.index())].lines;
  return std::any_of(lines.begin(), lines.begin() + 3,
                     [&](LineId line) { return growth.lines.windows[line].start > 0; });
}

bool is_certified(const layers::Wall& wall, const mesh::LayerMesh& layer_mesh) {
  const certify::Certificate c = certify::certify_layers(
      layer_mesh, {wall.surface, layers::wetted_components(wall), wall.fluid_is_inside}, silent_progress());
  return c.is_valid() && c.closure() <= kLargestClosure;
}

/// The shares of the area, and the share of each reason. What is missing is summed, so that nothing missing is 100
/// exactly.
void sum_up(const layers::Wall& wall, const layers::Growth& growth,
            const IdVector<FaceId, quality::FaceCoverage>& faces, double first_height, Row& row,
            quality::PatchCoverage& limits) {
  double area = 0;
  Row missing;
  for (const FaceId f : wall.surface.faces.ids()) {
    if (!wall.is_wetted[f]) continue;
    const auto [a, b, c] = wall.surface.triangle(f);
    const double share = geometry::triangle_area(a, b, c), ratio = faces[f].first_height / first_height;
    area += share;
    missing.all += faces[f].has_all_layers ? 0 : share;
    missing.full += faces[f].is_full ? 0 : share;
    missing.any += faces[f].has_any ? 0 : share;
    missing.first += std::abs(ratio - 1) <= quality::kFirstHeightTolerance ? 0 : share;
    row.large_first += ratio > quality::kLargeFirstHeight && !starts_late(growth, f) ? kPercent * share : 0;
    row.mean_layers += share * faces[f].layers;
    if (!faces[f].is_full) limits.limit_percent[static_cast<std::size_t>(faces[f].reason)] += kPercent * share;
  }
  for (double Row::*member : {&Row::all, &Row::full, &Row::any, &Row::first}) {
    row.*member = kPercent - kPercent * (missing.*member / area);
  }
  row.large_first /= area;
  row.mean_layers /= area;
  for (double& percent : limits.limit_percent) percent /= area;
}

/// The largest of the triangles with the largest reason.
void find_worst(const layers::Wall& wall, const IdVector<FaceId, quality::FaceCoverage>& faces,
                const quality::PatchCoverage& limits, Row& row) {
  const auto largest = std::max_element(limits.limit_percent.begin(), limits.limit_percent.end());
  const auto reason = static_cast<mesh::LimitReason>(largest - limits.limit_percent.begin());
  double largest_area = 0;
  for (const FaceId f : wall.surface.faces.ids()) {
    if (!wall.is_wetted[f] || faces[f].is_full || faces[f].reason != reason) continue;
    const auto [a, b, c] = wall.surface.triangle(f);
    const double area = geometry::triangle_area(a, b, c);
    if (area <= largest_area) continue;
    largest_area = area;
    row.worst_place = (a + b + c) / 3;
    row.worst_normal = geometry::triangle_normal(a, b, c);
  }
}

Row measure(const layers::Wall& wall, const layers::Growth& growth, const std::vector<double>& heights) {
  double total = 0;
  for (const double h : heights) total += h;
  const IdVector<PatchId, quality::PatchRequest> requests(
      wall.surface.patch_names.size(), {true, heights.front(), total, static_cast<Level>(heights.size())});
  const mesh::LayerMesh layer_mesh(growth.front, growth.lines);
  const quality::LineOutcome outcome{growth.asked_thickness, growth.reached_thickness, growth.reason};
  const auto faces = quality::face_coverage(layer_mesh, wall.surface, requests, outcome);
  Row row;
  quality::PatchCoverage limits;
  sum_up(wall, growth, faces, heights.front(), row, limits);
  find_worst(wall, faces, limits, row);
  for (const double percent : limits.limit_percent) row.n_reasons += percent > 0;
  row.limits = reasons_in_words(limits, 1);
  row.diagonal = geometry::bounding_box(wall.surface.points.raw()).diagonal();
  row.is_certified = is_certified(wall, layer_mesh);
  row.largest_growth = largest_growth(growth.lines);
  row.lines = static_cast<double>(growth.front.n_lines()) / static_cast<double>(wall.surface.points.size());
  row.rounds = growth.rounds;
  return row;
}

}  // namespace

Body::Body(const std::filesystem::path& file, const std::vector<std::string>& overrides)
    : settings_(settings_for(file, overrides)), prepared_(pipeline::prepare(settings_, silent_progress())) {}

Row Body::grow(Standard standard, const Change& change) const {
  const layers::Wall wall{prepared_.surface(), prepared_.topology, prepared_.features, prepared_.is_wetted,
                          settings_.surface.fluid == surface::FluidSide::Inside};
  layers::GrowOptions options = options_of(settings_, prepared_.surface(), standard);
  if (change) change(options);
  const auto start = std::chrono::steady_clock::now();
  const layers::Growth growth = layers::grow(wall, options);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  Row row = measure(wall, growth, options.schedules[PatchId(0)].heights);
  row.seconds = taken.count();
  return row;
}

std::string short_refusal(const std::string& message, const std::filesystem::path& file) {
  const std::string found_in = file.filename().string() + ":", announced = "the surface cannot be used:";
  std::string text = message;
  if (const auto at = text.find(found_in); at != std::string::npos) text.erase(0, at + found_in.size());
  if (const auto at = text.find(announced); at != std::string::npos) text.erase(0, at + announced.size());
  const auto begin = text.find_first_not_of(" \n");
  if (begin != std::string::npos) text.erase(0, begin);
  text.erase(std::min({text.find('\n'), text.find(" near ("), text.find(';'), text.size()}));
  return text;
}

}  // namespace nearwall::sweep
