#include "io/cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// from_chars reports overflow and underflow alike; the wider type tells them apart (0, denormal or infinity).
double far_number(std::string_view word) {
  long double wide = 0;
  std::from_chars(word.data(), word.data() + word.size(), wide);
  return static_cast<double>(wide);
}

}  // namespace

void fail_at(const FilePosition& where, std::string_view what) {
  if (where.in_binary) throw GeometryError(fmt::format("{}: byte {}: {}", where.file, where.number, what));
  throw GeometryError(fmt::format("{}:{}: {}", where.file, where.number, what));
}

void Cursor::fail_expected(std::string_view what, std::string_view found) const {
  if (found.empty()) fail(fmt::format("expected {}, found the end of the {}", what, left() ? "line" : "file"));
  fail(fmt::format("expected {}, found '{}'", what, quoted(found)));
}

bool Cursor::at_line_end() const { return offset_ >= bytes_.size() || is_line_end(bytes_[offset_]); }

void Cursor::skip_blanks() {
  while (offset_ < bytes_.size() && is_blank(bytes_[offset_])) ++offset_;
  if (comment_ && offset_ < bytes_.size() && bytes_[offset_] == comment_) {
    while (!at_line_end()) ++offset_;
  }
}

std::string_view Cursor::word_of_line() {
  skip_blanks();
  const std::size_t begin = offset_;
  while (!at_line_end() && !is_blank(bytes_[offset_])) ++offset_;
  return bytes_.substr(begin, offset_ - begin);
}

std::string_view Cursor::word() {
  for (;;) {
    const std::string_view found = word_of_line();
    if (!found.empty() || offset_ >= bytes_.size()) return found;
    pass_line_end();
  }
}

std::string_view Cursor::rest_of_line() {
  const std::size_t begin = offset_;
  while (!at_line_end()) ++offset_;
  return trimmed(bytes_.substr(begin, offset_ - begin));
}

void Cursor::pass_line_end() {
  while (!at_line_end()) ++offset_;
  if (offset_ >= bytes_.size()) return;
  const bool carriage_return = bytes_[offset_++] == '\r';
  if (carriage_return && offset_ < bytes_.size() && bytes_[offset_] == '\n') ++offset_;
  ++line_;
}

bool Cursor::next_line() {
  do {
    if (offset_ >= bytes_.size()) return false;
    pass_line_end();
    skip_blanks();
  } while (at_line_end());
  return true;
}

double Cursor::to_number(std::string_view word, std::string_view what) const {
  std::string_view digits = word;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  std::string with_point;
  if (has_decimal_comma_ && digits.find(',') != std::string_view::npos && digits.find('.') == std::string_view::npos) {
    with_point = digits;
    with_point[with_point.find(',')] = '.';
    digits = with_point;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool all = end == digits.data() + digits.size() && !digits.empty();
  if (error == std::errc::result_out_of_range && all) value = far_number(digits);
  if (!all || error == std::errc::invalid_argument) {
    const bool comma = word.find(',') != std::string_view::npos;
    fail_expected(fmt::format("{}{}", what, comma ? " (a number with a decimal point, not a comma)" : ""), word);
  }
  if (!std::isfinite(value)) fail_expected(fmt::format("{} as a finite number", what), word);
  return value;
}

std::int64_t Cursor::to_integer(std::string_view word, std::string_view what) const {
  std::string_view digits = word;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) {
    fail_expected(fmt::format("{} (a whole number)", what), word);
  }
  return value;
}

std::size_t Cursor::checked_count(std::int64_t claimed, std::string_view what, std::size_t bytes_each) const {
  if (claimed < 0) fail(fmt::format("expected {}, found {}", what, claimed));
  if (static_cast<std::uint64_t>(claimed) > left() / std::max<std::size_t>(bytes_each, 1)) {
    fail(fmt::format("{} is {}, more than the {} bytes that follow can hold; the file is cut off or damaged", what,
                     claimed, left()));
  }
  return static_cast<std::size_t>(claimed);
}

std::size_t Cursor::count(std::string_view what, std::size_t bytes_each) {
  return checked_count(integer(what), what, bytes_each);
}

std::string_view Cursor::bytes(std::size_t n, std::string_view what) {
  if (n > left()) {
    fail(fmt::format("expected {} ({} bytes), found the end of the file after {} bytes; the file is cut off", what, n,
                     left()));
  }
  offset_ += n;
  return bytes_.substr(offset_ - n, n);
}

bool same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::string_view trimmed(std::string_view text) {
  const auto is_space = [](char c) { return is_blank(c) || is_line_end(c); };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string shown(text.substr(0, kLongest));
  std::ranges::replace_if(
      shown, [](unsigned char c) { return c < 0x20 || c >= 0x7f; }, '?');
  return text.size() > kLongest ? shown + "..." : shown;
}

}  // namespace nearwall::io
