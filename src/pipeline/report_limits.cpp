#include "pipeline/report_limits.h"

#include <array>

#include <fmt/format.h>

#include "nearwall/core/markup.h"
#include "pipeline/report_charts.h"

namespace nearwall::pipeline {

namespace {

std::string shares_by_reason(const Report& report) {
  std::string rows;
  std::array<bool, mesh::kNLimitReasons> is_used{};
  std::array<std::string, mesh::kNLimitReasons> classes;
  for (std::size_t r = 1; r < classes.size(); ++r) classes[r] = fmt::format("limit-{}", r);
  for (const PatchReport& patch : report.patches) {
    if (!is_wall(patch) || patch.coverage.full_percent >= 100) continue;
    std::vector<Share> shares;
    const double limited = 100 - patch.coverage.full_percent;
    for (std::size_t r = 1; r < mesh::kNLimitReasons; ++r) {
      const double share = patch.coverage.limit_percent[r];
      if (!(share > 0)) continue;
      is_used[r] = true;
      shares.push_back({mesh::kLimitReasonNames[r], 100 * share / limited, classes[r]});
    }
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td class='left'>{}</td></tr>", escaped_markup(patch.name),
                        percent(limited), stacked_bar(shares));
  }
  if (rows.empty()) return "";
  std::vector<std::pair<std::string_view, std::string_view>> entries;
  for (std::size_t r = 1; r < is_used.size(); ++r) {
    if (is_used[r]) entries.emplace_back(classes[r], mesh::kLimitReasonNames[r]);
  }
  return fmt::format(
      "<section><h2>Why the rest is not full</h2><div class='scroll'><table><thead><tr><th>patch</th><th>not "
      "full</th><th "
      "class='left'>share by reason</th></tr></thead><tbody>{}</tbody></table></div>{}</section>",
      rows, legend(entries));
}

std::string place_row(const Report& report, std::string_view reason, const quality::LimitedVertex& v) {
  return fmt::format(
      "<tr><td>{}</td><td class='left'>({:.6g}, {:.6g}, {:.6g})</td><td class='left'>{}</td><td>{}</td><td>{}</td>"
      "<td>{}</td><td>{}<br><small>of {}</small></td></tr>",
      reason, v.place.x(), v.place.y(), v.place.z(), escaped_markup(report.patches[v.patch.index()].name),
      v.vertex.index(), v.levels, percent(100 * v.share()), shown(v.reached, 3), shown(v.asked, 3));
}

/// The worst places of each reason, and how many lines it has limited.
std::string places_of(const Report& report) {
  std::string counts, rows;
  for (std::size_t r = 1; r < mesh::kNLimitReasons; ++r) {
    const quality::ReasonLines& lines = report.limited.by_reason[r];
    if (lines.n_lines == 0) continue;
    counts +=
        fmt::format("{}{}: {}{}", counts.empty() ? "" : "; ", mesh::kLimitReasonNames[r], shown_count(lines.n_lines),
                    lines.n_at_wall > 0 ? fmt::format(", {} of them at the wall", shown_count(lines.n_at_wall)) : "");
    for (const quality::LimitedVertex& v : lines.worst) rows += place_row(report, mesh::kLimitReasonNames[r], v);
  }
  if (rows.empty()) return "";
  return fmt::format(
      "<section><h2>Where the least is reached</h2><p>Limited lines, of {}: {}.</p><div class='scroll'><table><thead>"
      "<tr><th>reason</th><th class='left'>place</th><th class='left'>patch</th><th>point</th><th>layers</th>"
      "<th>reached</th><th>thickness</th></tr></thead><tbody>{}</tbody></table></div></section>",
      shown_count(report.limited.n_lines), counts, rows);
}

}  // namespace

std::string percent(double value) {
  return value == 100 || value == 0 ? fmt::format("{:.0f} %", value) : percent_in_words(value) + " %";
}

bool is_wall(const PatchReport& patch) { return patch.type == PatchType::Wall && patch.coverage.area > 0; }

std::string legend(std::span<const std::pair<std::string_view, std::string_view>> entries) {
  std::string out = "<div class='legend'>";
  for (const auto& [css_class, label] : entries) {
    out += fmt::format("<span><i class='{}'></i>{}</span>", css_class, label);
  }
  return out + "</div>";
}

std::string limits_of(const Report& report) { return shares_by_reason(report) + places_of(report); }

}  // namespace nearwall::pipeline
