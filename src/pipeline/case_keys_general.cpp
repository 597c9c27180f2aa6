#include <algorithm>
#include <array>

#include "pipeline/case_keys.h"

namespace nearwall {

namespace {

/// In the order of PatchType.
constexpr std::array<std::string_view, 6> kTypeNames = {"wall", "nolayer", "symmetry", "inlet", "outlet", "farfield"};

}  // namespace

std::string_view type_name(PatchType type) { return kTypeNames[static_cast<std::size_t>(type)]; }

namespace pipeline {

namespace {

double number(const CaseValue& v) { return std::get<double>(v); }
const std::string& text(const CaseValue& v) { return std::get<std::string>(v); }

CaseValue or_auto(const std::optional<double>& v) { return v ? CaseValue(*v) : CaseValue(std::string(kAuto)); }

/// A flow exists from its first key on; that all three are there is checked where y_plus needs them.
spacing::FlowConditions& flow(Target t) {
  if (!t.settings.flow) t.settings.flow.emplace();
  return *t.settings.flow;
}
CaseValue flow_value(const Case& c, double spacing::FlowConditions::*member) {
  return c.flow && (*c.flow).*member > 0 ? CaseValue((*c.flow).*member) : CaseValue();
}

/// Each once.
std::vector<io::MeshFormat> formats(const CaseValue& v) {
  std::vector<io::MeshFormat> formats;
  for (const std::string& name : std::get<std::vector<std::string>>(v)) {
    const io::MeshFormat format = *io::mesh_format(name);
    if (std::find(formats.begin(), formats.end(), format) == formats.end()) formats.push_back(format);
  }
  return formats;
}

CaseValue format_names(const Case& c) {
  std::vector<std::string> names;
  for (const io::MeshFormat format : c.output.formats) names.emplace_back(io::name_of(format));
  return names;
}

std::vector<Key> top_keys() {
  std::vector<Key> keys;
  keys.push_back({.name = "format",
                  .kind = Kind::Integer,
                  .default_text = "1",
                  .range = {1, 1},
                  .doc = "version of this format",
                  .set = [](Target, const CaseValue&) {},
                  .get = [](const Case&, const LayerSettings&) { return CaseValue(std::int64_t{1}); }});
  keys.push_back({.name = "name",
                  .kind = Kind::Text,
                  .example = "\"onera-m6\"",
                  .doc = "of the output files; without it the name of the surface file",
                  .set = [](Target t, const CaseValue& v) { t.settings.name = text(v); },
                  .get = [](const Case& c, const LayerSettings&) { return CaseValue(c.output_name()); }});
  return keys;
}

std::vector<Key> surface_keys() {
  std::vector<Key> keys;
  keys.push_back({.table = "surface",
                  .name = "file",
                  .kind = Kind::Text,
                  .example = "\"surface.stl\"",
                  .doc = "relative to this file: stl obj ply off vtp vtk, also .gz; msh su2 cgns ugrid bdf",
                  .set = [](Target t, const CaseValue& v) { t.settings.surface.file = text(v); },
                  .get = [](const Case& c, const LayerSettings&) { return CaseValue(c.surface.file.string()); }});
  keys.push_back({.table = "surface",
                  .name = "scale",
                  .default_text = "1.0",
                  .range = {0, std::numeric_limits<double>::infinity(), true},
                  .doc = "multiplies the coordinates on reading; every other length is in the scaled unit",
                  .set = [](Target t, const CaseValue& v) { t.settings.surface.scale = number(v); },
                  .get = [](const Case& c, const LayerSettings&) { return CaseValue(c.surface.scale); }});
  keys.push_back({.table = "surface",
                  .name = "fluid",
                  .kind = Kind::Choice,
                  .default_text = "\"outside\"",
                  .choices = {"outside", "inside"},
                  .doc = "the side of the wall on which the fluid lies",
                  .set =
                      [](Target t, const CaseValue& v) {
                        using surface::FluidSide;
                        t.settings.surface.fluid = text(v) == "inside" ? FluidSide::Inside : FluidSide::Outside;
                      },
                  .get =
                      [](const Case& c, const LayerSettings&) {
                        const bool inside = c.surface.fluid == surface::FluidSide::Inside;
                        return CaseValue(std::string(inside ? "inside" : "outside"));
                      }});
  keys.push_back({.table = "surface",
                  .name = "weld",
                  .takes_auto = true,
                  .unit = "length",
                  .default_text = "\"auto\"",
                  .range = {0},
                  .doc = "points nearer than this become one; auto: bitwise equal ones",
                  .set =
                      [](Target t, const CaseValue& v) {
                        t.settings.surface.weld = is_auto(v) ? std::nullopt : std::optional<double>(number(v));
                      },
                  .get = [](const Case& c, const LayerSettings&) { return or_auto(c.surface.weld); }});
  keys.push_back({.table = "surface",
                  .name = "repair",
                  .kind = Kind::Choice,
                  .default_text = "\"none\"",
                  .choices = {"none", "safe"},
                  .doc = "safe: the repairs that cannot change the shape",
                  .set =
                      [](Target t, const CaseValue& v) {
                        using surface::Repair;
                        t.settings.surface.repair = text(v) == "safe" ? Repair::Safe : Repair::None;
                      },
                  .get =
                      [](const Case& c, const LayerSettings&) {
                        return CaseValue(std::string(c.surface.repair == surface::Repair::Safe ? "safe" : "none"));
                      }});
  return keys;
}

std::vector<Key> patch_keys() {
  std::vector<Key> keys;
  keys.push_back({.table = "patches",
                  .name = "type",
                  .kind = Kind::Choice,
                  .default_text = "\"wall\"",
                  .choices = {kTypeNames.begin(), kTypeNames.end()},
                  .doc = "wall gets layers, nolayer stays as it is, the others bound the volume (docs/volume.md); keys "
                         "of [layers] may be given here, too",
                  .set = [](Target t, const CaseValue& v) { t.rule->type = enumerator<PatchType>(kTypeNames, v); },
                  .get = nullptr});
  return keys;
}

std::vector<Key> normals_keys() {
  std::vector<Key> keys;
  keys.push_back({.table = "features",
                  .name = "ridge_angle",
                  .unit = "degrees",
                  .default_text = "40.0",
                  .range = {1, 179},
                  .doc = "turn (angle between the two face normals) from which an edge is a ridge",
                  .set = [](Target t, const CaseValue& v) { t.settings.ridge_angle_deg = number(v); },
                  .get = [](const Case& c, const LayerSettings&) { return CaseValue(c.ridge_angle_deg); }});
  keys.push_back({.table = "normals",
                  .name = "method",
                  .kind = Kind::Choice,
                  .default_text = "\"most-visible\"",
                  .choices = {surface::kNormalMethodNames.begin(), surface::kNormalMethodNames.end()},
                  .doc = "direction of a line where one normal has to see several faces",
                  .set = [](Target t, const CaseValue& v) { t.settings.normals = *surface::normal_method(text(v)); },
                  .get = [](const Case& c,
                            const LayerSettings&) { return CaseValue(std::string(surface::method_name(c.normals))); }});
  keys.push_back(
      {.table = "normals",
       .name = "multi",
       .kind = Kind::Boolean,
       .takes_auto = true,
       .default_text = "\"auto\"",
       .doc = "several lines at convex ridges and corners that need them; false: one for each point",
       .set = [](Target t, const CaseValue& v) { t.settings.is_multi_allowed = is_auto(v) || std::get<bool>(v); },
       .get =
           [](const Case& c, const LayerSettings&) {
             return c.is_multi_allowed ? CaseValue(std::string(kAuto)) : CaseValue(false);
           }});
  keys.push_back(
      {.table = "normals",
       .name = "multi_angle",
       .unit = "degrees",
       .default_text = "100.0",
       .range = {1, 179},
       .doc = "turn of a convex ridge from which it always gets several lines; from 60 on where they keep more",
       .set = [](Target t, const CaseValue& v) { t.settings.multi_angle_deg = number(v); },
       .get = [](const Case& c, const LayerSettings&) { return CaseValue(c.multi_angle_deg); }});
  keys.push_back({.table = "normals",
                  .name = "max_turn",
                  .unit = "degrees",
                  .default_text = "45.0",
                  .range = {5, 90},
                  .doc = "largest angle between two neighbouring lines of a fan",
                  .set = [](Target t, const CaseValue& v) { t.settings.max_turn_deg = number(v); },
                  .get = [](const Case& c, const LayerSettings&) { return CaseValue(c.max_turn_deg); }});
  return keys;
}

std::vector<Key> smoothing_keys() {
  std::vector<Key> keys;
  keys.push_back(
      {.table = "smoothing",
       .name = "filter",
       .kind = Kind::Choice,
       .default_text = "\"taubin\"",
       .choices = {surface::kSmoothingFilterNames.begin(), surface::kSmoothingFilterNames.end()},
       .doc = "how the directions of the lines are evened out",
       .set = [](Target t, const CaseValue& v) { t.settings.smoothing.filter = *surface::smoothing_filter(text(v)); },
       .get = [](const Case& c,
                 const LayerSettings&) { return CaseValue(std::string(surface::filter_name(c.smoothing.filter))); }});
  keys.push_back({.table = "smoothing",
                  .name = "iterations",
                  .kind = Kind::Integer,
                  .takes_auto = true,
                  .default_text = "\"auto\"",
                  .range = {0, 1000},
                  .doc = "sweeps; auto: 2",
                  .set =
                      [](Target t, const CaseValue& v) {
                        t.settings.smoothing.iterations =
                            is_auto(v) ? std::nullopt : std::optional<int>(static_cast<int>(std::get<std::int64_t>(v)));
                      },
                  .get =
                      [](const Case& c, const LayerSettings&) {
                        return c.smoothing.iterations ? CaseValue(std::int64_t{*c.smoothing.iterations})
                                                      : CaseValue(std::string(kAuto));
                      }});
  return keys;
}

std::vector<Key> flow_keys() {
  using spacing::FlowConditions;
  constexpr Range kPositive = {0, std::numeric_limits<double>::infinity(), true};
  std::vector<Key> keys;
  keys.push_back({.table = "flow",
                  .name = "velocity",
                  .unit = "length/time",
                  .example = "50.0",
                  .range = kPositive,
                  .doc = "of the free stream; for y_plus",
                  .set = [](Target t, const CaseValue& v) { flow(t).velocity = number(v); },
                  .get = [](const Case& c, const LayerSettings&) { return flow_value(c, &FlowConditions::velocity); }});
  keys.push_back(
      {.table = "flow",
       .name = "kinematic_viscosity",
       .unit = "length²/time",
       .example = "1.5e-5",
       .range = kPositive,
       .doc = "for y_plus",
       .set = [](Target t, const CaseValue& v) { flow(t).kinematic_viscosity = number(v); },
       .get = [](const Case& c, const LayerSettings&) { return flow_value(c, &FlowConditions::kinematic_viscosity); }});
  keys.push_back(
      {.table = "flow",
       .name = "reference_length",
       .unit = "length",
       .example = "1.0",
       .range = kPositive,
       .doc = "run of the boundary layer; for y_plus",
       .set = [](Target t, const CaseValue& v) { flow(t).reference_length = number(v); },
       .get = [](const Case& c, const LayerSettings&) { return flow_value(c, &FlowConditions::reference_length); }});
  return keys;
}

std::vector<Key> output_keys() {
  std::vector<Key> keys;
  keys.push_back({.table = "output",
                  .name = "directory",
                  .kind = Kind::Text,
                  .default_text = "\"out\"",
                  .doc = "relative to this file",
                  .set = [](Target t, const CaseValue& v) { t.settings.output.directory = text(v); },
                  .get = [](const Case& c, const LayerSettings&) { return CaseValue(c.output.directory.string()); }});
  keys.push_back({.table = "output",
                  .name = "formats",
                  .kind = Kind::Choices,
                  .default_text = "[\"vtu\"]",
                  .choices = {io::kMeshFormatNames.begin(), io::kMeshFormatNames.end()},
                  .doc = "of the mesh (docs/formats.md)",
                  .set = [](Target t, const CaseValue& v) { t.settings.output.formats = formats(v); },
                  .get = [](const Case& c, const LayerSettings&) { return format_names(c); }});
  keys.push_back({.table = "output",
                  .name = "report",
                  .kind = Kind::Boolean,
                  .default_text = "true",
                  .doc = "report.json and report.html",
                  .set = [](Target t, const CaseValue& v) { t.settings.output.report = std::get<bool>(v); },
                  .get = [](const Case& c, const LayerSettings&) { return CaseValue(c.output.report); }});
  keys.push_back({.table = "output",
                  .name = "pictures",
                  .kind = Kind::Boolean,
                  .default_text = "true",
                  .doc = "PNG pictures of the surface and the layers",
                  .set = [](Target t, const CaseValue& v) { t.settings.output.pictures = std::get<bool>(v); },
                  .get = [](const Case& c, const LayerSettings&) { return CaseValue(c.output.pictures); }});
  return keys;
}

}  // namespace

std::vector<Key> general_keys() {
  std::vector<Key> keys;
  for (const auto& part :
       {top_keys(), surface_keys(), patch_keys(), normals_keys(), smoothing_keys(), flow_keys(), output_keys()}) {
    keys.insert(keys.end(), part.begin(), part.end());
  }
  return keys;
}

}  // namespace pipeline

}  // namespace nearwall
