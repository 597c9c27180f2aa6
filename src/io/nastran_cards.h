#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/cursor.h"

namespace nearwall::io {

/// One statement of the bulk data: a name and fields, which may go on over several lines.
struct NastranCard {
  std::string name;                      ///< capital letters, without the star of the large form
  std::vector<std::string_view> fields;  ///< behind the name, without blanks round them; empty where the file has none
  FilePosition where;
};

/// Walks through the bulk data of a Nastran file: cards with fields of 8 or 16 characters or with commas, tabs to the
/// next multiple of 8, lines that go on. What stands before BEGIN BULK and behind ENDDATA is passed over.
class NastranCards {
 public:
  NastranCards(std::string_view bytes, std::string file);

  /// False at the end.
  bool next(NastranCard& card);

  /// Names of properties that comments give: ANSA's $ANSA_NAME_COMMENT;ID;PSHELL;NAME; and HyperMesh's
  /// $HMNAME PROP ID"NAME" or, for numbers without one, $HMNAME COMP ID"NAME"; Femap's $ Femap Property ID : NAME.
  std::string name_of_property(std::int64_t property) const;

 private:
  std::string_view cut_line();
  void go_to_bulk();
  /// To the next line that is neither empty nor a comment; without blanks and comments at its end.
  void advance();
  void read_comment(std::string_view comment);
  std::string_view name_field() const;
  /// The fields of the line, and empty ones for those that it lacks.
  void append_fields(NastranCard& card);

  std::string_view bytes_;
  std::string file_;
  std::size_t offset_ = 0;
  std::size_t n_lines_ = 0;
  std::string_view line_;             // empty at the end
  std::deque<std::string> expanded_;  // lines with their tabs as blanks: of this card and the next one
  std::map<std::int64_t, std::string> names_;
  std::map<std::int64_t, std::string> component_names_;
};

/// A real number as Nastran writes it: 1.5, 1.5-3, 1.5E-3, 1.5D-3; 0 for an empty field. \throws GeometryError at
/// `where`
double nastran_real(std::string_view field, const FilePosition& where, std::string_view what);

/// A whole number; 0 for an empty field. \throws GeometryError at `where`
std::int64_t nastran_integer(std::string_view field, const FilePosition& where, std::string_view what);

}  // namespace nearwall::io
