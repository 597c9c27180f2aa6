#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "nearwall/io/surface_reader.h"
#include "nearwall/io/volume_reader.h"
#include "tests/program/workplace.h"

namespace nearwall::program {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A legacy VTK file of hexahedra over 12 points: two unit cubes one upon the other, of which the second is at choice.
void write_cubes(const Workplace& place, const std::string& name, const std::string& second) {
  place.write(name,
              "# vtk DataFile Version 3.0\ncubes\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 12 double\n"
              "0 0 0  1 0 0  1 1 0  0 1 0\n0 0 1  1 0 1  1 1 1  0 1 1\n0 0 2  1 0 2  1 1 2  0 1 2\n"
              "CELLS 3 21\n2 0 1\n8 0 1 2 3 4 5 6 7\n8 " +
                  second + "\nCELL_TYPES 3\n3\n12\n12\n");
}

constexpr const char* kRight = "4 5 6 7 8 9 10 11";
constexpr const char* kInsideOut = "8 9 10 11 4 5 6 7";

json certify(Workplace& place, std::vector<std::string> more) {
  more.insert(more.begin(), "certify");
  more.emplace_back("--json");
  const Outcome outcome = place.run(more);
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["valid"], outcome.exit_code == 0);
  return result;
}

TEST(CertifyCommand, FindsOwnLayersValidWithTheLayersOfTheReport) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj");
  ASSERT_EQ(place.run({"run", "case.toml"}).exit_code, 0);
  const json result = certify(place, {"out/cube.vtu", "--wall", "cube.obj"});
  const json report = json::parse(place.read("out/report.json"));
  EXPECT_EQ(result["valid"], true);
  EXPECT_EQ(result["cells"], report["cells"]);
  EXPECT_EQ(result["points"], report["points"]);
  EXPECT_EQ(result["nonconforming_faces"], 0);
  EXPECT_EQ(result["intersections"], 0);
  EXPECT_EQ(result["covers_twice"], 0);
  EXPECT_EQ(result["offenders"], json::array());
  EXPECT_LT(result["closure"].get<double>(), 1e-14);
  EXPECT_EQ(result["wall"]["matched"]["exactly"], 12);
  for (const auto& [name, patch] : report["patches"].items()) {
    const json& found = result["wall"]["patches"].at(name);
    for (const char* key : {"area", "all_layers_percent", "any_percent", "mean_layers"}) {
      EXPECT_NEAR(found[key].get<double>(), patch[key].get<double>(), 1e-12) << key;
    }
    for (const char* key : {"median", "p01", "p99"}) {
      EXPECT_NEAR(found["first_height"][key].get<double>(), patch["first_height"][key].get<double>(), 1e-15) << key;
    }
    EXPECT_NEAR(found["thickness"]["median"].get<double>(), patch["thickness"]["median"].get<double>(), 1e-15);
    EXPECT_EQ(found["count"]["all"], 3);
  }
}

