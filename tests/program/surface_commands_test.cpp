#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "nearwall/io/surface_reader.h"
#include "nearwall/io/surface_writer.h"
#include "tests/program/workplace.h"

namespace nearwall::program {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(CheckCommand, FindsTheCubeUsable) {
  Workplace place;
  place.write_cube("cube.obj");
  const Outcome outcome = place.run({"check", "cube.obj", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["usable"], true);
  EXPECT_EQ(result["points"], 8);
  EXPECT_EQ(result["triangles"], 12);
  EXPECT_EQ(result["components"], 1);
  EXPECT_EQ(result["faults"], json::array());
  EXPECT_EQ(result["ridges"]["convex"], 12);
  EXPECT_EQ(result["ridges"]["concave"], 0);
  EXPECT_EQ(result["corners"], 8);
  EXPECT_EQ(result["blind"], 0);
}

TEST(CheckCommand, SeesTheCubeFromInsideAsConcave) {
  Workplace place;
  place.write_cube("cube.obj");
  const json result = json::parse(place.run({"check", "cube.obj", "--json", "--fluid", "inside"}).out);
  EXPECT_EQ(result["ridges"]["convex"], 0);
  EXPECT_EQ(result["ridges"]["concave"], 12);
}

TEST(CheckCommand, SeesEdgesFromTheFluidOnFaultySurfacesToo) {
  Workplace place;
  const auto edges = [&](const std::string& file, const std::string& fluid) {
    const json result = json::parse(place.run({"check", file, "--json", "--fluid", fluid}).out);
    EXPECT_EQ(result["usable"], false);
    return std::pair(result["ridges"]["convex"].get<int>(), result["ridges"]["concave"].get<int>());
  };
  place.write_cube("cube.obj");
  mesh::SurfaceMesh cube = io::read_surface(place.path("cube.obj"));
  for (auto& face : cube.faces) std::swap(face[0], face[1]);
  io::write_surface(place.path("inside-out.obj"), cube);
  EXPECT_EQ(edges("inside-out.obj", "outside"), std::pair(12, 0));
  EXPECT_EQ(edges("inside-out.obj", "inside"), std::pair(0, 12));
  place.write_open_cube("open.obj");
  const auto [convex, concave] = edges("open.obj", "outside");
  EXPECT_GT(convex, 0);
  EXPECT_EQ(concave, 0);
  EXPECT_EQ(edges("open.obj", "inside"), std::pair(0, convex));
}

TEST(CheckCommand, CallsNoEdgeOfTheCubeARidgeOverItsTurn) {
  Workplace place;
  place.write_cube("cube.obj");
  const json result = json::parse(place.run({"check", "cube.obj", "--json", "--ridge-angle", "91"}).out);
  EXPECT_EQ(result["ridges"]["convex"], 0);
}

TEST(CheckCommand, ExitsWith1AndShowsTheFaults) {
  Workplace place;
  place.write_open_cube("open.obj");
  const Outcome outcome = place.run({"check", "open.obj", "--json", "-o", "faults.vtp"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["usable"], false);
  int n_open = 0;
  std::size_t n_triangles = 0;
  for (const json& fault : result["faults"]) {
    EXPECT_EQ(fault["kind"], "open-edge");
    EXPECT_FALSE(fault["where"].empty());
    n_open += fault["count"].get<int>();
    n_triangles += fault["triangles"].size();
  }
  EXPECT_EQ(n_open, 3);
  // Three triangles lie round the hole: two of the sides and the one that is left of the top.
  EXPECT_EQ(n_triangles, 3u);
  EXPECT_EQ(io::read_surface(place.path("faults.vtp")).faces.size(), 3u);
}

TEST(CheckCommand, TellsFaultsInWords) {
  Workplace place;
  place.write_open_cube("open.obj");
  const Outcome outcome = place.run({"check", "open.obj"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("open-edge: "));
}

TEST(CheckCommand, ExitsWith2IfThereIsNoSuchFile) {
  const Outcome outcome = Workplace().run({"check", "missing.stl"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("missing.stl"));
}

TEST(CheckCommand, ExitsWith3IfTheContentIsNoSurface) {
  Workplace place;
  place.write("bad.obj", "v 0 0 0\nf 1 2 3\n");
  const Outcome outcome = place.run({"check", "bad.obj"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("bad.obj"));
}

TEST(NormalsCommand, WritesNormalsOfClosedAndOpenSurfaces) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_open_cube("open.obj");
  for (const char* name : {"cube.obj", "open.obj"}) {
    const Outcome outcome = place.run({"normals", name, "--method", "most-visible", "-o", "normals.vtp", "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const json result = json::parse(outcome.out);
    EXPECT_EQ(result["points"], 8);
    EXPECT_EQ(result["blind"], 0);
    // A cube's corner sees its three faces best along the diagonal, under arccos(1 / sqrt(3)).
    EXPECT_NEAR(result["largest_visibility_angle"].get<double>(), 54.735610317245346, 1e-6);
    const std::string file = place.read("normals.vtp");
    for (const char* array :
         {"Normals", "VisibilityAngle", "PointKind", "Patches", "Groups", "Fallback", "Vertex", "Turn"}) {
      EXPECT_THAT(file, HasSubstr("\"" + std::string(array) + "\""));
    }
  }
}

TEST(NormalsCommand, WritesOverNoSurfaceOfAnotherFormat) {
  Workplace place;
  place.write_cube("cube.obj");
  const std::string before = place.read("cube.obj");
  for (const char* name : {"cube.obj", "normals.stl", "normals"}) {
    const Outcome outcome = place.run({"normals", "cube.obj", "-o", name});
    EXPECT_EQ(outcome.exit_code, 2) << name;
    EXPECT_THAT(outcome.err, HasSubstr("ends in .vtp"));
  }
  EXPECT_EQ(place.read("cube.obj"), before);
  place.write_open_cube("open.obj");
  EXPECT_EQ(place.run({"check", "open.obj", "-o", "open.obj"}).exit_code, 2);
}

TEST(Lengths, AreFiniteAndNotNegativeAndTheAnswerIsShort) {
  Workplace place;
  place.write_cube("cube.obj");
  for (const char* length : {"-1", "nan", "inf", "1e400", "1m", ""}) {
    const Outcome outcome = place.run({"check", "cube.obj", "--weld", length});
    EXPECT_EQ(outcome.exit_code, 2) << length;
    EXPECT_THAT(outcome.err, HasSubstr("expected a number of at least 0"));
    EXPECT_LT(outcome.err.size(), 200u);
  }
  EXPECT_EQ(place.run({"check", "cube.obj", "--weld", "1e-9"}).exit_code, 0);
}

TEST(NormalsCommand, KnowsAllMethodsAndFilters) {
  Workplace place;
  place.write_open_cube("open.obj");
  for (const char* method : {"most-normal", "kallinderis", "little-1/2", "angle-over-circumarea", "nielson"}) {
    const Outcome outcome = place.run(
        {"normals", "open.obj", "--method", method, "--filter", "most-visible-taubin", "-o", "n.vtp", "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << method << outcome.err;
    EXPECT_EQ(json::parse(outcome.out)["method"], method);
  }
  const Outcome method = place.run({"normals", "open.obj", "--method", "most-visibel", "-o", "n.vtp"});
  EXPECT_EQ(method.exit_code, 2);
  EXPECT_THAT(method.err, HasSubstr("did you mean 'most-visible'?"));
  const Outcome filter = place.run({"normals", "open.obj", "--filter", "taubim", "-o", "n.vtp"});
  EXPECT_EQ(filter.exit_code, 2);
  EXPECT_THAT(filter.err, HasSubstr("did you mean 'taubin'?"));
}

TEST(NormalsCommand, GivesEachDiscretePatchAPointOfItsOwn) {
  Workplace place;
  place.write_cube("cube.obj");
  const auto points = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"normals", "cube.obj", "-o", "n.vtp", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = place.run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out);
  };
  EXPECT_EQ(points({"--per", "patch"})["points"], 24);
  EXPECT_EQ(points({"--per", "patch"})["largest_visibility_angle"], 0);
  EXPECT_EQ(points({"--per", "group"})["points"], 8);
  EXPECT_EQ(points({"--per", "group", "--multi-angle", "80"})["points"], 24);
  const Outcome wrong = place.run({"normals", "cube.obj", "-o", "n.vtp", "--per", "patch", "--method", "hardy"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("hardy"));
  EXPECT_EQ(place.run({"normals", "cube.obj", "-o", "n.vtp", "--per", "patch", "--filter", "taubin"}).exit_code, 2);
}

TEST(ConvertCommand, KeepsPointsTrianglesAndPatches) {
  Workplace place;
  place.write_cube("cube.obj");
  EXPECT_EQ(place.run({"convert", "cube.obj", "cube.vtp"}).exit_code, 0);
  EXPECT_EQ(place.run({"convert", "cube.vtp", "again.obj.gz"}).exit_code, 0);
  const auto first = io::read_surface(place.path("cube.obj"));
  const auto last = io::read_surface(place.path("again.obj.gz"));
  EXPECT_EQ(first.points, last.points);
  EXPECT_EQ(first.faces, last.faces);
  EXPECT_EQ(first.patch_names, last.patch_names);
  EXPECT_EQ(first.face_patch, last.face_patch);
}

TEST(ConvertCommand, MakesEqualPointsOneIfAsked) {
  Workplace place;
  place.write_cube("cube.obj");
  ASSERT_EQ(place.run({"convert", "cube.obj", "cube.stl"}).exit_code, 0);
  EXPECT_EQ(json::parse(place.run({"convert", "cube.stl", "a.ply", "--json"}).out)["points"], 36);
  EXPECT_EQ(json::parse(place.run({"convert", "cube.stl", "b.ply", "--json", "--weld", "0"}).out)["points"], 8);
}

TEST(ConvertCommand, RefusesAnEndingItDoesNotKnow) {
  Workplace place;
  place.write_cube("cube.obj");
  EXPECT_EQ(place.run({"convert", "cube.obj", "cube.xyz"}).exit_code, 2);
  EXPECT_FALSE(place.has("cube.xyz"));
}

TEST(ShapeCommand, ListsTheCatalogue) {
  const json list = json::parse(Workplace().run({"shape", "--json"}).out)["shapes"];
  ASSERT_FALSE(list.empty());
  for (const json& shape : list) EXPECT_FALSE(shape["summary"].get<std::string>().empty()) << shape;
}

TEST(ShapeCommand, HelpsWithEachShape) {
  Workplace place;
  for (const json& shape : json::parse(place.run({"shape", "--json"}).out)["shapes"]) {
    const std::string name = shape["name"];
    const Outcome help = place.run({"shape", name, "--help"});
    EXPECT_EQ(help.exit_code, 0) << name;
    EXPECT_THAT(help.out, HasSubstr("example\n  nearwall shape " + name));
    for (const json& parameter : shape["parameters"]) {
      EXPECT_THAT(help.out, HasSubstr("--" + parameter["name"].get<std::string>()));
    }
  }
}

TEST(ShapeCommand, WritesAFinerSphereForASmallerSize) {
  Workplace place;
  const json coarse = json::parse(place.run({"shape", "sphere", "--size", "0.4", "-o", "coarse.stl", "--json"}).out);
  const json fine = json::parse(place.run({"shape", "sphere", "--size", "0.2", "-o", "fine.stl", "--json"}).out);
  EXPECT_GT(fine["triangles"], 2 * coarse["triangles"].get<int>());
  EXPECT_EQ(io::read_surface(place.path("fine.stl")).faces.size(), fine["triangles"].get<std::size_t>());
}

TEST(ShapeCommand, NamesTheNearestShapeAndParameter) {
  const Outcome shape = Workplace().run({"shape", "spehre", "-o", "a.stl"});
  EXPECT_EQ(shape.exit_code, 2);
  EXPECT_THAT(shape.err, HasSubstr("did you mean 'sphere'?"));
  const Outcome parameter = Workplace().run({"shape", "sphere", "--radiu", "2", "-o", "a.stl"});
  EXPECT_EQ(parameter.exit_code, 2);
  EXPECT_THAT(parameter.err, HasSubstr("did you mean '--radius'?"));
}

}  // namespace
}  // namespace nearwall::program
