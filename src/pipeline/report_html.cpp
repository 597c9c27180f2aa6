#include <array>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "nearwall/core/markup.h"
#include "pipeline/report_charts.h"
#include "pipeline/report_json.h"
#include "pipeline/report_limits.h"
#include "pipeline/report_style.h"

namespace nearwall {

namespace {

using namespace pipeline;

std::string card(const std::string& value, std::string_view caption) {
  return fmt::format("<div class='card'><b>{}</b><span>{}</span></div>", value, caption);
}

std::string duration(double seconds) {
  if (seconds < 60) return fmt::format("{:.{}f} s", seconds, seconds < 10 ? 2 : 1);
  const auto whole = static_cast<int>(seconds + 0.5);
  return fmt::format("{} min {:02} s", whole / 60, whole % 60);
}

std::string megabytes(std::uint64_t bytes) { return fmt::format("{:.0f} MB", static_cast<double>(bytes) / 1e6); }

/// A percentage over all walls by area. What is missing is summed, so that nothing missing is 100 exactly.
double over_all_walls(const Report& report, double quality::PatchCoverage::*member) {
  double area = 0, missing = 0;
  for (const PatchReport& patch : report.patches) {
    if (!is_wall(patch)) continue;
    area += patch.coverage.area;
    missing += patch.coverage.area * (100 - patch.coverage.*member);
  }
  return area > 0 ? 100 - missing / area : 0;
}

std::string head_of(const Report& report) {
  const bool is_short = report.is_short_of_coverage();
  std::string out = fmt::format("<header><h1>{}</h1>", escaped_markup(report.name));
  out +=
      report.certified ? "<span class='badge good'>✓ certified</span>" : "<span class='badge bad'>not certified</span>";
  if (is_short) out += "<span class='badge bad'>coverage under min_coverage</span>";
  out += fmt::format("</header><p class='subtitle'>{} on {} · {} triangles · nearwall {}</p>",
                     report.volume ? "Layers and volume" : "Boundary layers", escaped_markup(report.input_file),
                     shown_count(report.surface.triangles), escaped_markup(report.version));
  out += "<div class='cards'>";
  out += card(shown_count(report.n_cells()), "cells");
  out +=
      card(percent(over_all_walls(report, &quality::PatchCoverage::all_layers_percent)), "of the wall has all layers");
  out += card(percent(over_all_walls(report, &quality::PatchCoverage::full_percent)), "at full thickness");
  out += card(shown(report.quality.scaled_jacobian.min, 3), "smallest scaled Jacobian");
  out += card(duration(report.seconds()), "in all");
  out += card(megabytes(report.peak_memory_bytes), "peak memory");
  return out + "</div>";
}

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve(4 * (bytes.size() / 3 + 1));
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      word = word << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) out += k <= n ? kDigits[(word >> (18 - 6 * k)) & 63u] : '=';
  }
  return out;
}

std::string pictures_of(const Report& report, const std::filesystem::path& folder) {
  std::string figures;
  for (const Picture& picture : report.pictures) {
    std::ifstream in(folder / picture.file, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (bytes.empty()) continue;
    figures +=
        fmt::format("<figure><img alt='{0}' src='data:image/png;base64,{1}'><figcaption>{0}</figcaption></figure>",
                    escaped_markup(picture.title), base64(bytes));
  }
  return figures.empty() ? ""
                         : fmt::format("<section><h2>Pictures</h2><div class='pictures'>{}</div></section>", figures);
}

constexpr std::size_t kReasonsInARow = 3;

std::string coverage_bar(const quality::PatchCoverage& c) {
  const std::array<Share, 4> shares = {{{"all layers, full thickness", c.full_percent, "full"},
                                        {"all layers, thinner", c.all_layers_percent - c.full_percent, "all"},
                                        {"fewer layers", c.any_percent - c.all_layers_percent, "some"},
                                        {"no layers", 100 - c.any_percent, "none"}}};
  return stacked_bar(shares);
}

std::string coverage_row(const PatchReport& patch) {
  const quality::PatchCoverage& c = patch.coverage;
  if (!is_wall(patch)) {
    return fmt::format("<tr><td>{}</td><td>{}</td><td class='left' colspan='8'><small>{}</small></td></tr>",
                       escaped_markup(patch.name), shown(c.area),
                       patch.type == PatchType::Wall      ? "out of the fluid's reach"
                       : patch.type == PatchType::NoLayer ? "no layers asked for"
                                                          : type_name(patch.type));
  }
  const auto against = [](double value, double asked) {
    return fmt::format("{}<br><small>{} of {}</small>", shown(value, 3), percent(asked > 0 ? 100 * value / asked : 100),
                       shown(asked, 3));
  };
  return fmt::format(
      "<tr{}><td>{}{}</td><td>{}</td><td class='left'>{}</td><td>{}</td><td>{}</td><td>{:.1f}<br><small>of "
      "{}</small></td><td>{}</td><td>{}</td><td>{}</td><td class='left'><small>{}</small></td></tr>",
      patch.is_below_min_coverage() ? " class='short'" : "", escaped_markup(patch.name),
      patch.is_below_min_coverage() ? fmt::format("<br><small>under min_coverage = {} %</small>", patch.min_coverage)
                                    : "",
      shown(c.area), coverage_bar(c), percent(c.all_layers_percent), percent(c.full_percent), c.mean_layers,
      c.asked.count, against(c.first_height.median, c.asked.first_height), percent(c.first_height_met_percent),
      against(c.thickness.median, c.asked.total_thickness), reasons_in_words(c, kReasonsInARow));
}

std::string coverage_of(const Report& report) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kEntries = {
      {{"full", "all layers, at least 95 % of the thickness"},
       {"all", "all layers, thinner"},
       {"some", "fewer layers"},
       {"none", "none"}}};
  std::string rows;
  for (const PatchReport& patch : report.patches) rows += coverage_row(patch);
  return fmt::format(
      "<section><h2>Coverage</h2><div class='scroll'><table><thead><tr><th>patch</th><th>area</th><th "
      "class='left'>share of the "
      "area</th><th>all layers</th><th>full</th><th>mean layers</th><th>first height,<br>median</th>"
      "<th>within 5 %</th><th>thickness,<br>median</th><th class='left'>limited by,<br>% of the "
      "area</th></tr></thead><tbody>{}</tbody></table></div>{}</section>",
      rows, legend(kEntries));
}

