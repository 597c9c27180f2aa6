#include <array>

#include "pipeline/case_keys.h"

namespace nearwall::pipeline {

namespace {

constexpr Range kPositive = {0, std::numeric_limits<double>::infinity(), true};
constexpr Range kGrowthRange = {1, spacing::kMaxGrowth};
/// In the order of OnConflict.
constexpr std::array<std::string_view, 3> kConflictNames = {"auto", "compress", "stair"};
/// In the order of Until.
constexpr std::array<std::string_view, 2> kUntilNames = {"count", "isotropic"};
constexpr Range kCountRange = {1, spacing::kMaxCount};

template <std::optional<double> LayerSettings::*member>
void set_number(Target t, const CaseValue& v) {
  t.layers.*member = std::get<double>(v);
}
template <std::optional<double> LayerSettings::*member>
CaseValue get_number(const Case&, const LayerSettings& l) {
  return l.*member ? CaseValue(*(l.*member)) : CaseValue();
}

template <std::optional<double> LayerSettings::*member, std::optional<ArrayLength> LayerSettings::*array>
void set_length(Target t, const CaseValue& v) {
  t.layers.*member = std::get<double>(v);
  (t.layers.*array).reset();
}
template <std::optional<double> LayerSettings::*member, std::optional<ArrayLength> LayerSettings::*array>
CaseValue get_length(const Case& c, const LayerSettings& l) {
  return l.*array ? CaseValue(*(l.*array)) : get_number<member>(c, l);
}
template <std::optional<double> LayerSettings::*member, std::optional<ArrayLength> LayerSettings::*array>
ArrayLength& array_of(LayerSettings& l) {
  (l.*member).reset();
  if (!(l.*array)) (l.*array).emplace();
  return *(l.*array);
}

template <std::optional<int> LayerSettings::*member>
void set_integer(Target t, const CaseValue& v) {
  t.layers.*member = static_cast<int>(std::get<std::int64_t>(v));
}
template <std::optional<int> LayerSettings::*member>
CaseValue get_integer(const Case&, const LayerSettings& l) {
  return l.*member ? CaseValue(std::int64_t{*(l.*member)}) : CaseValue();
}

void set_law(Target t, const CaseValue& v) {
  for (const auto law :
       {spacing::Law::Geometric, spacing::Law::Accelerating, spacing::Law::Tanh, spacing::Law::Table}) {
    if (std::get<std::string>(v) == spacing::law_name(law)) t.layers.law = law;
  }
}

/// The four quantities, y_plus and until.
std::vector<Key> quantities() {
  return {{.table = "layers",
           .name = "first_height",
           .unit = "length",
           .example = "1e-5",
           .range = kPositive,
           .doc = "height of the first layer; may be a point array of the surface file (docs/spacing.md)",
           .set = set_length<&LayerSettings::first_height, &LayerSettings::first_height_array>,
           .array = array_of<&LayerSettings::first_height, &LayerSettings::first_height_array>,
           .get = get_length<&LayerSettings::first_height, &LayerSettings::first_height_array>},
          {.table = "layers",
           .name = "y_plus",
           .example = "1.0",
           .range = kPositive,
           .doc = "instead of first_height, together with [flow]",
           .set = set_number<&LayerSettings::y_plus>,
           .get = get_number<&LayerSettings::y_plus>},
          {.table = "layers",
           .name = "growth",
           .example = "1.2",
           .range = kGrowthRange,
           .doc = "height of a layer over that of the one below; 1.2 where fewer than three quantities are given",
           .set = set_number<&LayerSettings::growth>,
           .get = get_number<&LayerSettings::growth>},
          {.table = "layers",
           .name = "count",
           .kind = Kind::Integer,
           .unit = "layers",
           .example = "30",
           .range = kCountRange,
           .doc = "number of layers; 30 where only growth and a length are given; the most with until = \"isotropic\"",
           .set = set_integer<&LayerSettings::count>,
           .get = get_integer<&LayerSettings::count>},
          {.table = "layers",
           .name = "total_thickness",
           .unit = "length",
           .example = "0.01",
           .range = kPositive,
           .doc = "of all layers, may be a point array, too; any three of first_height, growth, count, total_thickness "
                  "give the fourth",
           .set = set_length<&LayerSettings::total_thickness, &LayerSettings::total_thickness_array>,
           .array = array_of<&LayerSettings::total_thickness, &LayerSettings::total_thickness_array>,
           .get = get_length<&LayerSettings::total_thickness, &LayerSettings::total_thickness_array>},
          {.table = "layers",
           .name = "until",
           .kind = Kind::Choice,
           .default_text = "\"count\"",
           .choices = {kUntilNames.begin(), kUntilNames.end()},
           .doc = "where lines end: at the last layer; or where layers are as high as their triangles are wide",
           .set = [](Target t, const CaseValue& v) { t.layers.until = enumerator<Until>(kUntilNames, v); },
           .get =
               [](const Case&, const LayerSettings& l) {
                 return CaseValue(std::string(kUntilNames[std::size_t(l.until.value_or(Until::Count))]));
               }}};
}

std::vector<Key> laws() {
  return {{.table = "layers",
           .name = "law",
           .kind = Kind::Choice,
           .default_text = "\"geometric\"",
           .choices = {"geometric", "accelerating", "tanh", "table"},
           .doc = "how heights grow (docs/spacing.md)",
           .set = set_law,
           .get = [](const Case&,
                     const LayerSettings& l) { return CaseValue(std::string(spacing::law_name(l.law_in_force()))); }},
          {.table = "layers",
           .name = "heights",
           .kind = Kind::Numbers,
           .unit = "length",
           .example = "[1e-5, 1e-5, 2e-5]",
           .range = kPositive,
           .doc = "law \"table\": the heights one by one, from the wall up",
           .set = [](Target t, const CaseValue& v) { t.layers.heights = std::get<std::vector<double>>(v); },
           .get = [](const Case&,
                     const LayerSettings& l) { return l.heights.empty() ? CaseValue() : CaseValue(l.heights); }},
          {.table = "layers",
           .name = "constant_layers",
           .kind = Kind::Integer,
           .unit = "layers",
           .example = "5",
           .range = kCountRange,
           .doc = "law \"accelerating\": layers of one height at the wall; 5",
           .set = set_integer<&LayerSettings::constant_layers>,
           .get = get_integer<&LayerSettings::constant_layers>},
          {.table = "layers",
           .name = "acceleration",
           .example = "0.05",
           .range = {0, 1},
           .doc = "law \"accelerating\": by which fraction the growth rises from layer to layer; 0.05",
           .set = set_number<&LayerSettings::acceleration>,
           .get = get_number<&LayerSettings::acceleration>},
          {.table = "layers",
           .name = "largest_growth",
           .example = "1.5",
           .range = kGrowthRange,
           .doc = "law \"accelerating\": the growth stays there; 1.5",
           .set = set_number<&LayerSettings::largest_growth>,
           .get = get_number<&LayerSettings::largest_growth>}};
}

std::vector<Key> conflicts() {
  return {
      {.table = "layers",
       .name = "on_conflict",
       .kind = Kind::Choice,
       .default_text = "\"auto\"",
       .choices = {kConflictNames.begin(), kConflictNames.end()},
       .doc = "where there is no room: layers become thinner (compress) or fewer (stair); auto: docs/layers.md",
       .set = [](Target t, const CaseValue& v) { t.layers.on_conflict = enumerator<OnConflict>(kConflictNames, v); },
       .get =
           [](const Case&, const LayerSettings& l) {
             const auto chosen = l.on_conflict.value_or(OnConflict::Auto);
             return CaseValue(std::string(kConflictNames[static_cast<std::size_t>(chosen)]));
           }},
      {.table = "layers",
       .name = "max_level_step",
       .kind = Kind::Integer,
       .takes_auto = true,
       .unit = "layers",
       .default_text = "\"auto\"",
       .range = kCountRange,
       .doc = "by which a line may end above a neighbour that moves; auto: any number, 1 with until = \"isotropic\"",
       .set =
           [](Target t, const CaseValue& v) {
             t.layers.max_level_step = is_auto(v) ? 0 : static_cast<int>(std::get<std::int64_t>(v));
           },
       .get =
           [](const Case&, const LayerSettings& l) {
             const int step = l.max_level_step.value_or(0);
             return step > 0 ? CaseValue(std::int64_t{step}) : CaseValue(std::string(kAuto));
           }},
      {.table = "layers",
       .name = "min_coverage",
       .unit = "percent",
       .default_text = "0.0",
       .range = {0, 100},
       .doc = "of each wall patch with all layers; under it the exit code is 4",
       .set = set_number<&LayerSettings::min_coverage>,
       .get = [](const Case&, const LayerSettings& l) { return CaseValue(l.min_coverage.value_or(0)); }}};
}

}  // namespace

std::vector<Key> layer_keys() {
  std::vector<Key> keys = quantities();
  for (const auto& part : {laws(), conflicts()}) keys.insert(keys.end(), part.begin(), part.end());
  return keys;
}

}  // namespace nearwall::pipeline
