#include "nearwall/studies/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/markup.h"
#include "studies/plot_axis.h"

namespace nearwall::studies {

namespace {

// Sizes in pixels.
constexpr double kWidth = 760, kHeight = 440;
constexpr double kLeft = 72, kRight = 170, kTop = 40, kBottom = 60;
constexpr double kInnerWidth = kWidth - kLeft - kRight, kInnerHeight = kHeight - kTop - kBottom;
constexpr double kHalfLetter = 4;                 // from the middle of a letter down to the base line
constexpr double kLabelGap = 8;                   // from the frame to the labels on its left
constexpr double kLabelDrop = 18;                 // from the frame to the base line of the labels below
constexpr double kTitleOfX = 16, kTitleOfY = 18;  // base lines of the axes' titles, from the edge of the picture
constexpr double kLegendX = kLeft + kInnerWidth + 14, kLegendY = kTop + 8, kLineOfLegend = 20;
constexpr double kLineKey = 24, kBarKey = 12;    // width of a series' sample in the legend
constexpr double kLineText = 30, kBarText = 20;  // from there to its name, with a gap
constexpr double kRadius = 3.5;                  // of round and square markers
constexpr double kTip = 4.5, kSlope = 8;         // half the width and the height of pointed ones, for an equal look

/// Colours that stay apart for the colour-blind (Okabe & Ito 2008), then darker ones of other hues.
constexpr std::array<std::string_view, 12> kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                       "#e69f00", "#56b4e9", "#000000", "#7f3c8d",
                                                       "#a5aa00", "#8b4513", "#666666", "#b00020"};

std::string_view colour(std::size_t i) { return kColours[i % kColours.size()]; }

double pixel_x(double place) { return kLeft + place * kInnerWidth; }
double pixel_y(double place) { return kTop + (1.0 - place) * kInnerHeight; }

std::string text(double x, double y, std::string_view anchor, const std::string& content, std::string_view more = "") {
  return fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='{}'{}>{}</text>\n", x, y, anchor, more, content);
}

std::string line(double x1, double y1, double x2, double y2, std::string_view stroke) {
  return fmt::format("<line x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}' stroke='{}'/>\n", x1, y1, x2, y2, stroke);
}

/// A marker of one of six forms, so that lines can be told apart without their colours.
std::string marker(std::size_t form, double x, double y, std::string_view fill) {
  const auto path = [&](const std::string& d) { return fmt::format("<path d='{}' fill='{}'/>", d, fill); };
  switch (form % 6) {
    case 0:
      return fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='{}' fill='{}'/>", x, y, kRadius, fill);
    case 1:
      return path(fmt::format("M{0:.1f} {1:.1f}h{2}v{2}h-{2}z", x - kRadius, y - kRadius, 2 * kRadius));
    case 2:
      return path(fmt::format("M{:.1f} {:.1f}l{} {}h-{}z", x, y - kTip, kTip, kSlope, 2 * kTip));
    case 3:
      return path(fmt::format("M{0:.1f} {1:.1f}l{2} {2}l-{2} {2}l-{2} -{2}z", x, y - kTip, kTip));
    case 4:
      return path(fmt::format("M{:.1f} {:.1f}l{} -{}h-{}z", x, y + kTip, kTip, kSlope, 2 * kTip));
    default:
      return fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='{}' fill='#fff' stroke='{}' stroke-width='1.5'/>", x, y,
                         kRadius, fill);
  }
}

std::string opening(const std::string& title) {
  std::string out = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}' width='{0}' height='{1}' role='img' "
      "font-family='sans-serif' font-size='12' fill='#222'>\n<title>{2}</title>\n<rect width='{0}' height='{1}' "
      "fill='#fff'/>\n",
      kWidth, kHeight, escaped_markup(title));
  return out + text(kWidth / 2, kTop / 2 + kHalfLetter, "middle", escaped_markup(title),
                    " font-size='14' font-weight='bold'");
}

std::string frame() {
  return fmt::format("<rect x='{}' y='{}' width='{}' height='{}' fill='none' stroke='#444'/>\n", kLeft, kTop,
                     kInnerWidth, kInnerHeight);
}

std::string y_grid(const Axis& axis, const std::string& label) {
  std::string out;
  for (const double tick : axis.ticks()) {
    const double y = pixel_y(axis.place(tick));
    out += line(kLeft, y, kLeft + kInnerWidth, y, "#ddd") +
           text(kLeft - kLabelGap, y + kHalfLetter, "end", Axis::label(tick));
  }
  const double middle = kTop + kInnerHeight / 2;
  return out + text(kTitleOfY, middle, "middle", escaped_markup(label),
                    fmt::format(" transform='rotate(-90 {} {})'", kTitleOfY, middle));
}

