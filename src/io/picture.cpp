#include "nearwall/io/picture.h"

#include <sys/wait.h>

#include <chrono>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "io/file_bytes.h"
#include "io/picture_arguments.h"
#include "nearwall/core/errors.h"
#include "nearwall/core/helper_process.h"
#include "nearwall/io/pending_file.h"

namespace nearwall::io {
namespace {

constexpr std::chrono::seconds kPatience{60};
constexpr std::string_view kHelper = "nearwall-render";

void check(const PictureRequest& request) {
  constexpr int kSmallest = 16, kLargest = 16384;
  for (const int n : request.size) {
    if (n < kSmallest || n > kLargest) {
      throw InputError(fmt::format("picture size {} is outside of {} to {} pixels", n, kSmallest, kLargest));
    }
  }
  if (format_ending(request.output) != "png") {
    throw InputError(fmt::format("{}: pictures are written as .png", request.output.string()));
  }
  if (!std::filesystem::exists(request.input)) {
    throw InputError(fmt::format("{}: no such file", request.input.string()));
  }
}

}  // namespace

PictureResult render_picture(const PictureRequest& request) {
  check(request);
  const std::filesystem::path program = find_helper(kHelper);
  if (program.empty()) return {false, fmt::format("the program {} is not beside this one", kHelper)};

  PendingFile file(request.output);
  PictureRequest aside = request;
  aside.output = file.temporary();
  HelperProcess helper(program, to_arguments(aside));
  if (!helper.has_started()) return {false, fmt::format("{} cannot be started", program.string())};
  if (!helper.wait(kPatience)) {
    return {false, fmt::format("the picture was not ready after {} seconds", kPatience.count())};
  }

  const std::string message = helper.last_words();
  if (WIFSIGNALED(helper.status())) {
    return {false, fmt::format("rendering ended with signal {}: {}", WTERMSIG(helper.status()), message)};
  }
  switch (static_cast<RenderExit>(WEXITSTATUS(helper.status()))) {
    case RenderExit::Made:
      file.commit();
      return {true, {}};
    case RenderExit::Input:
      throw InputError(message);
    case RenderExit::Geometry:
      throw GeometryError(message);
    case RenderExit::Io:
      throw IoError(message);
    case RenderExit::NotPossible:
      break;
  }
  return {false, message.empty() ? "rendering failed" : message};
}

}  // namespace nearwall::io
