#include "program/console.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "nearwall/core/errors.h"
#include "program/interrupt.h"
#include "program/table.h"

namespace nearwall::program {

namespace {

constexpr int kRed = 31;
constexpr int kYellow = 33;
constexpr auto kRedrawInterval = std::chrono::milliseconds(100);
constexpr int kBarWidth = 30;
constexpr int kStageWidth = 24;

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

Console::Console(Manner manner)
    : manner_(manner), is_terminal_(isatty(STDERR_FILENO) == 1), has_color_(is_terminal_ && !is_set("NO_COLOR")) {}

void Console::print(std::string_view text) {
  if (!manner_.is_json) write_result(text);
}

void Console::print_json(const nlohmann::json& json) {
  // Names of files may hold bytes that are no UTF-8: they are replaced rather than refused.
  print_json_text(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

void Console::print_json_text(std::string_view json) {
  if (manner_.is_json) write_result(fmt::format("{}{}", json, json.ends_with('\n') ? "" : "\n"));
}

void Console::say(std::string_view text) {
  if (!manner_.is_quiet) write_talk(text);
}

void Console::detail(std::string_view text) {
  if (manner_.is_verbose) write_talk(text);
}

void Console::fail(std::string_view text) { write_talk(fmt::format("{} {}", bold("nearwall: error:", kRed), text)); }

void Console::warn(std::string_view text) { say(fmt::format("{} {}", bold("warning:", kYellow), text)); }

void Console::begin_stage(std::string_view name) {
  stop_if_interrupted();
  stage_ = name;
  stage_begin_ = Clock::now();
  last_drawn_ = stage_begin_;
  if (is_terminal_ && !manner_.is_quiet) draw_bar(0);
}

void Console::update(double fraction) {
  stop_if_interrupted();
  if (!is_terminal_ || manner_.is_quiet || Clock::now() - last_drawn_ < kRedrawInterval) return;
  draw_bar(fraction);
}

void Console::end_stage() {
  const double seconds = std::chrono::duration<double>(Clock::now() - stage_begin_).count();
  say(fmt::format("  {:<{}} {:>10}", stage_, kStageWidth, duration(seconds)));
  stop_if_interrupted();
}

void Console::write_result(std::string_view text) {
  clear_bar();
  const bool is_written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!is_written) throw IoError("standard output takes no more: is the disk full?");
}

void Console::write_talk(std::string_view text) {
  clear_bar();
  fmt::print(stderr, "{}{}", text, text.ends_with('\n') ? "" : "\n");
}

void Console::draw_bar(double fraction) {
  last_drawn_ = Clock::now();
  const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kBarWidth);
  fmt::print(stderr, "\r\033[K  {:<{}} [{:#<{}}{:.<{}}]", stage_, kStageWidth, "", filled, "", kBarWidth - filled);
  std::fflush(stderr);
  has_bar_ = true;
}

void Console::clear_bar() {
  if (!has_bar_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  has_bar_ = false;
}

std::string Console::bold(std::string_view text, int color) const {
  return has_color_ ? fmt::format("\033[1;{}m{}\033[0m", color, text) : std::string(text);
}

}  // namespace nearwall::program
