#include <cmath>
#include <fstream>
#include <functional>
#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "nearwall/core/errors.h"
#include "nearwall/io/polydata_writer.h"
#include "nearwall/layers/isotropic.h"
#include "nearwall/pipeline/run.h"
#include "nearwall/shapes/shapes.h"
#include "tests/pipeline/scratch_folder.h"

// Lengths that vertices have of their own, from the case file to the report.

namespace nearwall {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A sphere of radius 1 with two arrays, and what a case says of it.
class PatchLengths : public testing::Test {
 protected:
  PatchLengths() : surface_(shapes::make_shape("sphere", {}, 0.3)) {
    set("H", [](const Vec3& p) { return 0.002 * (1.5 + p.x()); });
    set("T", [](const Vec3& p) { return 0.1 * (1.2 + p.z()); });
  }

  void set(const std::string& name, const std::function<double(const Vec3&)>& value) {
    mesh::PointArray array{name, {}};
    for (const Vec3& p : surface_.points) array.values.push_back(value(p));
    surface_.point_arrays.push_back(std::move(array));
  }

  /// Settings in force on the sphere.
  PatchSettings resolved(const std::string& layers) const {
    const Case c = parse(layers);
    mesh::SurfaceMesh read = surface_;
    read.point_arrays.clear();
    for (const std::string& name : point_arrays(c)) {
      for (const auto& array : surface_.point_arrays) {
        if (array.name == name) read.point_arrays.push_back(array);
      }
    }
    check_point_arrays(c, read);
    return resolve_patches(c, read, mesh::Topology(read)).front();
  }

  std::string rejection(const std::string& layers) const {
    try {
      resolved(layers);
    } catch (const InputError& e) {
      return e.what();
    }
    return "accepted";
  }

  static Case parse(const std::string& layers) {
    return parse_case("[surface]\nfile = \"ball.vtp\"\n[layers]\n" + layers, "case.toml");
  }

