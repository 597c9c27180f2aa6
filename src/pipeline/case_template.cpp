#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "nearwall/pipeline/case.h"
#include "pipeline/case_keys.h"

namespace nearwall {

namespace {

using namespace pipeline;

/// Heights that `init` proposes, relative to the diagonal of the surface's box: a first height in the range of y⁺ = 1
/// at Reynolds numbers of some millions, and layers up to a hundredth of the body.
constexpr double kProposedFirstHeight = 1e-5;
constexpr double kProposedThickness = 0.01;
constexpr std::size_t kCommentColumn = 34;
constexpr std::size_t kMostNamesShown = 20;

/// Two significant digits: a figure that a person would type.
double rounded(double value) {
  if (!(value > 0)) return value;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return std::round(value / unit) * unit;
}

std::string toml_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

struct Proposal {
  std::string file = "\"surface.stl\"";
  double first_height = 1e-5;
  int count = spacing::kDefaultCount;
};

Proposal propose(const std::optional<SurfaceFacts>& facts) {
  Proposal p;
  if (!facts) return p;
  p.file = toml_text(facts->file.string());
  const double diagonal = facts->box.diagonal();
  if (!(diagonal > 0)) return p;
  p.first_height = rounded(kProposedFirstHeight * diagonal);
  double height = p.first_height, thickness = 0;
  p.count = 0;
  // Layers higher than their triangles are wide are of no use.
  while (thickness < kProposedThickness * diagonal && (p.count < 2 || height < facts->mean_edge)) {
    thickness += height;
    height *= spacing::kDefaultGrowth;
    ++p.count;
  }
  return p;
}

std::string line(std::string_view text, std::string_view comment) {
  return fmt::format("{:<{}} # {}\n", text, kCommentColumn, comment);
}

std::string comment_of(const Key& key) {
  std::string comment(key.doc);
  if (key.kind == Kind::Choice || key.kind == Kind::Choices) {
    comment = fmt::format("{}; {}", fmt::join(key.choices, " | "), comment);
  }
  if (!key.unit.empty() && key.unit != "layers") comment += fmt::format(" [{}]", key.unit);
  return comment;
}

std::string key_line(const Key& key, const Proposal& proposal) {
  if (key.name == "file") return line(fmt::format("file = {}", proposal.file), comment_of(key));
  if (key.name == "first_height") return line(fmt::format("first_height = {}", proposal.first_height), comment_of(key));
  if (key.table == "layers" && key.name == "growth") {
    return line(fmt::format("growth = {}", spacing::kDefaultGrowth), comment_of(key));
  }
  if (key.name == "count") return line(fmt::format("count = {}", proposal.count), comment_of(key));
  if (key.default_text.empty()) return line(fmt::format("# {} = {}", key.name, key.example), comment_of(key));
  return line(fmt::format("{} = {}", key.name, key.default_text), comment_of(key));
}

std::string describe(const SurfaceFacts& f) {
  const auto point = [](const Vec3& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z()); };
  return fmt::format("# {}: box {} to {}, diagonal {:.4g}, mean edge {:.4g}\n", f.file.string(), point(f.box.low),
                     point(f.box.high), f.box.diagonal(), f.mean_edge);
}

std::string patch_hints(const std::optional<SurfaceFacts>& facts) {
  if (!facts) return "# [patches.NAME]                   # one patch alone: type, and keys of [layers]\n";
  std::string out;
  const std::size_t n = std::min(facts->patch_names.size(), kMostNamesShown);
  for (std::size_t i = 0; i < n; ++i) out += fmt::format("# [patches.{}]\n", toml_text(facts->patch_names[i]));
  if (n < facts->patch_names.size()) out += fmt::format("# … and {} more\n", facts->patch_names.size() - n);
  return out;
}

/// What the surface has to take lengths from.
std::string array_hints(const std::optional<SurfaceFacts>& facts) {
  if (!facts || facts->point_arrays.empty()) return "";
  std::string out = line("# first_height = { array = \"NAME\" }", "or one of the surface's point arrays:");
  const std::size_t n = std::min(facts->point_arrays.size(), kMostNamesShown);
  for (std::size_t i = 0; i < n; ++i) out += fmt::format("#   {}\n", toml_text(facts->point_arrays[i]));
  if (n < facts->point_arrays.size()) out += fmt::format("#   … and {} more\n", facts->point_arrays.size() - n);
  return out;
}

std::string header_of(std::string_view table) {
  if (table.empty()) return "";
  if (table == "patches") return "\n[patches.\"*\"]                      # all patches\n";
  if (table == "flow") return "\n# [flow]                           # for y_plus, in the scaled unit of the surface\n";
  return fmt::format("\n[{}]\n", table);
}

std::string default_of(const Key& key) {
  if (!key.default_text.empty()) return fmt::format("`{}`", key.default_text);
  if (key.name == "file") return "needed";
  return "";
}

std::string reference_row(const Key& key) {
  std::string takes = allowed(key);
  if (!key.later.empty()) {
    takes += fmt::format("; not in this version: {}", fmt::join(key.later, ", "));
  }
  std::replace(takes.begin(), takes.end(), '|', '/');
  return fmt::format("| `{}` | {} | {} | {} |\n", key.name, takes, default_of(key), key.doc);
}

}  // namespace

std::string case_template(const std::optional<SurfaceFacts>& facts) {
  const Proposal proposal = propose(facts);
  std::string out = "# A case of nearwall. Run it with: nearwall run THIS-FILE\n";
  if (facts) out += describe(*facts);
  for (const auto table : case_tables()) {
    std::string lines;
    for (const Key& key : case_keys()) {
      if (key.table != table) continue;
      lines += key_line(key, proposal);
      if (key.name == "first_height") lines += array_hints(facts);
    }
    if (lines.empty()) continue;
    out += header_of(table) + lines;
    if (table == "patches") out += patch_hints(facts);
  }
  return out;
}

std::string case_reference() {
  std::string out;
  for (const auto table : case_tables()) {
    std::string rows;
    for (const Key& key : case_keys()) {
      if (key.table == table) rows += reference_row(key);
    }
    if (rows.empty()) continue;
    const std::string title = table.empty()        ? "Top level"
                              : table == "patches" ? "[patches.NAME]"
                                                   : fmt::format("[{}]", table);
    out += fmt::format("### {}\n\n| key | takes | default | meaning |\n| --- | --- | --- | --- |\n{}\n", title, rows);
  }
  return out;
}

}  // namespace nearwall
