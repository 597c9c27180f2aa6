#include "pipeline/stage_clock.h"

#include <utility>

namespace nearwall::pipeline {

void StageClock::begin_stage(std::string_view name) {
  stages_.push_back({std::string(name), 0});
  begin_ = Clock::now();
  next_.begin_stage(name);
}

void StageClock::end_stage() {
  stages_.back().seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  next_.end_stage();
}

void StageClock::note(std::string_view text) {
  notes_.emplace_back(text);
  next_.note(text);
}

void StageClock::warn(std::string_view text) {
  warnings_.emplace_back(text);
  next_.warn(text);
}

void StageClock::write_to(Report& report) {
  report.stages = std::exchange(stages_, {});
  report.notes = std::exchange(notes_, {});
  report.warnings = std::exchange(warnings_, {});
}

}  // namespace nearwall::pipeline
