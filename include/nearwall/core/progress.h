#pragma once

#include <string_view>
#include <type_traits>

namespace nearwall {

/// Where a long computation reports how far it is. The library never prints: a program implements this.
/// All calls come from one thread. `update` may throw Interrupted to stop the computation cleanly.
class ProgressSink {
 public:
  virtual ~ProgressSink() = default;
  /// A stage begins; stages do not nest. `name` is a short phrase such as "normals".
  virtual void begin_stage(std::string_view name) = 0;
  /// \param fraction  done so far of the stage, 0 to 1
  virtual void update(double fraction) = 0;
  virtual void end_stage() = 0;
  /// Something that a user wants to know but that stops nothing.
  virtual void note(std::string_view text) = 0;
  virtual void warn(std::string_view text) = 0;
};

/// The sink that drops everything; stands in where a caller gives none.
ProgressSink& silent_progress();

/// Runs one stage: `begin_stage`, the body, `end_stage`. \returns what the body returns
template <class Body>
auto staged(ProgressSink& progress, std::string_view name, const Body& body) {
  progress.begin_stage(name);
  if constexpr (std::is_void_v<decltype(body())>) {
    body();
    progress.end_stage();
  } else {
    auto result = body();
    progress.end_stage();
    return result;
  }
}

}  // namespace nearwall
