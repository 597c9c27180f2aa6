#include "io/nastran_cards.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace nearwall::io {
namespace {

constexpr std::size_t kFieldWidth = 8;
constexpr std::size_t kLastColumn = 72;  // behind it stand marks of lines that go on

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  std::ranges::transform(capitals, capitals.begin(), [](unsigned char c) { return std::toupper(c); });
  return capitals;
}

std::string with_blanks_for_tabs(std::string_view line) {
  std::string blanks;
  for (const char c : line) {
    if (c != '\t') {
      blanks += c;
    } else {
      blanks.append(kFieldWidth - blanks.size() % kFieldWidth, ' ');
    }
  }
  return blanks;
}

/// A whole number at the beginning, which is taken away with the blanks before it; −1: none.
std::int64_t take_number(std::string_view& text) {
  text = trimmed(text);
  std::int64_t number = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return -1;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (!same_word(text.substr(0, prefix.size()), prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

[[noreturn]] void fail_number(std::string_view field, const FilePosition& where, std::string_view what) {
  fail_at(where, fmt::format("expected {}, found '{}'", what, quoted(field)));
}

}  // namespace

NastranCards::NastranCards(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {
  go_to_bulk();
  advance();
}

std::string_view NastranCards::cut_line() {
  const std::size_t end = std::min(bytes_.find('\n', offset_), bytes_.size());
  const std::string_view line = bytes_.substr(offset_, end - offset_);
  offset_ = std::min(end + 1, bytes_.size());
  ++n_lines_;
  return line;
}

void NastranCards::go_to_bulk() {
  while (offset_ < bytes_.size()) {
    std::string_view line = trimmed(cut_line());
    if (take_prefix(line, "BEGIN") && in_capitals(line).find("BULK") != std::string::npos) return;
  }
  offset_ = 0;
  n_lines_ = 0;
}

void NastranCards::advance() {
  while (offset_ < bytes_.size()) {
    std::string_view line = cut_line();
    if (line.starts_with('$')) read_comment(line.substr(1));
    line = line.substr(0, line.find('$'));
    if (trimmed(line).empty()) continue;
    if (line.find('\t') != std::string_view::npos) line = expanded_.emplace_back(with_blanks_for_tabs(line));
    line_ = line;
    return;
  }
  line_ = {};
}

void NastranCards::read_comment(std::string_view comment) {
  comment = trimmed(comment);
  if (take_prefix(comment, "ANSA_NAME_COMMENT;")) {
    const std::int64_t property = take_number(comment);
    if (!take_prefix(comment, ";PSHELL;") && !take_prefix(comment, ";PSOLID;")) return;
    names_[property] = comment.substr(0, comment.find(';'));
  } else if (take_prefix(comment, "HMNAME ")) {
    const bool is_property = take_prefix(comment, "PROP");
    if (!is_property && !take_prefix(comment, "COMP")) return;
    const std::int64_t number = take_number(comment);
    const std::size_t open = comment.find('"');
    if (open == std::string_view::npos) return;
    comment.remove_prefix(open + 1);
    (is_property ? names_ : component_names_)[number] = comment.substr(0, comment.find('"'));
  } else if (take_prefix(comment, "Femap Property")) {
    const std::int64_t property = take_number(comment);
    comment = trimmed(comment);
    if (take_prefix(comment, ":")) names_[property] = trimmed(comment);
  }
}

std::string NastranCards::name_of_property(std::int64_t property) const {
  for (const auto* names : {&names_, &component_names_}) {
    const auto found = names->find(property);
    if (found != names->end() && !found->second.empty()) return found->second;
  }
  return fmt::format("pid{}", property);
}

std::string_view NastranCards::name_field() const {
  const std::string_view field = line_.substr(0, line_.find(','));
  return trimmed(field.substr(0, kFieldWidth));
}

bool NastranCards::next(NastranCard& card) {
  card.fields.clear();
  card.where = {file_, false, n_lines_};
  if (line_.empty()) return false;
  while (expanded_.size() > 1) expanded_.pop_front();  // the last may be this line
  card.name = in_capitals(name_field());
  if (card.name == "ENDDATA") return false;
  append_fields(card);
  if (card.name.ends_with('*')) card.name.pop_back();
  card.name = trimmed(card.name);
  advance();
  const auto goes_on = [&] {
    const std::string_view name = name_field();
    return !line_.empty() && (name.empty() || name.starts_with('+') || name.starts_with('*'));
  };
  while (goes_on()) {
    append_fields(card);
    advance();
  }
  return true;
}

void NastranCards::append_fields(NastranCard& card) {
  const bool is_large = name_field().find('*') != std::string_view::npos;
  const std::size_t n_fields = is_large ? 4 : 8, width = is_large ? 2 * kFieldWidth : kFieldWidth;
  const bool has_commas = line_.find(',') != std::string_view::npos;
  std::string_view rest = has_commas ? line_.substr(line_.find(',') + 1)
                                     : line_.substr(std::min(kFieldWidth, line_.size()), kLastColumn - kFieldWidth);
  for (std::size_t i = 0; i < n_fields; ++i) {
    const std::size_t end = has_commas ? std::min(rest.find(','), rest.size()) : std::min(width, rest.size());
    card.fields.push_back(trimmed(rest.substr(0, end)));
    rest.remove_prefix(std::min(rest.size(), has_commas ? end + 1 : end));
  }
}

double nastran_real(std::string_view field, const FilePosition& where, std::string_view what) {
  if (field.empty()) return 0;
  std::string text;
  for (const char c : field.substr(field.front() == '+' ? 1 : 0)) {
    const bool is_sign = c == '+' || c == '-';
    if (is_sign && !text.empty() && text.back() != 'e') text += 'e';
    if (c == '+') continue;
    const bool is_exponent = c == 'd' || c == 'D' || c == 'E';
    text += is_exponent ? 'e' : c;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    fail_number(field, where, what);
  return value;
}

std::int64_t nastran_integer(std::string_view field, const FilePosition& where, std::string_view what) {
  if (field.empty()) return 0;
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size()) fail_number(field, where, what);
  return value;
}

}  // namespace nearwall::io
