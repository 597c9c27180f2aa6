// nearwall-render: makes one picture. A program of its own, because OpenGL without a display ends the process it is in.
// Called by render_picture (picture.cpp); the arguments are those of picture_arguments.h.

#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "io/picture_arguments.h"
#include "io/scene_vtk.h"
#include "io/x_display.h"
#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

int failed(RenderExit exit, std::string_view message) {
  fmt::print(stderr, "{}\n", message);
  return static_cast<int>(exit);
}

int render_here(const PictureRequest& request) try {
  render(request);
  return static_cast<int>(RenderExit::Made);
} catch (const InputError& error) {
  return failed(RenderExit::Input, error.what());
} catch (const GeometryError& error) {
  return failed(RenderExit::Geometry, error.what());
} catch (const IoError& error) {
  return failed(RenderExit::Io, error.what());
} catch (const std::exception& error) {
  return failed(RenderExit::NotPossible, error.what());
}

/// Renders in a further process, which dies with this one. \returns its exit code; NotPossible if a signal ended it
int render_in_child(const PictureRequest& request) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::_exit(render_here(request));
  }
  int status = 0;
  if (child < 0 || ::waitpid(child, &status, 0) != child || !WIFEXITED(status)) {
    return static_cast<int>(RenderExit::NotPossible);
  }
  return WEXITSTATUS(status);
}

bool is_final(int exit) {
  return exit == static_cast<int>(RenderExit::Made) || exit == static_cast<int>(RenderExit::Input) ||
         exit == static_cast<int>(RenderExit::Geometry) || exit == static_cast<int>(RenderExit::Io);
}

int make(const PictureRequest& request) {
  const char* display = std::getenv("DISPLAY");
  if (display && *display) {
    const int exit = render_in_child(request);
    if (is_final(exit)) return exit;
  }
  const PrivateDisplay own;
  if (!own.works()) return failed(RenderExit::NotPossible, own.reason());
  ::setenv("DISPLAY", own.name().c_str(), 1);
  const int exit = render_in_child(request);
  return is_final(exit) ? exit : failed(RenderExit::NotPossible, "OpenGL cannot render on this machine");
}

}  // namespace
}  // namespace nearwall::io

int main(int argc, char** argv) try {
  using namespace nearwall::io;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  return make(request_of(std::vector<std::string>(argv + 1, argv + argc)));
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return static_cast<int>(nearwall::io::RenderExit::Input);
}
