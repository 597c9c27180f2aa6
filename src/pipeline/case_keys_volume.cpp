#include <array>

#include "pipeline/case_keys.h"

namespace nearwall::pipeline {

namespace {

constexpr Range kPositive = {0, std::numeric_limits<double>::infinity(), true};
/// Beyond, a tetrahedron is more a bridge over its neighbours than one of them.
constexpr double kLargestGrowth = 3;
/// In the order of Fill.
constexpr std::array<std::string_view, 2> kFillNames = {"none", "tetgen"};
/// In the order of FarFieldShape.
constexpr std::array<std::string_view, 3> kShapeNames = {"sphere", "box", "given"};

template <std::optional<double> FarFieldSettings::*member>
void set_length(Target t, const CaseValue& v) {
  t.settings.volume.far_field.*member = is_auto(v) ? std::nullopt : std::optional(std::get<double>(v));
}
template <std::optional<double> FarFieldSettings::*member>
CaseValue get_length(const Case& c, const LayerSettings&) {
  const auto& length = c.volume.far_field.*member;
  return length ? CaseValue(*length) : CaseValue(std::string(kAuto));
}

template <std::optional<Vec3> FarFieldSettings::*member>
void set_point(Target t, const CaseValue& v) {
  auto& point = t.settings.volume.far_field.*member;
  point.reset();
  if (is_auto(v)) return;
  const auto& numbers = std::get<std::vector<double>>(v);
  point.emplace(numbers[0], numbers[1], numbers[2]);
}
CaseValue point_value(const std::optional<Vec3>& point, const CaseValue& otherwise) {
  return point ? CaseValue(std::vector<double>{point->x(), point->y(), point->z()}) : otherwise;
}

std::vector<Key> fill_keys() {
  return {{.table = "volume",
           .name = "fill",
           .kind = Kind::Choice,
           .default_text = "\"none\"",
           .choices = {kFillNames.begin(), kFillNames.end()},
           .doc = "what fills the volume beyond the layers; none: the layers alone are written",
           .set = [](Target t, const CaseValue& v) { t.settings.volume.fill = enumerator<Fill>(kFillNames, v); },
           .get =
               [](const Case& c, const LayerSettings&) {
                 return CaseValue(std::string(kFillNames[static_cast<std::size_t>(c.volume.fill)]));
               }},
          {.table = "volume",
           .name = "growth",
           .default_text = "1.3",
           .range = {1, kLargestGrowth, true},
           .doc = "length of an edge over that of the one before, away from the layers",
           .set = [](Target t, const CaseValue& v) { t.settings.volume.growth = std::get<double>(v); },
           .get = [](const Case& c, const LayerSettings&) { return CaseValue(c.volume.growth); }},
          {.table = "volume",
           .name = "symmetry",
           .kind = Kind::Planes,
           .default_text = "[]",
           .doc = "planes across an axis that bound the domain of a half body; without `at` where the surface is open, "
                  "else at 0",
           .set = [](Target t,
                     const CaseValue& v) { t.settings.volume.symmetry = std::get<std::vector<SymmetrySetting>>(v); },
           .get = [](const Case& c, const LayerSettings&) { return CaseValue(c.volume.symmetry); }}};
}

std::vector<Key> far_field_keys() {
  using Settings = FarFieldSettings;
  return {
      {.table = "volume.farfield",
       .name = "shape",
       .kind = Kind::Choice,
       .default_text = "\"sphere\"",
       .choices = {kShapeNames.begin(), kShapeNames.end()},
       .doc = "of the outer boundary where the fluid lies outside; given: the patches of type farfield of the "
              "surface file, with fluid = \"inside\"",
       .set = [](Target t,
                 const CaseValue& v) { t.settings.volume.far_field.shape = enumerator<FarFieldShape>(kShapeNames, v); },
       .get =
           [](const Case& c, const LayerSettings&) {
             return CaseValue(std::string(kShapeNames[static_cast<std::size_t>(c.volume.far_field.shape)]));
           }},
      {.table = "volume.farfield",
       .name = "radius",
       .takes_auto = true,
       .unit = "length",
       .default_text = "\"auto\"",
       .range = kPositive,
       .doc = "of the sphere; of a box half its edge; auto: 50 diagonals of the surface",
       .set = set_length<&Settings::radius>,
       .get = get_length<&Settings::radius>},
      {.table = "volume.farfield",
       .name = "size",
       .takes_auto = true,
       .unit = "length",
       .default_text = "\"auto\"",
       .range = kPositive,
       .doc = "of the edges of its triangles; auto: as large as tetrahedra have grown on their way there",
       .set = set_length<&Settings::size>,
       .get = get_length<&Settings::size>},
      {.table = "volume.farfield",
       .name = "centre",
       .kind = Kind::Point,
       .takes_auto = true,
       .unit = "length",
       .default_text = "\"auto\"",
       .doc = "auto: that of the surface's box",
       .set = set_point<&Settings::centre>,
       .get = [](const Case& c,
                 const LayerSettings&) { return point_value(c.volume.far_field.centre, std::string(kAuto)); }},
      {.table = "volume.farfield",
       .name = "lower",
       .kind = Kind::Point,
       .unit = "length",
       .example = "[-10.0, -10.0, -10.0]",
       .doc = "shape \"box\": its lower corner, together with upper; instead of radius and centre",
       .set = set_point<&Settings::lower>,
       .get = [](const Case& c, const LayerSettings&) { return point_value(c.volume.far_field.lower, {}); }},
      {.table = "volume.farfield",
       .name = "upper",
       .kind = Kind::Point,
       .unit = "length",
       .example = "[20.0, 10.0, 10.0]",
       .doc = "its upper corner",
       .set = set_point<&Settings::upper>,
       .get = [](const Case& c, const LayerSettings&) { return point_value(c.volume.far_field.upper, {}); }}};
}

}  // namespace

std::vector<Key> volume_keys() {
  std::vector<Key> keys = fill_keys();
  const std::vector<Key> far_field = far_field_keys();
  keys.insert(keys.end(), far_field.begin(), far_field.end());
  return keys;
}

}  // namespace nearwall::pipeline
