#include "nearwall/core/progress.h"

namespace nearwall {

namespace {

class SilentSink final : public ProgressSink {
 public:
  void begin_stage(std::string_view) override {}
  void update(double) override {}
  void end_stage() override {}
  void note(std::string_view) override {}
  void warn(std::string_view) override {}
};

}  // namespace

ProgressSink& silent_progress() {
  static SilentSink sink;
  return sink;
}

}  // namespace nearwall