std::string x_grid(const Axis& axis, const std::string& label) {
  std::string out;
  for (const double tick : axis.ticks()) {
    const double x = pixel_x(axis.place(tick));
    out += line(x, kTop, x, kTop + kInnerHeight, "#ddd");
    out += text(x, kTop + kInnerHeight + kLabelDrop, "middle", Axis::label(tick));
  }
  return out + text(kLeft + kInnerWidth / 2, kHeight - kTitleOfX, "middle", escaped_markup(label));
}

double legend_y(std::size_t i) { return kLegendY + kLineOfLegend * static_cast<double>(i); }

/// Those of the points that both axes can show.
std::vector<double> coordinates(const LinePlot& plot, bool of_x) {
  std::vector<double> all;
  for (const Series& series : plot.series) {
    for (const auto& [x, y] : series.points) {
      if (Axis::can_show(x, plot.is_log_x) && Axis::can_show(y, plot.is_log_y)) all.push_back(of_x ? x : y);
    }
  }
  return all;
}

/// Heights of all bars, and the ground they stand on.
std::vector<double> heights(const BarPlot& plot) {
  std::vector<double> all;
  for (const auto& [name, bars] : plot.series) {
    if (bars.size() != plot.groups.size()) {
      throw InputError(fmt::format("plot '{}': expected a bar of '{}' in each of {} groups, found {}", plot.title, name,
                                   plot.groups.size(), bars.size()));
    }
    std::copy_if(bars.begin(), bars.end(), std::back_inserter(all),
                 [&](double bar) { return Axis::can_show(bar, plot.is_log_y); });
  }
  // The ground alone is nothing to show.
  if (!plot.is_log_y && !all.empty()) all.push_back(0);
  return all;
}

std::string drawn(const Series& series, std::size_t i, const Axis& x_axis, const Axis& y_axis, bool has_markers) {
  std::string path, markers;
  for (const auto& [x, y] : series.points) {
    if (!x_axis.can_show(x) || !y_axis.can_show(y)) continue;
    const double px = pixel_x(x_axis.place(x)), py = pixel_y(y_axis.place(y));
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", px, py);
    if (has_markers) markers += marker(i, px, py, colour(i));
  }
  std::string out = fmt::format("<path d='{}' fill='none' stroke='{}' stroke-width='1.5'/>\n", path, colour(i));
  const double y = legend_y(i);
  out += fmt::format("<path d='M{} {}h{}' stroke='{}' stroke-width='1.5'/>", kLegendX, y, kLineKey, colour(i));
  if (has_markers) out += marker(i, kLegendX + kLineKey / 2, y, colour(i));
  return out + markers + "\n" + text(kLegendX + kLineText, y + kHalfLetter, "start", escaped_markup(series.name));
}

}  // namespace

std::string to_svg(const LinePlot& plot) {
  const Axis x_axis(coordinates(plot, true), plot.is_log_x), y_axis(coordinates(plot, false), plot.is_log_y);
  std::string out = opening(plot.title) + x_grid(x_axis, plot.x_label) + y_grid(y_axis, plot.y_label) + frame();
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    out += drawn(plot.series[i], i, x_axis, y_axis, plot.has_markers);
  }
  return out + "</svg>\n";
}

std::string to_svg(const BarPlot& plot) {
  constexpr double kGroupShare = 0.8;  // of its width that a group fills with bars
  const Axis y_axis(heights(plot), plot.is_log_y);
  const double floor = pixel_y(plot.is_log_y ? 0 : y_axis.place(0));
  const double group_width = kInnerWidth / static_cast<double>(plot.groups.size());
  const double bar_width = group_width * kGroupShare / static_cast<double>(plot.series.size());

  std::string out = opening(plot.title) + y_grid(y_axis, plot.y_label);
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const auto& [name, bars] = plot.series[i];
    for (std::size_t g = 0; g < bars.size(); ++g) {
      if (!y_axis.can_show(bars[g])) continue;
      const double x =
          kLeft + group_width * (static_cast<double>(g) + (1.0 - kGroupShare) / 2) + bar_width * static_cast<double>(i);
      const double y = pixel_y(y_axis.place(bars[g]));
      out += fmt::format("<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' fill='{}'/>\n", x,
                         std::min(y, floor), bar_width, std::abs(floor - y), colour(i));
    }
    out += fmt::format("<rect x='{0}' y='{1}' width='{2}' height='{2}' fill='{3}'/>\n", kLegendX,
                       legend_y(i) - kBarKey / 2, kBarKey, colour(i));
    out += text(kLegendX + kBarText, legend_y(i) + kHalfLetter, "start", escaped_markup(name));
  }
  for (std::size_t g = 0; g < plot.groups.size(); ++g) {
    out += text(kLeft + group_width * (static_cast<double>(g) + 0.5), kTop + kInnerHeight + kLabelDrop, "middle",
                escaped_markup(plot.groups[g]));
  }
  return out + frame() + "</svg>\n";
}

}  // namespace nearwall::studies
