#include "pipeline/report_json.h"

#include <algorithm>
#include <cmath>

#include "pipeline/case_keys.h"

namespace nearwall {

namespace {

using pipeline::CaseValue;
using pipeline::Json;
using pipeline::Key;

Json to_json_value(const CaseValue& value) {
  return std::visit(
      [](const auto& v) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::monostate>) {
          return nullptr;
        } else if constexpr (std::is_same_v<std::decay_t<decltype(v)>, ArrayLength>) {
          return {{"array", v.array}, {"factor", v.factor}};
        } else if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::vector<SymmetrySetting>>) {
          Json planes = Json::array();
          for (const SymmetrySetting& plane : v) {
            Json& json = planes.emplace_back(Json{{"axis", std::string(1, pipeline::kAxisNames[plane.axis])}});
            if (plane.at) json["at"] = *plane.at;
          }
          return planes;
        } else {
          return v;
        }
      },
      value);
}

Json statistics_json(const quality::Statistics& s) {
  if (s.count == 0) return nullptr;
  return {{"min", s.min}, {"p01", s.p01}, {"median", s.median}, {"p99", s.p99}, {"max", s.max}, {"mean", s.mean}};
}

/// Counts by reason, those that are zero left out.
template <class Number>
Json by_reason(const std::array<Number, mesh::kNLimitReasons>& values) {
  Json json = Json::object();
  for (std::size_t r = 1; r < mesh::kNLimitReasons; ++r) {
    if (values[r] > 0) json[std::string(mesh::kLimitReasonNames[r])] = values[r];
  }
  return json;
}

Json point_json(const Vec3& p) { return Json::array({p.x(), p.y(), p.z()}); }

Json patch_json(const PatchReport& patch) {
  const quality::PatchCoverage& c = patch.coverage;
  Json json = {{"type", type_name(patch.type)}, {"area", c.area}};
  if (!has_layers(patch.type)) return json;
  json["full_percent"] = c.full_percent;
  json["all_layers_percent"] = c.all_layers_percent;
  json["any_percent"] = c.any_percent;
  json["mean_layers"] = c.mean_layers;
  json["count"] = {{"asked", c.asked.count}};
  json["first_height"] = {{"asked", c.asked.first_height},
                          {"median", c.first_height.median},
                          {"p01", c.first_height.p01},
                          {"p99", c.first_height.p99},
                          {"within_5_percent", c.first_height_met_percent},
                          {"over_1_5_times", c.first_height_large_percent}};
  json["thickness"] = {{"asked", c.asked.total_thickness}, {"median", c.thickness.median}, {"p01", c.thickness.p01}};
  if (c.asked.has_own_heights)
    json["first_height"]["asked_range"] = {c.asked_first_height.min, c.asked_first_height.max};
  if (c.asked.has_own_heights || c.asked.has_own_counts) {
    json["thickness"]["asked_range"] = {c.asked_thickness.min, c.asked_thickness.max};
  }
  json["limits"] = by_reason(c.limit_percent);
  json["limited_lines"] = by_reason(patch.limited_lines);
  json["min_coverage"] = patch.min_coverage;
  return json;
}

Json limited_json(const Report& report) {
  Json json = {{"asked", report.limited.n_lines},
               {"limited", report.limited.n_limited()},
               {"at_wall", report.limited.n_at_wall()},
               {"reasons", Json::object()}};
  for (std::size_t r = 1; r < mesh::kNLimitReasons; ++r) {
    const quality::ReasonLines& lines = report.limited.by_reason[r];
    if (lines.n_lines == 0) continue;
    Json worst = Json::array();
    for (const quality::LimitedVertex& v : lines.worst) {
      worst.push_back({{"where", point_json(v.place)},
                       {"patch", report.patches[v.patch.index()].name},
                       {"vertex", v.vertex.index()},
                       {"lines", v.n_lines},
                       {"levels", v.levels},
                       {"thickness", v.reached},
                       {"asked", v.asked}});
    }
    json["reasons"][std::string(mesh::kLimitReasonNames[r])] = {
        {"lines", lines.n_lines}, {"at_wall", lines.n_at_wall}, {"worst", std::move(worst)}};
  }
  return json;
}

Json surface_json(const SurfaceReport& s) {
  return {{"points", s.points},
          {"triangles", s.triangles},
          {"components", s.components},
          {"unwetted_components", s.unwetted_components},
          {"merged_points", s.merged_points},
          {"ridges", {{"convex", s.convex_ridges}, {"concave", s.concave_ridges}}},
          {"corners", s.corners},
          {"ridge_ends", s.ridge_ends},
          {"tips", s.tips},
          {"blind", s.blind},
          {"repairs", s.repairs}};
}

Json forecast_json(const Forecast& f) {
  return {{"cells", f.n_cells},
          {"tetrahedra", f.n_tetrahedra},
          {"points", f.n_points},
          {"memory_bytes", f.memory_bytes},
          {"disk_bytes", f.disk_bytes},
          {"box", {{"low", point_json(f.box.low)}, {"high", point_json(f.box.high)}, {"diagonal", f.box.diagonal()}}}};
}

Json cells_json(const Report& report) {
  Json json;
  for (std::size_t t = 0; t < mesh::kNCellTypes; ++t) json[std::string(mesh::kCellTypeNames[t])] = report.cells[t];
  return json;
}

