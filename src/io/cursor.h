#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace nearwall::io {

/// Where in a file something was found, for messages.
struct FilePosition {
  std::string_view file;
  bool in_binary = false;
  std::size_t number = 0;  ///< line, from 1; byte, from 0, in binary data
};

/// \throws GeometryError "FILE:LINE: what" or "FILE: byte N: what"
[[noreturn]] void fail_at(const FilePosition& where, std::string_view what);

/// Walks through the bytes of a surface file: words, numbers and lines of text, and binary values. Lines end in LF,
/// CRLF or CR. All failures are GeometryErrors that name the file and the line or byte.
class Cursor {
 public:
  /// \param file     its name, for messages
  /// \param comment  words that begin with this character reach to the end of their line and are skipped; 0: none
  Cursor(std::string_view bytes, std::string file, char comment = 0)
      : bytes_(bytes), file_(std::move(file)), comment_(comment) {}

  /// Next word, over line ends; empty at the end of the file.
  std::string_view word();
  /// Next word of the current line; empty at its end.
  std::string_view word_of_line();
  /// The rest of the current line without blanks round it; stops at the line end.
  std::string_view rest_of_line();
  /// Goes to the first word of the next line that has one; false at the end of the file.
  bool next_line();
  /// The line end at the cursor, or what is left of the line, is passed: binary data begins behind it.
  void pass_line_end();

  /// Next word as a finite number / as a whole number. `what` names it in the message.
  double number(std::string_view what) { return to_number(word(), what); }
  std::int64_t integer(std::string_view what) { return to_integer(word(), what); }
  double to_number(std::string_view word, std::string_view what) const;
  std::int64_t to_integer(std::string_view word, std::string_view what) const;
  /// A count that claims at least `bytes_each` bytes of the rest of the file for each of its items.
  std::size_t count(std::string_view what, std::size_t bytes_each);
  /// The same for a count already read.
  std::size_t checked_count(std::int64_t claimed, std::string_view what, std::size_t bytes_each) const;

  /// The next n bytes. `what` names them in the message if the file ends before.
  std::string_view bytes(std::size_t n, std::string_view what);
  /// The next value in the given byte order.
  template <class T>
  T value(std::endian order, std::string_view what) {
    return decode<T>(bytes(sizeof(T), what).data(), order);
  }
  template <class T>
  static T decode(const char* from, std::endian order);

  std::size_t offset() const { return offset_; }
  void seek(std::size_t offset) { offset_ = offset; }
  std::size_t left() const { return bytes_.size() - offset_; }
  std::string_view all() const { return bytes_; }
  const std::string& file() const { return file_; }

  /// From now on "1,5" is read as 1.5, as programs in some countries write it.
  void allow_decimal_comma() { has_decimal_comma_ = true; }

  /// From now on positions are given in bytes.
  void enter_binary() { in_binary_ = true; }
  FilePosition position() const { return {file_, in_binary_, in_binary_ ? offset_ : line_}; }
  [[noreturn]] void fail(std::string_view what) const { fail_at(position(), what); }
  /// "expected WHAT, found 'WORD'"
  [[noreturn]] void fail_expected(std::string_view what, std::string_view found) const;

 private:
  void skip_blanks();
  bool at_line_end() const;

  std::string_view bytes_;
  std::string file_;
  char comment_;
  std::size_t offset_ = 0;
  std::size_t line_ = 1;
  bool in_binary_ = false;
  bool has_decimal_comma_ = false;
};

template <class T>
T Cursor::decode(const char* from, std::endian order) {
  char raw[sizeof(T)];
  std::memcpy(raw, from, sizeof(T));
  if (order != std::endian::native) {
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  }
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

/// Are the two the same but for upper and lower case (ASCII)?
bool same_word(std::string_view a, std::string_view b);
std::string_view trimmed(std::string_view text);
/// Text from a file, made fit for a message: short, without control characters.
std::string quoted(std::string_view text);

}  // namespace nearwall::io
