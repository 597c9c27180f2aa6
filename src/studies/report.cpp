#include "nearwall/studies/report.h"

#include <cmath>

#include <fmt/format.h>

namespace nearwall::studies {

namespace {

/// A number as in tables: four digits, "–" for NaN.
std::string shown(double value) {
  constexpr double kManyDigits = 1e3;  // from here on, four digits leave no room for a point
  if (std::isnan(value)) return "–";
  if (std::abs(value) >= kManyDigits) return fmt::format("{:.0f}", value);
  // Zeros at the end are digits, too; but counts stay counts.
  if (value == std::floor(value)) return fmt::format("{:g}", value);
  std::string text = fmt::format("{:#.4g}", value);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

std::string to_markdown(const Table& table) {
  std::string out = fmt::format("{}\n\n| {} |", table.title, table.row_title);
  for (const std::string& column : table.columns) out += fmt::format(" {} |", column);
  out += "\n| --- |";
  for (std::size_t i = 0; i < table.columns.size(); ++i) out += " ---: |";
  out += "\n";
  for (const Table::Row& row : table.rows) {
    out += fmt::format("| {} |", row.name);
    for (const double value : row.values) out += fmt::format(" {} |", shown(value));
    out += "\n";
  }
  return out;
}

std::string to_markdown(const Report& report) {
  std::string out = fmt::format("# Study {}\n\n{}\n", report.name, report.settings);
  for (const Table& table : report.tables) out += "\n" + to_markdown(table);
  for (const Picture& picture : report.pictures) {
    out += fmt::format("\n![{}]({})\n", picture.title, picture.file);
  }
  return out;
}

}  // namespace nearwall::studies