TEST(CertifyCommand, SaysInWordsThatAMeshIsValid) {
  Workplace place;
  write_cubes(place, "two.vtk", kRight);
  const Outcome outcome = place.run({"certify", "two.vtk"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("two.vtk: valid"));
  EXPECT_THAT(outcome.out, HasSubstr("2 hexahedra"));
}

TEST(CertifyCommand, NamesCellsByTheirNumbersInTheFileAndWritesThem) {
  Workplace place;
  write_cubes(place, "two.vtk", kInsideOut);
  const json result = certify(place, {"two.vtk", "-o", "cells.vtu", "-o", "faces.vtp"});
  EXPECT_EQ(result["valid"], false);
  EXPECT_EQ(result["skipped_cells"], 1);
  EXPECT_EQ(result["not_positive"]["hexahedron"], 1);
  EXPECT_EQ(result["undecided"]["hexahedron"], 0);
  ASSERT_EQ(result["offenders"].size(), 1u);
  EXPECT_EQ(result["offenders"][0]["cell"], 2) << "a line comes first in the file";
  EXPECT_EQ(result["offenders"][0]["type"], "hexahedron");
  EXPECT_EQ(result["offenders"][0]["centre"], (std::vector<double>{0.5, 0.5, 1.5}));
  EXPECT_EQ(result["nonconforming"][0]["fault"], "same-side");
  EXPECT_TRUE(result["closure"].is_null());
  EXPECT_EQ(io::read_volume_mesh(place.path("cells.vtu")).mesh.n_cells(), 1u);
  EXPECT_THAT(place.read("cells.vtu"), HasSubstr("\"Cell\""));
  // The one face between the cubes, as two triangles.
  EXPECT_EQ(io::read_surface(place.path("faces.vtp")).faces.size() % 2, 0u);
  EXPECT_THAT(place.read("faces.vtp"), HasSubstr("\"FaultNames\""));
  const Outcome words = place.run({"certify", "two.vtk"});
  EXPECT_THAT(words.out, HasSubstr("two.vtk: not valid"));
  EXPECT_THAT(words.out, HasSubstr("cell 2, hexahedron, at (0.5, 0.5, 1.5)"));
}

TEST(CertifyCommand, WritesNoFileOfWhatThereIsNot) {
  Workplace place;
  write_cubes(place, "two.vtk", kRight);
  certify(place, {"two.vtk", "-o", "cells.vtu", "-o", "faces.vtp"});
  EXPECT_FALSE(place.has("cells.vtu"));
  EXPECT_FALSE(place.has("faces.vtp"));
}

TEST(CertifyCommand, AdvisesToMergePointsThatCoincide) {
  Workplace place;
  place.write("apart.vtk",
              "# vtk DataFile Version 3.0\ncubes\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 16 double\n"
              "0 0 0  1 0 0  1 1 0  0 1 0  0 0 1  1 0 1  1 1 1  0 1 1\n"
              "0 0 1  1 0 1  1 1 1  0 1 1  0 0 2  1 0 2  1 1 2  0 1 2\n"
              "CELLS 2 18\n8 0 1 2 3 4 5 6 7\n8 8 9 10 11 12 13 14 15\nCELL_TYPES 2\n12\n12\n");
  const json result = certify(place, {"apart.vtk"});
  EXPECT_EQ(result["valid"], false);
  EXPECT_EQ(result["coincident_points"], 4);
  EXPECT_TRUE(result["covers_twice"].is_null());
  EXPECT_THAT(place.run({"certify", "apart.vtk"}).out, HasSubstr("merge equal points"));
}

TEST(CertifyCommand, NamesAsManyOffendersAsAskedFor) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj");
  ASSERT_EQ(place.run({"run", "case.toml", "--set", "output.formats=[\"vtu\"]"}).exit_code, 0);
  write_cubes(place, "two.vtk", kInsideOut);
  EXPECT_EQ(certify(place, {"two.vtk", "--offenders", "0"})["offenders"].size(), 0u);
  EXPECT_THAT(place.run({"certify", "two.vtk", "--offenders", "0"}).out, HasSubstr("and 1 more"));
}

TEST(CertifyCommand, RefusesWhatItCannotDo) {
  Workplace place;
  place.write_cube("cube.obj");
  write_cubes(place, "two.vtk", kRight);
  const auto exit_of = [&](const std::vector<std::string>& arguments) { return place.run(arguments).exit_code; };
  EXPECT_EQ(exit_of({"certify"}), 2);
  EXPECT_EQ(exit_of({"certify", "missing.vtu"}), 2);
  EXPECT_EQ(exit_of({"certify", "two.vtk", "-o", "faces.stl"}), 2);
  EXPECT_EQ(exit_of({"certify", "two.vtk", "--layers", "3"}), 2);
  EXPECT_EQ(exit_of({"certify", "two.vtk", "--wall", "missing.stl"}), 2);
  place.write("bad.vtu", "<VTKFile type=\"UnstructuredGrid\">");
  EXPECT_EQ(exit_of({"certify", "bad.vtu"}), 3);
  place.write("faces.vtk",
              "# vtk DataFile Version 3.0\nface\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n"
              "0 0 0  1 0 0  1 1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n");
  const Outcome none = place.run({"certify", "faces.vtk"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("nearwall check"));
}

TEST(CertifyCommand, DoesNotWriteOverTheMesh) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj");
  ASSERT_EQ(place.run({"run", "case.toml"}).exit_code, 0);
  EXPECT_EQ(place.run({"certify", "out/cube.vtu", "-o", "out/../out/cube.vtu"}).exit_code, 2);
}

}  // namespace
}  // namespace nearwall::program
