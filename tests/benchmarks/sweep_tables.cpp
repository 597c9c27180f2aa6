#include "sweep_tables.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "nearwall/pipeline/report.h"

namespace nearwall::sweep {

namespace {

std::vector<double> sorted(const Rows& rows, double Row::*member) {
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(row.*member);
  std::sort(values.begin(), values.end());
  return values;
}

std::string line(const std::string& name, const Row& r) {
  return fmt::format("{:<44} {:7.2f} {:7.2f} {:7.2f} {:7.2f} {:7.3f} {:6.2f} {:6.3f} {:5.2f} {:6.1f} {:8.3f} {}\n",
                     name, r.all, r.full, r.any, r.first, r.large_first, r.mean_layers, r.largest_growth, r.lines,
                     r.rounds, r.seconds, r.is_certified ? r.limits : "NOT CERTIFIED");
}

std::string grouped(std::size_t n) {
  std::string digits = std::to_string(n);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

/// A requirement on all surfaces together.
struct Demand {
  const char* what;
  const char* asked_of_s;
  const char* asked_of_r;
  double (*figure)(const Rows&);
  const char* format;
};

constexpr std::array<Demand, 9> kDemands = {{
    {"all layers, median", "≥ 99 %", "≥ 99 %", [](const Rows& r) { return median(r, &Row::all); }, "{:.2f} %"},
    {"all layers, mean", "", "", [](const Rows& r) { return mean(r, &Row::all); }, "{:.2f} %"},
    {"all layers, worst surface", "", "≥ 90 %", [](const Rows& r) { return smallest(r, &Row::all); }, "{:.2f} %"},
    {"full thickness, median", "≥ 92 %", "≥ 92 %", [](const Rows& r) { return median(r, &Row::full); }, "{:.2f} %"},
    {"full thickness, mean", "", "", [](const Rows& r) { return mean(r, &Row::full); }, "{:.2f} %"},
    {"full thickness, worst surface", "", "", [](const Rows& r) { return smallest(r, &Row::full); }, "{:.2f} %"},
    {"first height within 5 %, median", "≥ 98 %", "≥ 98 %", [](const Rows& r) { return median(r, &Row::first); },
     "{:.2f} %"},
    {"first height above 1.5 times the asked one but at late starts, worst surface", "0 %", "0 %",
     [](const Rows& r) { return largest(r, &Row::large_first); }, "{:.3f} %"},
    {"growth from layer to layer, largest", "≤ 1.3", "≤ 1.3",
     [](const Rows& r) { return largest(r, &Row::largest_growth); }, "{:.3f}"},
}};

}  // namespace

double mean(const Rows& rows, double Row::*member) {
  const double sum =
      std::accumulate(rows.begin(), rows.end(), 0.0, [&](double s, const Row& row) { return s + row.*member; });
  return rows.empty() ? 0 : sum / static_cast<double>(rows.size());
}

double median(const Rows& rows, double Row::*member) {
  const auto values = sorted(rows, member);
  if (values.empty()) return 0;
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double smallest(const Rows& rows, double Row::*member) { return rows.empty() ? 0 : sorted(rows, member).front(); }

double largest(const Rows& rows, double Row::*member) { return rows.empty() ? 0 : sorted(rows, member).back(); }

std::string text_table(const std::vector<std::string>& names, const Rows& rows) {
  std::string out =
      fmt::format("{:<44} {:>7} {:>7} {:>7} {:>7} {:>7} {:>6} {:>6} {:>5} {:>6} {:>8} {}\n", "surface", "all %",
                  "full %", "any %", "first %", ">1.5 %", "layers", "growth", "lines", "rounds", "seconds", "limits");
  for (std::size_t i = 0; i < rows.size(); ++i) out += line(names[i], rows[i]);
  Row means, medians, worst;
  for (Row* row : {&means, &medians, &worst}) row->is_certified = true;
  for (double Row::*member : {&Row::all, &Row::full, &Row::any, &Row::first, &Row::mean_layers, &Row::large_first,
                              &Row::largest_growth, &Row::lines, &Row::rounds, &Row::seconds}) {
    const bool is_good = member == &Row::all || member == &Row::full || member == &Row::any || member == &Row::first ||
                         member == &Row::mean_layers;
    means.*member = mean(rows, member);
    medians.*member = median(rows, member);
    worst.*member = is_good ? smallest(rows, member) : largest(rows, member);
  }
  out += line(fmt::format("mean of {}", rows.size()), means) + line("median", medians) + line("worst", worst);
  return out + fmt::format("sum of seconds {:.1f}\n", mean(rows, &Row::seconds) * static_cast<double>(rows.size()));
}

std::string summary_markdown(const std::vector<Standard>& standards, const std::vector<Rows>& rows) {
  std::string out = "| | asked |", rule = "| --- | ---: |", certified = "| certified | all |";
  for (std::size_t s = 0; s < standards.size(); ++s) {
    out += fmt::format(" {} |", kStandardNames[static_cast<std::size_t>(standards[s])]);
    rule += " ---: |";
    const auto n = std::count_if(rows[s].begin(), rows[s].end(), [](const Row& row) { return row.is_certified; });
    certified += fmt::format(" {} of {} |", n, rows[s].size());
  }
  out += "\n" + rule + "\n" + certified + "\n";
  for (const Demand& demand : kDemands) {
    const std::string s = demand.asked_of_s, r = demand.asked_of_r;
    out += fmt::format("| {} | {} |", demand.what, s == r ? s : s.empty() ? "R: " + r : s);
    for (const Rows& of_standard : rows) {
      out += fmt::format(" {} |", fmt::format(fmt::runtime(demand.format), demand.figure(of_standard)));
    }
    out += "\n";
  }
  return out;
}

std::string surfaces_markdown(const std::vector<Sample>& samples, const std::vector<Standard>& standards,
                              const std::vector<Rows>& rows) {
  std::string titles = "| surface | triangles |", rule = "| --- | ---: |", body, refused;
  for (const Standard standard : standards) {
    const char* name = kStandardNames[static_cast<std::size_t>(standard)];
    titles += fmt::format(" {0}: all % | full % | any % | first % | limited by | s |", name);
    rule += " ---: | ---: | ---: | ---: | --- | ---: |";
  }
  std::size_t used = 0;
  for (const Sample& sample : samples) {
    if (!sample.refusal.empty()) {
      refused += fmt::format("| {} | {} |\n", sample.name, sample.refusal);
      continue;
    }
    body += fmt::format("| {} | {} |", sample.name, grouped(sample.n_triangles));
    for (const Rows& of_standard : rows) {
      const Row& r = of_standard[used];
      body += fmt::format(" {} | {} | {} | {} | {} | {:.2f} |", percent_in_words(r.all), percent_in_words(r.full),
                          percent_in_words(r.any), percent_in_words(r.first),
                          r.is_certified ? r.limits : "**not certified**", r.seconds);
    }
    body += "\n";
    ++used;
  }
  std::string out = titles + "\n" + rule + "\n" + body;
  if (!refused.empty()) out += "\n## Surfaces that cannot be used\n\n| surface | why |\n| --- | --- |\n" + refused;
  return out;
}

std::string ablation_markdown(const std::vector<Standard>& standards, const std::vector<Variant>& variants) {
  std::string out =
      "| schedule | without | all %: median, mean, worst | full %: median, mean, worst | first %: median, mean | "
      "certified | s |\n| --- | --- | ---: | ---: | ---: | ---: | ---: |\n";
  for (std::size_t s = 0; s < standards.size(); ++s) {
    for (const Variant& variant : variants) {
      const Rows& r = variant.rows[s];
      const auto certified = std::count_if(r.begin(), r.end(), [](const Row& row) { return row.is_certified; });
      out += fmt::format(
          "| {} | {} | {:.2f}, {:.2f}, {:.1f} | {:.2f}, {:.2f}, {:.1f} | {:.2f}, {:.2f} | {} of {} | {:.1f} |\n",
          kStandardNames[static_cast<std::size_t>(standards[s])], variant.name, median(r, &Row::all),
          mean(r, &Row::all), smallest(r, &Row::all), median(r, &Row::full), mean(r, &Row::full),
          smallest(r, &Row::full), median(r, &Row::first), mean(r, &Row::first), certified, r.size(),
          mean(r, &Row::seconds) * static_cast<double>(r.size()));
    }
  }
  return out;
}

std::string worst_table(const std::vector<Sample>& samples, const Rows& rows, std::size_t n) {
  std::vector<const Sample*> used;
  for (const Sample& sample : samples) {
    if (sample.refusal.empty()) used.push_back(&sample);
  }
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rows[a].full < rows[b].full; });
  std::string out;
  for (std::size_t i = 0; i < std::min(n, order.size()); ++i) {
    const Row& r = rows[order[i]];
    const Sample& sample = *used[order[i]];
    const Vec3 &p = r.worst_place, &d = r.worst_normal;
    out += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{},{},{}\t{},{},{}\t{}\n", sample.name, sample.file.string(),
                       percent_in_words(r.all), percent_in_words(r.full), percent_in_words(r.first), r.limits, p.x(),
                       p.y(), p.z(), d.x(), d.y(), d.z(), r.diagonal);
  }
  return out;
}

}  // namespace nearwall::sweep
