#pragma once

#include <string>
#include <vector>

namespace nearwall::program {

/// A table of text. Columns of numbers stand to the right.
class Table {
 public:
  struct Column {
    std::string title;
    bool is_number = false;
  };

  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// \param cells  as many as there are columns
  void add_row(std::vector<std::string> cells);
  bool is_empty() const { return rows_.empty(); }

  /// Columns aligned by blanks, a rule under the titles; ends in a newline.
  std::string to_text(const std::string& indent = "") const;
  std::string to_markdown() const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// Number of characters of UTF-8 text.
std::size_t text_width(const std::string& text);

/// 1234567 as "1,234,567".
std::string grouped(unsigned long long n);

/// Seconds for reading: "0.42 s", "3 min 05 s".
std::string duration(double seconds);

/// Bytes for reading: "1.2 GB".
std::string bytes(double n);

}  // namespace nearwall::program