  /// The point at which T is largest.
  Vec3 top() const {
    return *std::max_element(surface_.points.begin(), surface_.points.end(),
                             [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  }
  double largest(std::size_t array) const {
    const auto& values = surface_.point_arrays[array].values;
    return *std::max_element(values.begin(), values.end());
  }

  mesh::SurfaceMesh surface_;
};

TEST_F(PatchLengths, AreReadOnlyWhereTheyAreNamed) {
  EXPECT_TRUE(point_arrays(parse("first_height = 1e-3\n")).empty());
  EXPECT_EQ(point_arrays(parse("first_height = { array = \"H\" }\ntotal_thickness.array = \"T\"\n[patches.sphere]\n"
                               "first_height = { array = \"T\", factor = 0.5 }\n[patches.\"s*\"]\ntotal_thickness = { "
                               "array = \"U\" }\n")),
            (std::vector<std::string>{"H", "T", "U"}));
}

TEST_F(PatchLengths, OfOneKindScaleTheWholeStack) {
  const PatchSettings first = resolved("first_height = { array = \"H\", factor = 2 }\ngrowth = 1.3\ncount = 7\n");
  EXPECT_DOUBLE_EQ(first.schedule.first_height, 2 * largest(0));
  EXPECT_EQ(first.schedule.count, 7);
  EXPECT_DOUBLE_EQ(first.schedule.growth, 1.3);
  ASSERT_TRUE(first.first_height);
  EXPECT_EQ(first.first_height->array, 0u);
  EXPECT_EQ(first.first_height->factor, 2);
  EXPECT_FALSE(first.total_thickness);
  const PatchSettings total = resolved("total_thickness = { array = \"T\" }\ncount = 7\n");
  EXPECT_DOUBLE_EQ(total.schedule.total_thickness, largest(1));
  EXPECT_DOUBLE_EQ(total.largest_thickness, largest(1));
  EXPECT_DOUBLE_EQ(total.schedule.growth, 1.2);
  EXPECT_FALSE(total.first_height);
  const PatchSettings table = resolved("total_thickness = { array = \"T\" }\nheights = [1, 2, 4]\n");
  EXPECT_EQ(table.schedule.heights, (std::vector<double>{1, 2, 4})) << "its form counts";
}

TEST_F(PatchLengths, OfBothKindsHaveTheCountOfTheLargestRatio) {
  double largest = 0;
  for (const Vec3& p : surface_.points) largest = std::max(largest, 0.1 * (1.2 + p.z()) / (0.002 * (1.5 + p.x())));
  const PatchSettings p = resolved("first_height = { array = \"H\" }\ntotal_thickness = { array = \"T\" }\n");
  const auto thickness = [](double growth, int n) { return (std::pow(growth, n) - 1) / (growth - 1); };
  EXPECT_GE(thickness(1.2, p.schedule.count), largest * (1 - 1e-4));
  EXPECT_LT(thickness(1.2, p.schedule.count - 1), largest);
  EXPECT_NEAR(p.schedule.total_thickness / p.schedule.first_height, largest, 1e-9 * largest);
  EXPECT_LE(p.schedule.growth, 1.2);
  const PatchSettings counted =
      resolved("first_height = { array = \"H\" }\ntotal_thickness = { array = \"T\" }\ncount = 12\n");
  EXPECT_EQ(counted.schedule.count, 12);
  EXPECT_NEAR(thickness(counted.schedule.growth, 12), largest, 1e-9 * largest);
}

TEST_F(PatchLengths, MayBeANumberAndAnArray) {
  const PatchSettings p = resolved("first_height = 1e-3\ntotal_thickness = { array = \"T\" }\n");
  ASSERT_TRUE(p.first_height && p.total_thickness);
  EXPECT_FALSE(p.first_height->array);
  EXPECT_EQ(p.first_height->factor, 1e-3);
  EXPECT_NEAR(p.schedule.total_thickness, largest(1), 1e-12);
  const PatchSettings by_y_plus = resolved(
      "y_plus = 1\ntotal_thickness = { array = \"T\" }\n[flow]\nvelocity = 50\nkinematic_viscosity = "
      "1.5e-5\nreference_length = 1\n");
  EXPECT_NEAR(by_y_plus.schedule.total_thickness, largest(1), 1e-12);
  EXPECT_DOUBLE_EQ(by_y_plus.first_height->factor, by_y_plus.schedule.first_height);
}

TEST_F(PatchLengths, ThatAreTooThinForTheirLayersAreUniform) {
  const PatchSettings p = resolved("first_height = 0.1\ntotal_thickness = { array = \"T\" }\ncount = 5\n");
  EXPECT_EQ(p.schedule.growth, 1);
  EXPECT_EQ(p.schedule.count, 5);
  EXPECT_EQ(resolved("first_height = 0.5\ntotal_thickness = { array = \"T\" }\n").schedule.count, 1);
}

TEST_F(PatchLengths, NameThePlaceThatWouldHaveToGrowTooMuch) {
  const Vec3 p = top();
  EXPECT_THAT(
      rejection("first_height = 1e-5\ntotal_thickness = { array = \"T\" }\ncount = 5\n"),
      AllOf(StartsWith(fmt::format("case.toml:4:1: layers of patch \"sphere\": at ({:.6g}, {:.6g}, {:.6g}), where "
                                   "first_height is 1e-05 and total_thickness {:.6g}: 5 layers from first_height "
                                   "= 1e-05 would have to grow by more than 2 each",
                                   p.x(), p.y(), p.z(), largest(1))),
            HasSubstr("raise count")));
  EXPECT_THAT(rejection("first_height = 1e-3\nheights = [1, 2, 4]\n"), HasSubstr("takes heights alone"));
}

TEST_F(PatchLengths, HaveToBeAboveZeroWhereThereAreLayers) {
  const Vec3 place = top();
  for (const double bad : {0.0, -1.0, std::nan(""), kInfinity}) {
    surface_.point_arrays.clear();
    set("H", [&](const Vec3& p) { return p == place ? bad : 0.001; });
    EXPECT_THAT(
        rejection("first_height = { array = \"H\" }\n"),
        AllOf(StartsWith("case.toml:4:1: layers of patch \"sphere\": first_height: expected a number above 0 at "
                         "every point of the patch, found "),
              HasSubstr("in array \"H\" at point "),
              HasSubstr(fmt::format("at ({:.6g}, {:.6g}, {:.6g})", place.x(), place.y(), place.z()))));
    EXPECT_EQ(
        rejection("first_height = 1e-3\n[patches.sphere]\nfirst_height = { array = \"H\" }\ntype = \"nolayer\"\n"),
        "accepted")
        << "there is no layer to be";
  }
  surface_.point_arrays.clear();
  set("H", [](const Vec3&) { return 1e-200; });
  EXPECT_THAT(rejection("first_height = { array = \"H\", factor = 1e-200 }\n"), HasSubstr("found 1e-200"));
}

TEST_F(PatchLengths, GiveWayToThoseOfThePatch) {
  const std::string base = "first_height = { array = \"H\" }\ncount = 4\n[patches.sphere]\n";
  EXPECT_EQ(resolved(base + "first_height = 1e-3\n").schedule.first_height, 1e-3);
  EXPECT_FALSE(resolved(base + "first_height = 1e-3\n").first_height);
  const PatchSettings until = resolved(
      "total_thickness = 0.1\ngrowth = 1.3\n[patches.sphere]\nfirst_height = 1e-3\n"
      "until = \"isotropic\"\n");
  EXPECT_TRUE(until.is_until_isotropic);
}

TEST_F(PatchLengths, AreRefusedWhereTheInheritedEndContradictsThem) {
  const std::string base = "first_height = 1e-3\nuntil = \"isotropic\"\n[patches.sphere]\n";
  EXPECT_EQ(
      rejection(base + "total_thickness = 0.1\n"),
      "case.toml:7:1: patches.sphere: total_thickness and until = \"isotropic\", which is inherited, exclude each "
      "other; add until = \"count\" here, or leave total_thickness out");
  EXPECT_EQ(rejection(base + "total_thickness = 0.1\ntype = \"nolayer\"\n"), "accepted");
  const PatchSettings counted = resolved(base + "until = \"count\"\ntotal_thickness = 0.1\n");
  EXPECT_FALSE(counted.is_until_isotropic);
  EXPECT_NEAR(counted.schedule.total_thickness, 0.1, 1e-12);
}

TEST_F(PatchLengths, WarnWhereTheThicknessOverrulesTheFirstHeight) {
  // T is 0.1 (1.2 + z), from 0.02 to 0.22; ten layers of 0.01 are 0.1, more than T below z = -0.2. Of a sphere's area
  // the share below a height z is (1 + z) / 2.
  const PatchSettings p = resolved("first_height = 0.01\ntotal_thickness = { array = \"T\" }\ncount = 10\n");
  ASSERT_EQ(p.warnings.size(), 1u);
  EXPECT_THAT(p.warnings[0],
              AllOf(StartsWith("case.toml:4:1: layers of patch \"sphere\": total_thickness is less than 10 layers of "
                               "first_height on "),
                    HasSubstr("where first_height is 0.01 and total_thickness 0.02"),
                    HasSubstr("first heights lower (0.002"), HasSubstr("raise total_thickness")));
  const double percent = std::stod(p.warnings[0].substr(p.warnings[0].find(" on ") + 4));
  EXPECT_NEAR(percent, 40, 8) << "triangles are a third of the radius wide";
  EXPECT_TRUE(resolved("first_height = 0.001\ntotal_thickness = { array = \"T\" }\ncount = 10\n").warnings.empty());
}

TEST_F(PatchLengths, WarnWhereTheFirstLayerIsHigherThanIsotropicOnes) {
  const auto heights = layers::isotropic_heights(surface_, mesh::Topology(surface_));
  const double widest = *std::max_element(heights.begin(), heights.end());
  const PatchSettings p = resolved(fmt::format("first_height = {}\nuntil = \"isotropic\"\n", 2 * widest));
  ASSERT_EQ(p.warnings.size(), 1u);
  EXPECT_THAT(p.warnings[0], AllOf(StartsWith("case.toml:4:1: layers of patch \"sphere\": until = \"isotropic\": the "
                                              "first layer is higher already"),
                                   HasSubstr(" on 100.0 % of the area"), HasSubstr("lower first_height")));
  EXPECT_TRUE(resolved("first_height = 1e-3\nuntil = \"isotropic\"\n").warnings.empty());
}

TEST_F(PatchLengths, WarnWhereLayersEndBeforeTheyAreIsotropic) {
  for (const char* stack : {"first_height = 1e-3\ncount = 6\n", "heights = [1e-3, 2e-3]\n"}) {
    const PatchSettings p = resolved(std::string(stack) + "until = \"isotropic\"\n");
    ASSERT_EQ(p.warnings.size(), 1u) << stack;
    EXPECT_THAT(p.warnings[0], AllOf(HasSubstr("layers end before they are isotropic on 100.0 % of the area"),
                                     HasSubstr(fmt::format("the last is {:.4g} high", p.schedule.heights.back()))));
  }
  EXPECT_TRUE(resolved("first_height = 1e-3\ncount = 60\nuntil = \"isotropic\"\n").warnings.empty());
}

TEST_F(PatchLengths, WarnOnceForPatchesAlike) {
  mesh::SurfaceMesh box = shapes::make_shape("box", {}, 0.2);
  const Case c = parse("first_height = 1\nuntil = \"isotropic\"\n");
  std::vector<std::string> warnings;
  for (const PatchSettings& p : resolve_patches(c, box, mesh::Topology(box))) {
    warnings.insert(warnings.end(), p.warnings.begin(), p.warnings.end());
  }
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], HasSubstr(fmt::format("patch \"{}\" and those alike: ", box.patch_names[PatchId(0)])));
}

TEST_F(PatchLengths, UntilIsotropicHaveTheCountOfTheWidestTriangles) {
  const auto heights = layers::isotropic_heights(surface_, mesh::Topology(surface_));
  const double widest = *std::max_element(heights.begin(), heights.end());
  for (const char* more : {"", "law = \"accelerating\"\n", "growth = 1.05\n"}) {
    const PatchSettings p = resolved(std::string("first_height = 1e-3\nuntil = \"isotropic\"\n") + more);
    const auto& h = p.schedule.heights;
    const double ratio = h.back() / h[h.size() - 2];
    EXPECT_LE(std::abs(std::log(h.back() / widest)), 0.5 * std::log(ratio) * 1.1) << more;
  }
  EXPECT_EQ(resolved("first_height = 1e-3\nuntil = \"isotropic\"\ncount = 6\n").schedule.count, 6) << "at most";
  EXPECT_EQ(resolved("heights = [0.1, 0.2, 0.4, 0.8]\nuntil = \"isotropic\"\n").schedule.count, 2);
  EXPECT_THAT(rejection("first_height = 1e-3\ngrowth = 1\nuntil = \"isotropic\"\n"),
              HasSubstr("1000 layers are not enough"));
  EXPECT_EQ(resolved("first_height = 10\nuntil = \"isotropic\"\n").schedule.count, 2) << "so that one may start late";
}

/// Runs of the program's library on a file of the surface.
class RunWithLengths : public PatchLengths {
 protected:
  RunWithLengths() { write("ball.vtp"); }

