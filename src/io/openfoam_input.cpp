#include "io/openfoam_input.h"

#include <fmt/format.h>

namespace nearwall::io {
namespace {

constexpr std::string_view kPunctuation = "(){}[];";

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\n' || c == '\r'; }

bool begins_number(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.'; }

/// Where the word that begins there ends. Brackets in pairs belong to a word, such as grad(p), but not to a number.
std::size_t end_of_word(std::string_view bytes, std::size_t begin) {
  const bool is_number = begins_number(bytes[begin]);
  std::size_t depth = 0;
  std::size_t end = begin;
  for (; end < bytes.size(); ++end) {
    const char c = bytes[end];
    if (is_space(c) || c == '"' || c == ';' || c == '{' || c == '}' || c == '[' || c == ']') break;
    if ((c == '(' && is_number) || (c == ')' && depth == 0)) break;
    if (c == '(') ++depth;
    if (c == ')') --depth;
  }
  return end;
}

}  // namespace

FoamInput::FoamInput(std::string_view bytes, const std::string& file) : in_(bytes, file) {
  read_header();
  if (is_binary_) in_.enter_binary();
}

void FoamInput::skip_blanks() {
  const std::string_view bytes = in_.all();
  const auto rest = [&] { return bytes.substr(in_.offset()); };
  while (in_.left() > 0) {
    const char c = bytes[in_.offset()];
    if (c == '\n' || c == '\r' || rest().starts_with("//")) {
      in_.pass_line_end();
    } else if (is_space(c)) {
      in_.seek(in_.offset() + 1);
    } else if (rest().starts_with("/*")) {
      const std::size_t end = bytes.find("*/", in_.offset() + 2);
      if (end == std::string_view::npos) fail("expected '*/' behind '/*', found the end of the file");
      while (bytes.substr(in_.offset(), end - in_.offset()).find_first_of("\n\r") != std::string_view::npos) {
        in_.pass_line_end();
      }
      in_.seek(end + 2);
    } else {
      return;
    }
  }
}

char FoamInput::peek() {
  skip_blanks();
  return in_.left() > 0 ? in_.all()[in_.offset()] : '\0';
}

std::string_view FoamInput::token() {
  skip_blanks();
  const std::string_view bytes = in_.all();
  const std::size_t begin = in_.offset();
  if (in_.left() == 0) return {};
  std::size_t end = begin + 1;
  if (bytes[begin] == '"') {
    while (end < bytes.size() && bytes[end] != '"' && bytes[end] != '\n') ++end;
    if (end == bytes.size() || bytes[end] == '\n') fail("expected '\"' at the end of a string");
    ++end;
  } else if (kPunctuation.find(bytes[begin]) == std::string_view::npos) {
    end = end_of_word(bytes, begin);
  }
  in_.seek(end);
  return bytes.substr(begin, end - begin);
}

void FoamInput::expect_token(std::string_view expected) {
  const std::string_view found = token();
  if (found != expected) in_.fail_expected(fmt::format("'{}'", expected), found);
}

void FoamInput::pass_token(std::string_view expected) {
  skip_blanks();
  if (in_.all().substr(in_.offset()).starts_with(expected)) in_.seek(in_.offset() + expected.size());
}

std::string_view FoamInput::unquoted(std::string_view token) {
  return token.size() >= 2 && token.front() == '"' ? token.substr(1, token.size() - 2) : token;
}

void FoamInput::skip_value() {
  std::size_t depth = 0;
  for (;;) {
    const std::string_view found = token();
    if (found.empty()) in_.fail_expected("';' or '}'", found);
    if (found == "{") ++depth;
    if (found == "}") {
      if (depth <= 1) return;
      --depth;
    }
    if (found == ";" && depth == 0) return;
  }
}

void FoamInput::read_header() {
  expect_token("FoamFile");
  expect_token("{");
  for (;;) {
    const std::string_view key = token();
    if (key == "}") break;
    if (key.empty()) in_.fail_expected("'}' at the end of the head", key);
    if (key != "format" && key != "class" && key != "arch") {
      skip_value();
      continue;
    }
    const std::string_view value = unquoted(token());
    if (key == "class") class_ = value;
    if (key == "arch") set_architecture(value);
    if (key == "format") {
      if (value != "ascii" && value != "binary") in_.fail_expected("format ascii or binary", value);
      is_binary_ = value == "binary";
    }
    expect_token(";");
  }
}

void FoamInput::set_architecture(std::string_view text) {
  order_ = text.find("MSB") != std::string_view::npos ? std::endian::big : std::endian::little;
  label_bytes_ = text.find("label=64") != std::string_view::npos ? 8 : 4;
  scalar_bytes_ = text.find("scalar=32") != std::string_view::npos ? 4 : 8;
}

FoamInput::List FoamInput::begin_list(std::string_view what, std::size_t bytes_each, std::uint64_t most) {
  List list;
  if (peek() == '(') {
    if (is_binary_ && bytes_each > 1) fail(fmt::format("expected {}, found '('", what));
    list.is_counted = false;
    expect_token("(");
    return list;
  }
  const std::int64_t n = integer(what);
  const bool is_raw = is_binary_ && bytes_each > 1;
  if (!is_raw && peek() == '{') {
    if (n < 0 || static_cast<std::uint64_t>(n) > most) {
      fail(fmt::format("expected {} of at most {}, found {}", what, most, n));
    }
    list.is_uniform = true;
    expect_token("{");
    list.value = label(what);
  } else {
    list.n = in_.checked_count(n, what, bytes_each);
    list.has_brackets = !(is_raw && n == 0);
    if (list.has_brackets) expect_token("(");
  }
  list.n = static_cast<std::size_t>(n);
  return list;
}

bool FoamInput::has_more(const List& list, std::size_t i) {
  if (list.is_counted) return i < list.n;
  return peek() != ')' && in_.left() > 0;
}

void FoamInput::end_list(const List& list) {
  if (list.has_brackets) expect_token(list.is_uniform ? "}" : ")");
}

std::int64_t FoamInput::label(std::string_view what) {
  if (!is_binary_) return in_.to_integer(token(), what);
  return label_bytes_ == 4 ? in_.value<std::int32_t>(order_, what) : in_.value<std::int64_t>(order_, what);
}

double FoamInput::scalar() {
  constexpr std::string_view kWhat = "a coordinate";
  if (!is_binary_) return in_.to_number(token(), kWhat);
  return scalar_bytes_ == 4 ? in_.value<float>(order_, kWhat) : in_.value<double>(order_, kWhat);
}

Vec3 FoamInput::point() {
  if (!is_binary_) expect_token("(");
  const double x = scalar(), y = scalar(), z = scalar();
  if (!is_binary_) expect_token(")");
  return {x, y, z};
}

}  // namespace nearwall::io
