#include "program/table.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "nearwall/core/expect.h"

namespace nearwall::program {

namespace {

std::string padded(const std::string& text, std::size_t width, bool to_right) {
  const std::string blanks(width - std::min(width, text_width(text)), ' ');
  return to_right ? blanks + text : text + blanks;
}

void append_line(std::string& out, const std::string& line) {
  const auto end = line.find_last_not_of(' ');
  out += end == std::string::npos ? "" : line.substr(0, end + 1);
  out += '\n';
}

std::string markdown_cell(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '|') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

}  // namespace

void Table::add_row(std::vector<std::string> cells) {
  expect(cells.size() == columns_.size(), "a row has as many cells as the table has columns");
  rows_.push_back(std::move(cells));
}

std::string Table::to_text(const std::string& indent) const {
  std::vector<std::size_t> width;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    width.push_back(text_width(columns_[c].title));
    for (const auto& row : rows_) width[c] = std::max(width[c], text_width(row[c]));
  }
  std::string titles = indent, rule = indent, out;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    titles += padded(columns_[c].title, width[c], columns_[c].is_number) + "  ";
    rule += std::string(width[c], '-') + "  ";
  }
  append_line(out, titles);
  append_line(out, rule);
  for (const auto& row : rows_) {
    std::string line = indent;
    for (std::size_t c = 0; c < columns_.size(); ++c) line += padded(row[c], width[c], columns_[c].is_number) + "  ";
    append_line(out, line);
  }
  return out;
}

std::string Table::to_markdown() const {
  std::string titles = "|", rule = "|", out;
  for (const Column& column : columns_) {
    titles += fmt::format(" {} |", column.title);
    rule += column.is_number ? " ---: |" : " --- |";
  }
  out = titles + "\n" + rule + "\n";
  for (const auto& row : rows_) {
    out += "|";
    for (const std::string& cell : row) out += fmt::format(" {} |", markdown_cell(cell));
    out += "\n";
  }
  return out;
}

std::size_t text_width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

std::string grouped(unsigned long long n) {
  const std::string digits = std::to_string(n);
  std::string out;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) out += ',';
    out += digits[i];
  }
  return out;
}

std::string duration(double seconds) {
  if (seconds < 9.995) return fmt::format("{:.2f} s", seconds);
  if (seconds < 59.95) return fmt::format("{:.1f} s", seconds);
  const long whole = std::lround(seconds);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::string bytes(double n) {
  constexpr std::array<const char*, 5> kUnits = {"B", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  while (n >= 1000 && unit + 1 < kUnits.size()) {
    n /= 1000;
    ++unit;
  }
  return unit == 0 ? fmt::format("{:.0f} B", n) : fmt::format("{:.3g} {}", n, kUnits[unit]);
}

}  // namespace nearwall::program
