#include "pipeline/report_charts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "nearwall/core/markup.h"

namespace nearwall::pipeline {

namespace {

constexpr double kWidth = 360;
constexpr double kHeight = 132;
constexpr double kTop = 20;     ///< room for the median's label
constexpr double kBottom = 20;  ///< room for the axis' labels

std::string plain(double value) { return fmt::format("{:.4g}", value); }

/// Place of a value on the axis of the bars, which may have equal ratios rather than equal steps.
double place(const std::vector<quality::Bar>& bars, double value) {
  const double step = kWidth / static_cast<double>(bars.size());
  for (std::size_t i = 0; i < bars.size(); ++i) {
    if (value > bars[i].high) continue;
    const double span = bars[i].high - bars[i].low;
    const double t = span > 0 ? std::clamp((value - bars[i].low) / span, 0.0, 1.0) : 0.5;
    return step * (static_cast<double>(i) + t);
  }
  return kWidth;
}

std::string rectangles(const std::vector<quality::Bar>& bars) {
  double tallest = 0;
  for (const auto& bar : bars) tallest = std::max(tallest, bar.share);
  const double step = kWidth / static_cast<double>(bars.size());
  const double floor = kHeight - kBottom;
  std::string out;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    if (!(bars[i].share > 0)) continue;
    const double height = std::max(1.0, (floor - kTop) * bars[i].share / tallest);
    out += fmt::format(
        "<rect class='bar' x='{:.2f}' y='{:.2f}' width='{:.2f}' height='{:.2f}'><title>{} to {}: {:.3g} "
        "%</title></rect>",
        step * static_cast<double>(i) + 0.5, floor - height, std::max(1.0, step - 1), height, shown(bars[i].low),
        shown(bars[i].high), 100 * bars[i].share);
  }
  return out;
}

/// All values are the same: one bar in the middle says more than a chart.
std::vector<quality::Bar> widened(const quality::Statistics& s) {
  if (s.bars.size() > 1) return s.bars;
  std::vector<quality::Bar> bars(9, {s.median, s.median, 0});
  bars[4].share = 1;
  return bars;
}

}  // namespace

std::string shown(double value, int digits) {
  if (!std::isfinite(value)) return std::isnan(value) ? "–" : "∞";
  std::string text = fmt::format("{:.{}g}", value, digits);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  int exponent = std::stoi(text.substr(e + 1));
  return fmt::format("{}·10<sup>{}</sup>", text.substr(0, e),
                     exponent < 0 ? fmt::format("−{}", -exponent) : std::to_string(exponent));
}

std::string shown_count(std::uint64_t n) {
  const std::string digits = std::to_string(n);
  std::string out;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) out += "&#8239;";
    out += digits[i];
  }
  return out;
}

std::string histogram(const quality::Statistics& statistics, std::string_view unit) {
  if (statistics.count == 0) return "<p class='empty'>nothing to show</p>";
  const std::vector<quality::Bar> bars = widened(statistics);
  const double floor = kHeight - kBottom;
  const double median = place(bars, statistics.median);
  const char* anchor = median < 60 ? "start" : median > kWidth - 60 ? "end" : "middle";
  std::string out = fmt::format("<svg class='chart' viewBox='0 0 {} {}' role='img'>", kWidth, kHeight);
  out += rectangles(bars);
  out += fmt::format("<line class='axis' x1='0' x2='{}' y1='{}' y2='{}'/>", kWidth, floor, floor);
  out += fmt::format("<line class='median' x1='{0:.2f}' x2='{0:.2f}' y1='{1}' y2='{2}'/>", median, kTop - 4, floor);
  out += fmt::format("<text class='label strong' x='{:.2f}' y='{}' text-anchor='{}'>median {}{}</text>", median,
                     kTop - 8, anchor, plain(statistics.median), unit);
  if (statistics.bars.size() > 1) {
    out += fmt::format("<text class='label' x='0' y='{}'>{}</text>", kHeight - 4, plain(bars.front().low));
    out += fmt::format("<text class='label' x='{}' y='{}' text-anchor='end'>{}</text>", kWidth, kHeight - 4,
                       plain(bars.back().high));
  }
  return out + "</svg>";
}

std::string stacked_bar(std::span<const Share> shares) {
  constexpr double kLeastLabelled = 18;  // percent of the width that a label needs
  std::string out = "<div class='stack'>";
  for (const Share& share : shares) {
    if (!(share.percent > 0)) continue;
    const std::string label = share.percent >= kLeastLabelled ? fmt::format("{:.1f} %", share.percent) : "";
    out += fmt::format("<span class='{}' style='width:{:.3f}%' title='{}: {:.2f} %'>{}</span>", share.css_class,
                       share.percent, escaped_markup(share.label), share.percent, label);
  }
  return out + "</div>";
}

}  // namespace nearwall::pipeline
