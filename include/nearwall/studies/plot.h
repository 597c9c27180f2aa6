#pragma once

#include <string>
#include <utility>
#include <vector>

namespace nearwall::studies {

/// A line of a plot, or the bars of one colour.
struct Series {
  std::string name;
  std::vector<std::pair<double, double>> points;  ///< (x, y); those that the axes cannot show are left out
};

/// Lines with markers over two axes, each linear or logarithmic.
struct LinePlot {
  std::string title, x_label, y_label;
  bool is_log_x = false, is_log_y = false;
  bool has_markers = true;
  std::vector<Series> series = {};
};

/// Groups of bars, one bar of each series in a group.
struct BarPlot {
  std::string title, y_label;
  bool is_log_y = false;
  std::vector<std::string> groups = {};
  std::vector<std::pair<std::string, std::vector<double>>> series = {};  ///< name, (n_groups) values
};

/// The plot as a complete SVG 1.1 document on a white ground, readable in light and dark viewers: fonts, colours and
/// sizes are within, nothing is loaded.
/// \throws InputError if there is nothing to show, or if a series has not as many bars as there are groups
std::string to_svg(const LinePlot& plot);
std::string to_svg(const BarPlot& plot);

}  // namespace nearwall::studies