struct Measure {
  const char* name;
  const char* unit;
  quality::Statistics quality::LayerQuality::*statistics;
};

constexpr std::array<Measure, 5> kMeasures = {
    {{"Scaled Jacobian", "", &quality::LayerQuality::scaled_jacobian},
     {"Angle between line and wall normal", "°", &quality::LayerQuality::orthogonality},
     {"Growth from layer to layer", "", &quality::LayerQuality::growth},
     {"Aspect ratio", "", &quality::LayerQuality::aspect_ratio},
     {"Volume ratio of successive cells", "", &quality::LayerQuality::volume_ratio}}};

void add_measure(const char* name, const char* unit, const quality::Statistics& s, std::string& rows,
                 std::string& charts) {
  if (s.count == 0) return;
  rows += fmt::format("<tr><td>{}{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>", name,
                      *unit ? fmt::format(" [{}]", unit) : "", shown(s.min), shown(s.p01), shown(s.median),
                      shown(s.p99), shown(s.max), shown(s.mean));
  charts += fmt::format("<div><h3>{}</h3>{}</div>", name, histogram(s, unit));
}

void add_fill_rows(const volume::FillQuality& q, std::string& rows, std::string& charts) {
  add_measure("Smallest dihedral angle of tetrahedra", "deg", q.smallest_dihedral, rows, charts);
  add_measure("Circumradius over shortest edge of tetrahedra", "", q.radius_edge, rows, charts);
  add_measure("Size ratio of neighbouring tetrahedra", "", q.size_ratio, rows, charts);
  add_measure("First tetrahedron over last layer", "", q.interface_ratio, rows, charts);
}

std::string quality_of(const Report& report) {
  std::string rows, charts;
  for (const Measure& m : kMeasures) add_measure(m.name, m.unit, report.quality.*m.statistics, rows, charts);
  if (report.volume) add_fill_rows(report.volume->quality, rows, charts);
  for (const PatchReport& patch : report.patches) {
    if (!is_wall(patch) || report.patches.size() > 6) continue;
    charts += fmt::format("<div><h3>First height on {}</h3>{}</div>", escaped_markup(patch.name),
                          histogram(patch.coverage.first_height, ""));
  }
  return fmt::format(
      "<section><h2>Quality</h2><div class='scroll'><table><thead><tr><th></th><th>min</th><th>1 %</th><th>median</th>"
      "<th>99 %</th><th>max</th><th>mean</th></tr></thead><tbody>{}</tbody></table></div></section>"
      "<section><h2>Distributions</h2><div class='charts'>{}</div></section>",
      rows, charts);
}

std::string entry(std::string_view name, const std::string& value) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>", name, value);
}

