// A stranger's program: calls of each kind that the contract promises, from the installed package alone.
#include <nearwall/core/vec3.h>
#include <nearwall/pipeline/run.h>
#include <nearwall/predicates/cells.h>
#include <nearwall/surface/normals.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

int main(int, char** argv) {
  using nearwall::Vec3;
  const std::array<Vec3, 3> normals = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  const auto visible = nearwall::surface::most_visible_normal(normals);
  if (!visible || std::abs(visible->max_angle - std::acos(1 / std::sqrt(3.0))) > 1e-12) return 1;

  // A cube's corner: 90 degrees less the angle to the planes' normals in a room's corner, as much beyond them outside.
  const Vec3 apex(0, 0, 0);
  const std::array<Vec3, 3> inner = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  const auto normal = nearwall::surface::most_normal_normal(apex, inner);
  if (!normal || !normal->in_visibility_cone) return 4;
  if (std::abs(normal->min_distance - std::asin(1 / std::sqrt(3.0))) > 1e-12) return 5;
  const Vec3 weighted = nearwall::surface::weighted_normal(nearwall::surface::Weight::Max, apex, inner);
  if (std::abs(weighted.x() - 1 / std::sqrt(3.0)) > 1e-13) return 6;

  const std::array<Vec3, 6> wedge = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0),
                                     Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1)};
  if (nearwall::predicates::wedge(wedge) != nearwall::predicates::Positivity::Positive) return 2;

  const std::filesystem::path folder = argv[1];
  std::ofstream(folder / "tetrahedron.off") << "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                               "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  std::ofstream(folder / "case.toml") << "format = 1\nname = \"tetrahedron\"\n[surface]\nfile = \"tetrahedron.off\"\n"
                                         "[layers]\nfirst_height = 0.001\ncount = 5\n[output]\npictures = false\n";
  const nearwall::Case settings = nearwall::read_case(folder / "case.toml");
  const nearwall::Report report = nearwall::run(settings);
  std::puts(report.certified ? "certified" : "not certified");
  return report.certified ? 0 : 3;
}