  void write(const std::string& name) const {
    io::PolyDataFile file = io::polydata_of(surface_);
    for (const auto& array : surface_.point_arrays) file.point_data.push_back({array.name, array.values.raw()});
    io::write_polydata(folder_ / name, file);
  }

  Report run_case(const std::string& text) const {
    Case c = parse_case(text, folder_ / "case.toml");
    c.output.pictures = false;
    return run(c, RunOptions{folder_ / "out", false, true});
  }

  ScratchFolder folder_;
};

TEST_F(RunWithLengths, MeetsWhatEachTriangleWasAskedFor) {
  const Report r = run_case(
      "[surface]\nfile = \"ball.vtp\"\nscale = 4\n[layers]\nfirst_height = { array = \"H\", factor = 0.5 }\n"
      "total_thickness = { array = \"T\" }\n");
  ASSERT_EQ(r.patches.size(), 1u);
  const quality::PatchCoverage& c = r.patches[0].coverage;
  EXPECT_TRUE(r.certified);
  EXPECT_EQ(c.full_percent, 100);
  EXPECT_EQ(c.first_height_met_percent, 100);
  EXPECT_NEAR(c.asked_first_height.min, 4 * 0.5 * 0.002 * 0.5, 0.2 * c.asked_first_height.min);
  EXPECT_NEAR(c.asked_first_height.max, 4 * 0.5 * 0.002 * 2.5, 0.1 * c.asked_first_height.max);
  EXPECT_EQ(c.asked.first_height, c.asked_first_height.median);
  const auto json = nlohmann::json::parse(std::ifstream(folder_ / "out/report.json"));
  EXPECT_EQ(json["case"]["layers"]["first_height"]["array"], "H");
  EXPECT_EQ(json["case"]["layers"]["first_height"]["factor"], 0.5);
  EXPECT_EQ(json["patches"]["sphere"]["first_height"]["asked"], c.asked.first_height);
  EXPECT_EQ(json["patches"]["sphere"]["first_height"]["asked_range"][0], c.asked_first_height.min);
}

TEST(LengthsOfPatches, AreOneStackWhereTheSettingsAreTheSame) {
  mesh::SurfaceMesh box = shapes::make_shape("box", {}, 0.2);
  mesh::PointArray array{"T", {}};
  for (const Vec3& p : box.points) array.values.push_back(0.01 * (2 + p.x()));
  box.point_arrays.push_back(array);
  const Case c = parse_case(
      "[surface]\nfile = \"box.vtp\"\n[layers]\nfirst_height = 1e-4\ntotal_thickness = { array = \"T\" }\n"
      "[patches.y-max]\ngrowth = 1.3\n",
      "case.toml");
  const auto patches = resolve_patches(c, box, mesh::Topology(box));
  int n_others = 0;
  for (const PatchId p : box.patch_names.ids()) {
    const bool is_other = box.patch_names[p] == "y-max";
    n_others += is_other;
    EXPECT_EQ(patches[p.index()].schedule.heights == patches[0].schedule.heights, !is_other) << box.patch_names[p];
  }
  EXPECT_EQ(n_others, 1);
}

TEST(LengthsOfPatches, AreNumbersOfTheirOwn) {
  const ScratchFolder folder;
  io::write_polydata(folder / "box.vtp", io::polydata_of(shapes::make_shape("box", {}, 0.1)));
  Case c = parse_case(
      "[surface]\nfile = \"box.vtp\"\n[layers]\nfirst_height = 1e-4\ncount = 8\n[patches.x-max]\n"
      "first_height = 2e-4\n[patches.z-max]\ntotal_thickness = 4e-3\n",
      folder / "case.toml");
  c.output.pictures = false;
  const Report r = run(c, RunOptions{folder / "out", false, true});
  const auto sum = [](double growth) { return (std::pow(growth, 8) - 1) / (growth - 1); };
  for (const PatchReport& patch : r.patches) {
    const bool is_higher = patch.name == "x-max", is_thicker = patch.name == "z-max";
    EXPECT_NEAR(patch.coverage.first_height.median, is_higher ? 2e-4 : 1e-4, 1e-9) << patch.name;
    EXPECT_NEAR(patch.coverage.thickness.median, is_thicker ? 4e-3 : (is_higher ? 2e-4 : 1e-4) * sum(1.2), 1e-8);
    EXPECT_EQ(patch.coverage.asked.first_height, is_higher ? 2e-4 : 1e-4);
  }
}

TEST_F(RunWithLengths, SaysWhatTheFileDoesNotHaveAndWhoAsksForIt) {
  const auto running = [&](const std::string& layers) {
    return [=, this] { run_case("[surface]\nfile = \"ball.vtp\"\n[layers]\n" + layers); };
  };
  EXPECT_THAT(
      running("first_height = { array = \"HH\" }\n"),
      ThrowsMessage<InputError>(AllOf(StartsWith((folder_ / "case.toml").string() + ":4:1: layers.first_height: "),
                                      HasSubstr("ball.vtp: no point array \"HH\""), HasSubstr("nearest: \"H\""))));
  EXPECT_THAT(running("first_height = 1e-3\n[patches.\"s*\"]\ngrowth = 1.1\ntotal_thickness = { array = \"TT\" }\n"),
              ThrowsMessage<InputError>(HasSubstr("case.toml:6:1: patches.\"s*\".total_thickness: ")));
}

TEST_F(RunWithLengths, WarnInTheReport) {
  const Report r = run_case("[surface]\nfile = \"ball.vtp\"\n[layers]\nfirst_height = 1\nuntil = \"isotropic\"\n");
  ASSERT_EQ(r.warnings.size(), 1u);
  EXPECT_THAT(r.warnings[0], HasSubstr("the first layer is higher already"));
}

TEST_F(RunWithLengths, UntilIsotropicCountAsFull) {
  const Report r = run_case(
      "[surface]\nfile = \"ball.vtp\"\n[layers]\nfirst_height = { array = \"H\" }\nuntil = "
      "\"isotropic\"\nmin_coverage = 100\n");
  const quality::PatchCoverage& c = r.patches[0].coverage;
  EXPECT_TRUE(r.certified);
  EXPECT_EQ(c.full_percent, 100);
  EXPECT_EQ(c.all_layers_percent, 100);
  EXPECT_FALSE(r.is_short_of_coverage());
  EXPECT_LT(c.mean_layers, c.asked.count) << "first heights differ fivefold, triangles hardly";
  EXPECT_EQ(r.n_cells(), r.forecast.n_cells) << "the forecast knows where lines end";
  EXPECT_EQ(r.points, r.forecast.n_points);
  EXPECT_EQ(r.limited.n_limited(), 0u);
}

TEST_F(RunWithLengths, FollowTheirPointsThroughWeldingAndRepair) {
  // A soup whose triangles have points of their own, one of them twice, and a point that nothing uses in front.
  io::PolyDataFile soup;
  io::DataArray heights{"H", std::vector<double>{1e9}};
  auto& values = std::get<std::vector<double>>(heights.values);
  soup.points.emplace_back(9, 9, 9);
  const auto add = [&](FaceId f) {
    const auto n = static_cast<std::uint32_t>(soup.points.size());
    soup.triangles.push_back({n, n + 1, n + 2});
    for (const VertexId v : surface_.faces[f]) {
      soup.points.push_back(surface_.points[v]);
      values.push_back(surface_.point_arrays[0].values[v]);
    }
  };
  add(FaceId(5));
  for (const FaceId f : surface_.faces.ids()) add(f);
  soup.point_data.push_back(heights);
  io::write_polydata(folder_ / "soup.vtp", soup);
  const std::string rest = "[layers]\nfirst_height = { array = \"H\" }\ncount = 5\n";
  const Report whole = run_case("[surface]\nfile = \"ball.vtp\"\n" + rest);
  const Report mended = run_case("[surface]\nfile = \"soup.vtp\"\nrepair = \"safe\"\n" + rest);
  EXPECT_EQ(mended.surface.points, whole.surface.points);
  EXPECT_EQ(mended.patches[0].coverage.asked_first_height.max, whole.patches[0].coverage.asked_first_height.max);
  EXPECT_EQ(mended.patches[0].coverage.first_height_met_percent, 100);
  EXPECT_NEAR(mended.patches[0].coverage.first_height.mean, whole.patches[0].coverage.first_height.mean, 1e-12);
}

TEST_F(RunWithLengths, ChangeNothingWhereAllAreTheSame) {
  surface_.point_arrays.clear();
  set("H", [](const Vec3&) { return 0.001; });
  write("flat.vtp");
  const std::string rest = "[layers]\ngrowth = 1.25\ncount = 9\n";
  run_case("[surface]\nfile = \"flat.vtp\"\n" + rest + "first_height = 0.001\n");
  const auto read = [&] {
    std::ifstream in(folder_ / "out/flat.vtu", std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string with_number = read();
  run_case("[surface]\nfile = \"flat.vtp\"\n" + rest + "first_height.array = \"H\"\n");
  EXPECT_EQ(with_number, read()) << "bit for bit";
}

}  // namespace
}  // namespace nearwall
