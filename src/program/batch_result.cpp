#include "program/batch_result.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "program/exit_codes.h"

namespace nearwall::program {

namespace {

using nlohmann::json;

constexpr std::size_t kLongestMessage = 160;

/// Sum of the numbers of a JSON object or array.
template <class Number>
Number sum_of(const json& values) {
  Number sum = 0;
  for (const json& value : values) {
    if (value.is_number()) sum += value.get<Number>();
  }
  return sum;
}

/// Share of the walls' area that has all layers.
double coverage_of(const json& patches) {
  double area = 0, covered = 0;
  for (const json& patch : patches) {
    if (patch.value("type", "wall") != "wall") continue;
    area += patch.value("area", 0.0);
    covered += patch.value("area", 0.0) * patch.value("all_layers_percent", 0.0);
  }
  return area > 0 ? covered / area : 0;
}

void read_report(const json& report, BatchResult& result) {
  result.n_cells = sum_of<unsigned long long>(report.value("cells", json::object()));
  result.n_triangles = report.value("surface", json::object()).value("triangles", 0ull);
  result.coverage_percent = coverage_of(report.value("patches", json::object()));
  result.peak_memory_bytes = report.value("peak_memory_bytes", 0.0);
  double seconds = 0;
  for (const json& stage : report.value("stages", json::array())) seconds += stage.value("seconds", 0.0);
  if (seconds > 0) result.seconds = seconds;
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  if (end == std::string::npos) return "";
  const std::size_t begin = text.find_last_of('\n', end);
  return text.substr(begin == std::string::npos ? 0 : begin + 1,
                     end - (begin == std::string::npos ? 0 : begin + 1) + 1);
}

/// The first line, with the next where it only announces that: "the surface cannot be used: 3 open edges near …".
std::string headline(const std::string& text) {
  const std::size_t end = text.find('\n');
  const std::string line = text.substr(0, end);
  if (end == std::string::npos || !line.ends_with(':')) return line;
  const std::size_t begin = text.find_first_not_of(" \n", end);
  return begin == std::string::npos ? line : line + " " + text.substr(begin, text.find('\n', begin) - begin);
}

std::string shortened(const std::string& text) {
  std::string line = headline(text);
  if (line.size() <= kLongestMessage) return line;
  std::size_t cut = kLongestMessage;
  while (cut > 0 && (static_cast<unsigned char>(line[cut]) & 0xC0u) == 0x80u) --cut;  // between characters of UTF-8
  return line.substr(0, cut) + " …";
}

/// The message with the path of the case as its label says it: a table should not depend on where the folder lies.
std::string with_label(std::string message, const std::string& label) {
  const std::size_t at = message.find(label);
  if (at == std::string::npos || at == 0 || message[at - 1] != '/') return message;
  const std::size_t before = message.find_last_of(" '\"", at);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  return message.erase(begin, at - begin);
}

}  // namespace

BatchResult read_result(const std::string& label, const ChildEnd& end, double seconds) {
  BatchResult result{.label = label, .exit_code = end.exit_code, .signal = end.signal, .seconds = seconds};
  if (end.signal != 0) {
    result.result = "crashed";
    result.message =
        fmt::format("killed by signal {} ({}); {}", end.signal, strsignal(end.signal), last_line(end.talk));
    return result;
  }
  const json output = json::parse(end.output, nullptr, false);
  const bool is_report = output.is_object() && !output.contains("error");
  if (is_report) read_report(output, result);
  result.result = result.is_done() ? "certified" : kind_of(static_cast<ExitCode>(end.exit_code));
  if (result.is_done()) return result;
  result.message =
      output.is_object() && output.contains("error") ? output["error"].value("message", "") : last_line(end.talk);
  return result;
}

BatchResult not_run(const std::string& label) {
  return {.label = label, .result = "not run", .message = "interrupted before its turn"};
}

Table table_of(const std::vector<BatchResult>& results) {
  Table table({{"case"},
               {"result"},
               {"triangles", true},
               {"cells", true},
               {"coverage %", true},
               {"seconds", true},
               {"message"}});
  for (const BatchResult& r : results) {
    const bool has_mesh = r.n_cells > 0;
    table.add_row({r.label, r.result, r.n_triangles > 0 ? grouped(r.n_triangles) : "-",
                   has_mesh ? grouped(r.n_cells) : "-", has_mesh ? fmt::format("{:.1f}", r.coverage_percent) : "-",
                   fmt::format("{:.2f}", r.seconds), shortened(with_label(r.message, r.label))});
  }
  return table;
}

std::string tally(const std::vector<BatchResult>& results) {
  const auto n_done = std::count_if(results.begin(), results.end(), [](const BatchResult& r) { return r.is_done(); });
  return fmt::format("{} of {} certified, {} failed", n_done, results.size(),
                     static_cast<long>(results.size()) - static_cast<long>(n_done));
}

json json_of(const std::vector<BatchResult>& results) {
  json cases = json::array();
  std::size_t n_failed = 0;
  for (const BatchResult& r : results) {
    if (!r.is_done()) ++n_failed;
    cases.push_back({{"case", r.label},
                     {"result", r.result},
                     {"exit_code", r.exit_code},
                     {"signal", r.signal},
                     {"triangles", r.n_triangles},
                     {"cells", r.n_cells},
                     {"coverage_percent", r.coverage_percent},
                     {"seconds", r.seconds},
                     {"peak_memory_bytes", r.peak_memory_bytes},
                     {"message", r.message}});
  }
  return {{"cases", cases}, {"done", results.size() - n_failed}, {"failed", n_failed}};
}

}  // namespace nearwall::program
