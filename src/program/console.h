#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "nearwall/core/progress.h"

namespace nearwall::program {

/// How talkative a command is: options that every command has.
struct Manner {
  bool is_json = false;     ///< one JSON object on standard output in place of text
  bool is_quiet = false;    ///< results and errors only
  bool is_verbose = false;  ///< details, too
};

/// The two streams of the program: results go to standard output, talk to standard error.
/// It is also the progress sink: bars on a terminal, a line for each finished stage elsewhere, nothing if quiet. Every
/// call of the sink throws Interrupted once a stop has been asked for.
class Console final : public ProgressSink {
 public:
  explicit Console(Manner manner);

  const Manner& manner() const { return manner_; }

  /// A result as text; nothing under --json. \throws IoError if standard output takes no more
  void print(std::string_view text);
  /// The result as JSON; nothing without --json.
  void print_json(const nlohmann::json& json);
  /// The same, of text that is JSON already.
  void print_json_text(std::string_view json);
  void say(std::string_view text);     ///< talk: nothing if quiet
  void detail(std::string_view text);  ///< talk for --verbose
  void fail(std::string_view text);    ///< the error that ends the command: always

  void begin_stage(std::string_view name) override;
  void update(double fraction) override;
  void end_stage() override;
  void note(std::string_view text) override { say(text); }
  void warn(std::string_view text) override;

 private:
  using Clock = std::chrono::steady_clock;

  void write_result(std::string_view text);
  void write_talk(std::string_view text);
  void draw_bar(double fraction);
  void clear_bar();
  std::string bold(std::string_view text, int color) const;

  Manner manner_;
  bool is_terminal_;
  bool has_color_;
  bool has_bar_ = false;
  std::string stage_;
  Clock::time_point stage_begin_;
  Clock::time_point last_drawn_;
};

}  // namespace nearwall::program
