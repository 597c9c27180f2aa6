#include "program/surface_arguments.h"

#include "program/cli.h"

namespace nearwall::program {

void SurfaceArguments::add_argument(CLI::App& app) {
  app.add_option("SURFACE", file, "stl obj ply off vtp vtk, also gzipped; msh su2 cgns ugrid bdf: faces with patches")
      ->required();
}

void SurfaceArguments::add_options(CLI::App& app) {
  app.add_option("--weld", weld, "distance within which points become one [length]; 0: equal points only")
      ->type_name("LENGTH")
      ->check(non_negative())
      ->capture_default_str();
  app.add_option("--ridge-angle", ridge_angle_deg, "turn from which an edge is a ridge [deg]")
      ->type_name("DEG")
      ->check(CLI::Range(1.0, 179.0))
      ->capture_default_str();
}

}  // namespace nearwall::program
