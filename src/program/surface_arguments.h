#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace nearwall::program {

/// What the commands that look at a surface have in common. Defaults and ranges are those of the case file.
struct SurfaceArguments {
  std::string file;
  double weld = 0;              ///< [length]
  double ridge_angle_deg = 40;  ///< [degrees]

  /// SURFACE, in the place where the command wants it.
  void add_argument(CLI::App& app);
  /// --weld and --ridge-angle.
  void add_options(CLI::App& app);
};

}  // namespace nearwall::program
