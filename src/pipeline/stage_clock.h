#pragma once

#include <chrono>
#include <vector>

#include "nearwall/core/progress.h"
#include "nearwall/pipeline/report.h"

namespace nearwall::pipeline {

/// Hands everything on to another sink and keeps the times of the stages, the notes and the warnings for the report.
class StageClock final : public ProgressSink {
 public:
  explicit StageClock(ProgressSink& next) : next_(next) {}

  void begin_stage(std::string_view name) override;
  void update(double fraction) override { next_.update(fraction); }
  void end_stage() override;
  void note(std::string_view text) override;
  void warn(std::string_view text) override;

  /// Moves what was gathered into the report.
  void write_to(Report& report);

 private:
  using Clock = std::chrono::steady_clock;

  ProgressSink& next_;
  Clock::time_point begin_;
  std::vector<StageTime> stages_;
  std::vector<std::string> notes_;
  std::vector<std::string> warnings_;
};

}  // namespace nearwall::pipeline