std::string certificate_of(const Report& report) {
  const certify::Certificate& c = report.certificate;
  std::string cells;
  for (std::size_t t = 0; t < mesh::kNCellTypes; ++t) {
    if (report.cells[t] == 0) continue;
    cells += fmt::format("{}{} {}", cells.empty() ? "" : ", ", shown_count(report.cells[t]), mesh::kCellTypeNames[t]);
  }
  const SurfaceReport& s = report.surface;
  std::string out = "<section><div class='columns'><div><h2>Certificate</h2><dl>";
  out += entry("cells", cells);
  out += entry("not positive somewhere", shown_count(c.n_bad_columns));
  out += entry("front triangles that meet", shown_count(c.n_front_intersections));
  out += entry("components covered twice", shown_count(c.n_covered_twice));
  out += entry("volume of the layers", shown(c.cells_volume, 8));
  out += entry("volume between wall and front", shown(c.enclosed_volume, 8));
  if (report.volume) {
    const volume::DomainCertificate& d = report.volume->certificate;
    out += entry("faces on planes turned over", shown_count(d.n_bad_side_faces));
    out += entry("volume of all cells", shown(d.cells_volume, 8));
    out += entry("volume of the domain", shown(d.enclosed_volume, 8));
  }
  if (!report.volume_failure.empty()) out += entry("volume", escaped_markup("not filled: " + report.volume_failure));
  out += entry("rounds of certify and shrink", std::to_string(report.rounds));
  out += "</dl></div><div><h2>Surface</h2><dl>";
  out += entry("points, triangles", fmt::format("{}, {}", shown_count(s.points), shown_count(s.triangles)));
  out += entry("components",
               shown_count(s.components) +
                   (s.unwetted_components ? fmt::format(", {} out of the fluid's reach", s.unwetted_components) : ""));
  out += entry("ridges",
               fmt::format("{} convex, {} concave edges", shown_count(s.convex_ridges), shown_count(s.concave_ridges)));
  out += entry("corners, ridge ends, tips", fmt::format("{}, {}, {}", s.corners, s.ridge_ends, s.tips));
  out += entry("vertices that nothing sees all of", shown_count(s.blind));
  const Vec3 size = report.forecast.box.high - report.forecast.box.low;
  out += entry("box", fmt::format("{} × {} × {}", shown(size.x()), shown(size.y()), shown(size.z())));
  out += entry("SHA-256", escaped_markup(report.input_sha256));
  return out + "</dl></div></div></section>";
}

std::string stages_of(const Report& report) {
  double longest = 0;
  for (const StageTime& stage : report.stages) longest = std::max(longest, stage.seconds);
  std::string rows;
  for (const StageTime& stage : report.stages) {
    rows += fmt::format(
        "<tr><td>{}</td><td>{}</td><td class='left' style='width:60%'><div class='time' "
        "style='width:{:.1f}%'></div></td></tr>",
        escaped_markup(stage.name), duration(stage.seconds), longest > 0 ? 100 * stage.seconds / longest : 0);
  }
  return fmt::format("<section><h2>Time</h2><table><tbody>{}</tbody></table></section>", rows);
}

std::string list_of(std::string_view title, const std::vector<std::string>& items) {
  if (items.empty()) return "";
  std::string out = fmt::format("<section><h2>{}</h2><ul>", title);
  for (const std::string& item : items) out += fmt::format("<li>{}</li>", escaped_markup(item));
  return out + "</ul></section>";
}

/// The case as it would stand in a case file.
std::string case_of(const Report& report) {
  std::string text, tables;
  const auto add = [](const auto& self, std::string& top, std::string& rest, const Json& table,
                      const std::string& path) -> void {
    for (const auto& [key, value] : table.items()) {
      const bool is_bare = key.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
                           std::string::npos;
      const std::string name = is_bare ? key : Json(key).dump(-1, ' ', false, Json::error_handler_t::replace);
      if (!value.is_object()) {
        top += fmt::format("{} = {}\n", name, value.dump(-1, ' ', false, Json::error_handler_t::replace));
        continue;
      }
      const std::string inner_path = path.empty() ? name : path + "." + name;
      std::string inner, deeper;
      self(self, inner, deeper, value, inner_path);
      if (!inner.empty()) rest += fmt::format("\n[{}]\n{}", inner_path, inner);
      rest += deeper;
    }
  };
  add(add, text, tables, case_json(report.settings), "");
  return fmt::format("<section><h2>Case in force</h2><pre>{}</pre></section>", escaped_markup(text + tables));
}

}  // namespace

std::string to_html(const Report& report, const std::filesystem::path& picture_folder) {
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' content='width=device-width, "
      "initial-scale=1'><title>{} – nearwall</title><style>{}</style></head><body><main>",
      escaped_markup(report.name), kReportStyle);
  out += head_of(report);
  out += list_of("Warnings", report.warnings);
  out += pictures_of(report, picture_folder);
  out += coverage_of(report);
  out += limits_of(report);
  out += quality_of(report);
  out += certificate_of(report);
  out += stages_of(report);
  out += case_of(report);
  out += list_of("Notes", report.notes);
  out += list_of("Files", report.files);
  out += fmt::format("<footer>Definitions of all figures: docs/theory/quality.md · nearwall {}</footer>",
                     escaped_markup(report.version));
  return out + "</main></body></html>\n";
}

}  // namespace nearwall