Json quality_json(const quality::LayerQuality& q) {
  return {{"scaled_jacobian", statistics_json(q.scaled_jacobian)},
          {"orthogonality", statistics_json(q.orthogonality)},
          {"growth", statistics_json(q.growth)},
          {"aspect_ratio", statistics_json(q.aspect_ratio)},
          {"volume_ratio", statistics_json(q.volume_ratio)}};
}

Json certificate_json(const certify::Certificate& c) {
  return {{"columns_not_positive", c.n_bad_columns},
          {"turned_sides", c.n_turned_sides},
          {"front_intersections", c.n_front_intersections},
          {"covered_twice", c.n_covered_twice}};
}

/// Of the whole mesh; without a fill, of the layers.
Json volume_json(const Report& report) {
  if (!report.volume) {
    return {{"cells", report.certificate.cells_volume},
            {"domain", report.certificate.enclosed_volume},
            {"closure", report.certificate.closure()}};
  }
  const VolumeReport& v = *report.volume;
  Json json = {{"cells", v.certificate.cells_volume},
               {"domain", v.certificate.enclosed_volume},
               {"closure", v.certificate.closure()},
               {"layers", report.certificate.cells_volume},
               {"tetrahedra", v.tetrahedra},
               {"quality",
                {{"smallest_dihedral", statistics_json(v.quality.smallest_dihedral)},
                 {"radius_edge", statistics_json(v.quality.radius_edge)},
                 {"size_ratio", statistics_json(v.quality.size_ratio)},
                 {"interface_ratio", statistics_json(v.quality.interface_ratio)}}}};
  json["boundary"] = Json::object();
  for (std::size_t p = 0; p < v.boundary.size(); ++p) {
    const BoundaryPatch& patch = v.boundary[p];
    if (patch.triangles + patch.quads == 0) continue;
    json["boundary"][report.patches[p].name] = {
        {"triangles", patch.triangles}, {"quads", patch.quads}, {"area", patch.area}};
  }
  return json;
}

/// Keys of one table that have a value; tables of tables are nested.
void add_value(Json& to, const Key& key, const CaseValue& value) {
  if (std::holds_alternative<std::monostate>(value)) return;
  Json* table = &to;
  for (std::string_view rest = key.table; !rest.empty();) {
    const std::size_t dot = std::min(rest.find('.'), rest.size());
    table = &(*table)[std::string(rest.substr(0, dot))];
    rest.remove_prefix(std::min(dot + 1, rest.size()));
  }
  (*table)[std::string(key.name)] = to_json_value(value);
}

Json rule_json(const Case& settings, const PatchRule& rule) {
  Json json = Json::object();
  if (rule.type) json["type"] = type_name(*rule.type);
  for (const Key& key : pipeline::case_keys()) {
    // Keys with a default always have a value: they are of the rule only where the rule differs from an empty one.
    if (key.table != "layers" || !key.get) continue;
    const CaseValue value = key.get(settings, rule.layers);
    if (value != key.get(settings, LayerSettings())) json[std::string(key.name)] = to_json_value(value);
  }
  return json;
}

}  // namespace

namespace pipeline {

Json case_json(const Case& settings) {
  Json json = Json::object();
  for (const Key& key : case_keys()) {
    if (key.table == "patches") {
      json["patches"] = Json::object();
      for (const PatchRule& rule : settings.patches) json["patches"][rule.pattern] = rule_json(settings, rule);
    } else if (key.get) {
      add_value(json, key, key.get(settings, settings.layers));
    }
  }
  return json;
}

}  // namespace pipeline

std::string to_json(const Report& report) {
  Json json;
  json["name"] = report.name;
  json["version"] = report.version;
  json["certified"] = report.certified;
  if (report.dry_run) json["dry_run"] = true;
  json["input"] = {{"file", report.input_file}, {"sha256", report.input_sha256}};
  json["surface"] = surface_json(report.surface);
  json["forecast"] = forecast_json(report.forecast);
  if (!report.dry_run) {
    json["cells"] = cells_json(report);
    json["points"] = report.points;
    json["patches"] = Json::object();
    for (const PatchReport& patch : report.patches) json["patches"][patch.name] = patch_json(patch);
    json["limited_lines"] = limited_json(report);
    json["is_short_of_coverage"] = report.is_short_of_coverage();
    json["quality"] = quality_json(report.quality);
    json["certificate"] = certificate_json(report.certificate);
    json["volume"] = volume_json(report);
    if (!report.volume_failure.empty()) json["volume_failure"] = report.volume_failure;
    json["rounds"] = report.rounds;
    json["smoothing_iterations"] = report.smoothing_iterations;
  }
  json["stages"] = Json::array();
  for (const StageTime& stage : report.stages)
    json["stages"].push_back({{"name", stage.name}, {"seconds", stage.seconds}});
  json["peak_memory_bytes"] = report.peak_memory_bytes;
  json["case"] = pipeline::case_json(report.settings);
  json["files"] = report.files;
  json["notes"] = report.notes;
  json["warnings"] = report.warnings;
  // Names of patches and files come from outside: what is not UTF-8 is replaced rather than refused.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace nearwall
