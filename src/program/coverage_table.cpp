#include "program/coverage_table.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "program/row_names.h"
#include "program/table.h"

namespace nearwall::program {

namespace {

constexpr std::size_t kMostRows = 20;
constexpr std::size_t kLongestName = 19;
constexpr std::size_t kMostReasons = 2;
constexpr double kPercent = 100;

bool has_layers(const PatchReport& patch) { return patch.type == PatchType::Wall && patch.coverage.area > 0; }

double limited_area(const PatchReport& patch) {
  return has_layers(patch) ? patch.coverage.area * (kPercent - patch.coverage.full_percent) : -1;
}

/// Several patches as one: shares by area. What is missing is summed, so that nothing missing is 100 exactly.
quality::PatchCoverage put_together(const std::vector<const PatchReport*>& patches) {
  using quality::PatchCoverage;
  constexpr std::array kShares = {&PatchCoverage::all_layers_percent, &PatchCoverage::full_percent,
                                  &PatchCoverage::first_height_met_percent};
  PatchCoverage sum;
  sum.has_layers = false;
  double all_area = 0;
  std::array<double, kShares.size()> missing{};
  for (const PatchReport* patch : patches) {
    const PatchCoverage& c = patch->coverage;
    all_area += c.area;
    if (!has_layers(*patch)) continue;
    sum.asked.count = !sum.has_layers || sum.asked.count == c.asked.count ? c.asked.count : Level{0};
    sum.has_layers = true;
    sum.area += c.area;
    sum.mean_layers += c.area * c.mean_layers;
    for (std::size_t i = 0; i < missing.size(); ++i) missing[i] += c.area * (kPercent - c.*kShares[i]);
    for (std::size_t r = 0; r < c.limit_percent.size(); ++r) sum.limit_percent[r] += c.area * c.limit_percent[r];
  }
  for (std::size_t i = 0; i < missing.size(); ++i) sum.*kShares[i] = kPercent - missing[i] / sum.area;
  for (double& percent : sum.limit_percent) percent /= sum.area;
  sum.mean_layers /= sum.area;
  sum.area = all_area;
  return sum;
}

std::string why_without_layers(PatchType type) {
  if (type == PatchType::Wall) return "out of the fluid's reach";
  return type == PatchType::NoLayer ? "no layers asked" : std::string(type_name(type));
}

class CoverageTable {
 public:
  explicit CoverageTable(bool is_whole) : is_whole_(is_whole) {}

  void add(const std::string& name, const PatchReport& patch) {
    const quality::PatchCoverage& c = patch.coverage;
    if (!has_layers(patch)) {
      add_without_layers(name, c.area, why_without_layers(patch.type));
      return;
    }
    const double asked = c.asked.total_thickness;
    add_row(name, c, fmt::format("{:.3g}", c.thickness.median),
            asked > 0 ? percent_in_words(kPercent * c.thickness.median / asked) : "-");
  }

  void add_together(const std::string& name, const std::vector<const PatchReport*>& patches) {
    const quality::PatchCoverage sum = put_together(patches);
    if (sum.has_layers) {
      add_row(name, sum, "-", "-");
    } else {
      add_without_layers(name, sum.area, "no layers asked");
    }
  }

  std::string text() const { return table_.to_text("  "); }

 private:
  void add_row(const std::string& name, const quality::PatchCoverage& c, const std::string& thickness,
               const std::string& thickness_percent) {
    table_.add_row({name, fmt::format("{:.3g}", c.area), percent_in_words(c.all_layers_percent),
                    percent_in_words(c.full_percent),
                    c.asked.count > 0 ? fmt::format("{:.1f} of {}", c.mean_layers, c.asked.count)
                                      : fmt::format("{:.1f}", c.mean_layers),
                    percent_in_words(c.first_height_met_percent), thickness, thickness_percent,
                    reasons_in_words(c, is_whole_ ? mesh::kNLimitReasons : kMostReasons)});
  }

  void add_without_layers(const std::string& name, double area, const std::string& why) {
    table_.add_row({name, fmt::format("{:.3g}", area), "-", "-", "-", "-", "-", "-", why});
  }

  bool is_whole_;
  Table table_{{{"patch"},
                {"area", true},
                {"all %", true},
                {"full %", true},
                {"layers", true},
                {"first %", true},
                {"thickness", true},
                {"reached %", true},
                {"limited by, % of area"}}};
};

/// Patches that get a row of their own: those with most of what is missing, then the largest.
std::vector<char> choose_rows(const std::vector<PatchReport>& patches, std::size_t n) {
  std::vector<std::size_t> order(patches.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double left = limited_area(patches[a]), right = limited_area(patches[b]);
    return left != right ? left > right : patches[a].coverage.area > patches[b].coverage.area;
  });
  std::vector<char> is_shown(patches.size(), 0);
  for (std::size_t i = 0; i < std::min(n, order.size()); ++i) is_shown[order[i]] = 1;
  return is_shown;
}

}  // namespace

std::string coverage_table(const Report& report, bool is_whole) {
  const std::size_t n = report.patches.size();
  const auto is_shown = choose_rows(report.patches, is_whole || n <= kMostRows + 1 ? n : kMostRows);
  CoverageTable table(is_whole);
  std::vector<std::string> names;
  for (const PatchReport& patch : report.patches) names.push_back(patch.name);
  if (!is_whole) names = row_names(names, kLongestName);
  std::vector<const PatchReport*> rest, walls;
  for (std::size_t p = 0; p < n; ++p) {
    const PatchReport& patch = report.patches[p];
    if (has_layers(patch)) walls.push_back(&patch);
    if (is_shown[p]) {
      table.add(names[p], patch);
    } else {
      rest.push_back(&patch);
    }
  }
  if (!rest.empty()) table.add_together(fmt::format("… {} more", rest.size()), rest);
  if (walls.size() > 1) table.add_together("all walls", walls);
  return table.text() +
         "  % of the area. all: all layers; full: at 95 % of the thickness or more; first: first height within 5 %;\n"
         "  layers: the mean; thickness: the median, and that in % of the asked one\n";
}

std::string lines_at_wall(const Report& report) {
  const quality::LimitedLines& lines = report.limited;
  if (lines.n_at_wall() == 0) return "";
  std::vector<std::size_t> reasons;
  for (std::size_t r = 1; r < mesh::kNLimitReasons; ++r) {
    if (lines.by_reason[r].n_at_wall > 0) reasons.push_back(r);
  }
  constexpr auto kAsked = static_cast<std::size_t>(mesh::LimitReason::PatchEdge);
  std::stable_sort(reasons.begin(), reasons.end(), [&](std::size_t a, std::size_t b) {
    if ((a == kAsked) != (b == kAsked)) return b == kAsked;
    return lines.by_reason[a].n_at_wall > lines.by_reason[b].n_at_wall;
  });
  std::string out;
  for (const std::size_t r : reasons) {
    const quality::ReasonLines& of_reason = lines.by_reason[r];
    out += fmt::format("{}{} {}", out.empty() ? "" : "; ", mesh::kLimitReasonNames[r], grouped(of_reason.n_at_wall));
    if (r == kAsked) continue;
    const quality::LimitedVertex& first = of_reason.worst.front();
    out += fmt::format(", one at ({:.6g}, {:.6g}, {:.6g}) on '{}'", first.place.x(), first.place.y(), first.place.z(),
                       report.patches[first.patch.index()].name);
  }
  return fmt::format("{} of {} lines stay at the wall: {}", grouped(lines.n_at_wall()), grouped(lines.n_lines), out);
}

}  // namespace nearwall::program
