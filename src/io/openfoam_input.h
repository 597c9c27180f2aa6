#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/cursor.h"
#include "nearwall/core/vec3.h"

namespace nearwall::io {

/// One file of an OpenFOAM case: its head, then tokens, and lists in ascii or binary. Comments are passed over. All
/// failures are GeometryErrors that name the file and the line, or the byte in binary files.
class FoamInput {
 public:
  /// Reads the head. The bytes must outlive it.
  FoamInput(std::string_view bytes, const std::string& file);

  const std::string& foam_class() const { return class_; }

  /// A bracket, a semicolon, a string with its quotes or a word; empty at the end of the file.
  std::string_view token();
  void expect_token(std::string_view expected);
  /// Passes over the next token if it is this one.
  void pass_token(std::string_view expected);
  std::int64_t integer(std::string_view what) { return in_.to_integer(token(), what); }
  /// The text of a token without quotes, for keys and names.
  static std::string_view unquoted(std::string_view token);
  /// Passes over the value of an entry whose key was read: to its semicolon, or its closing brace.
  void skip_value();

  /// Calls visit(label) for each label of a list. `what` names it in messages.
  /// \param most  a list of equal labels, written as one, is not longer than this
  template <class Visit>
  void read_labels(std::string_view what, std::uint64_t most, const Visit& visit) {
    const List list = begin_list(what, is_binary_ ? label_bytes_ : 1, most);
    for (std::size_t i = 0; has_more(list, i); ++i) visit(list.is_uniform ? list.value : label(what));
    end_list(list);
  }
  /// Calls visit(point) for each point of a list; `expect(n)` before, where their number is known.
  template <class Expect, class Visit>
  void read_points(const Expect& expect, const Visit& visit) {
    constexpr std::size_t kLeastText = 7;  // (0 0 0)
    const List list = begin_list("number of points", is_binary_ ? 3 * scalar_bytes_ : kLeastText, 0);
    if (list.is_counted) expect(list.n);
    for (std::size_t i = 0; has_more(list, i); ++i) visit(point());
    end_list(list);
  }
  /// Calls visit(i) for each item of a list; it reads the item.
  template <class Visit>
  void read_items(std::string_view what, const Visit& visit) {
    const List list = begin_text_list(what);
    for (std::size_t i = 0; has_more(list, i); ++i) visit(i);
    end_list(list);
  }

  FilePosition position() const { return in_.position(); }
  [[noreturn]] void fail(std::string_view what) const { in_.fail(what); }

 private:
  /// N(…), (…) and, of equal labels, N{…}. Empty binary lists have no brackets.
  struct List {
    std::size_t n = 0;
    bool is_counted = true;
    bool is_uniform = false;
    bool has_brackets = true;
    std::int64_t value = 0;
  };

  void read_header();
  void set_architecture(std::string_view text);
  void skip_blanks();
  char peek();
  List begin_list(std::string_view what, std::size_t bytes_each, std::uint64_t most);
  List begin_text_list(std::string_view what) { return begin_list(what, 1, 0); }
  bool has_more(const List& list, std::size_t i);
  void end_list(const List& list);
  std::int64_t label(std::string_view what);
  double scalar();
  Vec3 point();

  Cursor in_;
  std::string class_;
  bool is_binary_ = false;
  std::endian order_ = std::endian::little;
  std::size_t label_bytes_ = 4;
  std::size_t scalar_bytes_ = 8;
};

}  // namespace nearwall::io
