#pragma once

#include <string>
#include <vector>

namespace nearwall::studies {

/// A table of numbers with a name for each row.
struct Table {
  std::string title;
  std::string row_title;                  ///< what the rows are
  std::vector<std::string> columns = {};  ///< titles of the numbers
  struct Row {
    std::string name;
    std::vector<double> values;  ///< (n_columns); NaN where there is none
  };
  std::vector<Row> rows = {};
};

/// A picture as SVG.
struct Picture {
  std::string file;   ///< name, such as "study-ubach-6.svg"
  std::string title;  ///< what it shows, in one line
  std::string svg;
};

/// What a study found out.
struct Report {
  std::string name;      ///< of the study, as on the command line
  std::string settings;  ///< one line: samples, seeds and the like
  std::vector<Table> tables = {};
  std::vector<Picture> pictures = {};
};

/// The table as Markdown, numbers with four digits, "–" for NaN.
std::string to_markdown(const Table& table);

/// Settings, tables and references to the pictures, which lie beside the text, as Markdown.
std::string to_markdown(const Report& report);

}  // namespace nearwall::studies
