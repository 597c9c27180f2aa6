#include "nearwall/studies/plot.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/markup.h"
#include "studies/plot_axis.h"

namespace nearwall::studies {

namespace {

// Sizes in pixels.
constexpr double kWidth = 760, kHeight = 440;
constexpr double kLeft = 72, kRight = 170, kTop = 40, kBottom = 60;
constexpr double kLineOfLegend = 20;
constexpr double kInnerWidth = kWidth - kLeft - kRight, kInnerHeight = kHeight - kTop - kBottom;

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
  constexpr double kRadius = 3.5;
  const auto path = [&](const std::string& d) { return fmt::format("<path d='{}' fill='{}'/>", d, fill); };
  switch (form % 6) {
    case 0:
      return fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='{}' fill='{}'/>", x, y, kRadius, fill);
    case 1:
      return path(fmt::format("M{:.1f} {:.1f}h7v7h-7z", x - kRadius, y - kRadius));
    case 2:
      return path(fmt::format("M{:.1f} {:.1f}l4.5 8h-9z", x, y - 4.5));
    case 3:
      return path(fmt::format("M{:.1f} {:.1f}l4.5 4.5l-4.5 4.5l-4.5 -4.5z", x, y - 4.5));
    case 4:
      return path(fmt::format("M{:.1f} {:.1f}l4.5 -8h-9z", x, y + 4.5));
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
  return out + text(kWidth / 2, kTop / 2 + 4, "middle", escaped_markup(title), " font-size='14' font-weight='bold'");
}

std::string frame() {
  return fmt::format("<rect x='{}' y='{}' width='{}' height='{}' fill='none' stroke='#444'/>\n", kLeft, kTop,
                     kInnerWidth, kInnerHeight);
}

std::string y_grid(const Axis& axis, const std::string& label) {
  std::string out;
  for (const double tick : axis.ticks()) {
    const double y = pixel_y(axis.place(tick));
    out += line(kLeft, y, kLeft + kInnerWidth, y, "#ddd") + text(kLeft - 8, y + 4, "end", Axis::label(tick));
  }
  const double middle = kTop + kInnerHeight / 2;
  return out + text(18, middle, "middle", escaped_markup(label), fmt::format(" transform='rotate(-90 18 {})'", middle));
}

std::string x_grid(const Axis& axis, const std::string& label) {
  std::string out;
  for (const double tick : axis.ticks()) {
    const double x = pixel_x(axis.place(tick));
    out += line(x, kTop, x, kTop + kInnerHeight, "#ddd");
    out += text(x, kTop + kInnerHeight + 18, "middle", Axis::label(tick));
  }
  return out + text(kLeft + kInnerWidth / 2, kHeight - 16, "middle", escaped_markup(label));
}

double legend_y(std::size_t i) { return kTop + 8 + kLineOfLegend * static_cast<double>(i); }

constexpr double kLegendX = kLeft + kInnerWidth + 14;

std::vector<double> coordinates(const LinePlot& plot, bool of_x) {
  std::vector<double> all;
  for (const Series& series : plot.series) {
    for (const auto& [x, y] : series.points) all.push_back(of_x ? x : y);
  }
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
  out += fmt::format("<path d='M{} {}h24' stroke='{}' stroke-width='1.5'/>", kLegendX, y, colour(i));
  if (has_markers) out += marker(i, kLegendX + 12, y, colour(i));
  return out + markers + "\n" + text(kLegendX + 30, y + 4, "start", escaped_markup(series.name));
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
  std::vector<double> values;
  for (const auto& [name, bars] : plot.series) values.insert(values.end(), bars.begin(), bars.end());
  if (!plot.is_log_y) values.push_back(0);
  const Axis y_axis(values, plot.is_log_y);
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
    out +=
        fmt::format("<rect x='{}' y='{}' width='12' height='12' fill='{}'/>\n", kLegendX, legend_y(i) - 6, colour(i));
    out += text(kLegendX + 20, legend_y(i) + 4, "start", escaped_markup(name));
  }
  for (std::size_t g = 0; g < plot.groups.size(); ++g) {
    out += text(kLeft + group_width * (static_cast<double>(g) + 0.5), kTop + kInnerHeight + 18, "middle",
                escaped_markup(plot.groups[g]));
  }
  return out + frame() + "</svg>\n";
}

}  // namespace nearwall::studies
