#include "nearwall/pipeline/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/pipeline/scratch_folder.h"

namespace nearwall {
namespace {

using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

Report sample() {
  Report r;
  r.name = "wing <2>";
  r.version = "1.2.3";
  r.certified = true;
  r.cells = {1, 2, 3, 4};
  r.input_file = "wing.stl";
  r.input_sha256 = "abc";
  r.settings = parse_case(
      "[surface]\nfile = \"wing.stl\"\n[layers]\nfirst_height = 1e-5\n[patches.tip]\ntype = "
      "\"nolayer\"\n[patches.\"w*\"]\ncount = 7\n",
      "case.toml");
  PatchReport wing{"wing", PatchType::Wall, 50, {}};
  wing.coverage.area = 2;
  wing.coverage.full_percent = 90;
  wing.coverage.all_layers_percent = 95;
  wing.coverage.any_percent = 100;
  wing.coverage.limit_percent[3] = 7.5;
  wing.coverage.limit_percent[1] = 2.5;
  wing.coverage.asked = {true, 1e-5, 0.01, 30};
  wing.coverage.first_height = quality::weighted_statistics(std::vector<double>{1e-5, 2e-5}, std::vector<double>{1, 1});
  r.patches = {wing, {"tip", PatchType::NoLayer, 0, {}}};
  r.quality.scaled_jacobian = quality::weighted_statistics(std::vector<double>{0.1, 0.9}, std::vector<double>{1, 3});
  r.stages = {{"reading", 0.5}, {"layers", 1.5}};
  r.files = {"wing.vtu", "report.json"};
  return r;
}

TEST(ReportJson, HasTheKeysThatOthersRelyOn) {
  const Json j = Json::parse(to_json(sample()));
  EXPECT_EQ(j["certified"], true);
  EXPECT_EQ(j["cells"], Json({{"tetrahedron", 1}, {"pyramid", 2}, {"wedge", 3}, {"hexahedron", 4}}));
  const Json& wing = j["patches"]["wing"];
  EXPECT_EQ(wing["area"], 2);
  EXPECT_EQ(wing["full_percent"], 90);
  EXPECT_EQ(wing["all_layers_percent"], 95);
  EXPECT_EQ(wing["any_percent"], 100);
  EXPECT_TRUE(wing.contains("mean_layers"));
  EXPECT_EQ(wing["first_height"]["asked"], 1e-5);
  for (const char* key : {"median", "p01", "p99"}) EXPECT_TRUE(wing["first_height"].contains(key));
  for (const char* key : {"within_5_percent", "over_1_5_times"}) EXPECT_TRUE(wing["first_height"].contains(key));
  for (const char* key : {"asked", "median", "p01"}) EXPECT_TRUE(wing["thickness"].contains(key));
  EXPECT_EQ(wing["limits"], Json({{"gap", 7.5}, {"visibility", 2.5}}));
  EXPECT_EQ(j["patches"]["tip"]["type"], "nolayer");
  for (const char* key : {"min", "p01", "median", "p99", "max"}) {
    EXPECT_TRUE(j["quality"]["scaled_jacobian"].contains(key)) << key;
  }
  EXPECT_TRUE(j["quality"].contains("orthogonality"));
  EXPECT_TRUE(j["quality"].contains("growth"));
  for (const char* key : {"cells", "domain", "closure"}) EXPECT_TRUE(j["volume"].contains(key)) << key;
  EXPECT_EQ(j["stages"][1], Json({{"name", "layers"}, {"seconds", 1.5}}));
  EXPECT_TRUE(j.contains("peak_memory_bytes"));
  EXPECT_EQ(j["input"], Json({{"file", "wing.stl"}, {"sha256", "abc"}}));
  EXPECT_EQ(j["version"], "1.2.3");
}

TEST(ReportJson, TellsWhereLinesAreLimited) {
  Report r = sample();
  EXPECT_EQ(Json::parse(to_json(r))["limited_lines"]["reasons"], Json::object());
  r.limited.n_lines = 50;
  quality::ReasonLines& gap = r.limited.by_reason[static_cast<std::size_t>(mesh::LimitReason::Gap)];
  gap = {7, 2, {{VertexId(3), PatchId(0), {1, 2, 3}, 2, 4, 0.25, 0.5}}};
  r.patches[0].limited_lines[static_cast<std::size_t>(mesh::LimitReason::Gap)] = 7;
  const Json j = Json::parse(to_json(r));
  EXPECT_EQ(j["limited_lines"], Json::parse(R"({"asked": 50, "limited": 7, "at_wall": 2, "reasons": {"gap": {
      "lines": 7, "at_wall": 2, "worst": [{"where": [1, 2, 3], "patch": "wing", "vertex": 3, "lines": 2, "levels": 4,
      "thickness": 0.25, "asked": 0.5}]}}})"));
  EXPECT_EQ(j["patches"]["wing"]["limited_lines"], Json({{"gap", 7}}));
}

TEST(ReportJson, EchoesEveryValueInForce) {
  const Json c = Json::parse(to_json(sample()))["case"];
  EXPECT_EQ(c["format"], 1);
  EXPECT_EQ(c["name"], "wing");
  EXPECT_EQ(c["surface"]["scale"], 1.0);
  EXPECT_EQ(c["surface"]["weld"], "auto");
  EXPECT_EQ(c["features"]["ridge_angle"], 40.0);
  EXPECT_EQ(c["layers"]["first_height"], 1e-5);
  EXPECT_EQ(c["layers"]["law"], "geometric");
  EXPECT_EQ(c["patches"]["tip"], Json({{"type", "nolayer"}}));
  EXPECT_EQ(c["patches"]["w*"], Json({{"count", 7}}));
  EXPECT_EQ(c["output"]["formats"], Json({"vtu"}));
  EXPECT_EQ(c["volume"], Json::parse(R"({"fill": "none", "growth": 1.3, "symmetry": [],
      "farfield": {"shape": "sphere", "radius": "auto", "size": "auto", "centre": "auto"}})"));
}

TEST(ReportJson, EchoesAVolume) {
  Report r = sample();
  r.settings.volume.far_field.shape = FarFieldShape::Box;
  r.settings.volume.far_field.upper = Vec3(3, 4, 5);
  r.settings.volume.symmetry = {{1, 0.5}, {2, std::nullopt}};
  r.patches[1].type = PatchType::Symmetry;
  const Json j = Json::parse(to_json(r));
  EXPECT_EQ(j["case"]["volume"]["farfield"]["upper"], Json::parse("[3.0, 4.0, 5.0]"));
  EXPECT_EQ(j["case"]["volume"]["symmetry"], Json::parse(R"([{"axis": "y", "at": 0.5}, {"axis": "z"}])"));
  EXPECT_EQ(j["patches"]["tip"]["type"], "symmetry");
}

TEST(ReportJson, WritesNumbersThatReadBackToTheSameBits) {
  Report r = sample();
  r.patches[0].coverage.area = 0.1 + 0.2;
  EXPECT_THAT(to_json(r), HasSubstr("0.30000000000000004"));
  r.patches[0].coverage.area = 1e-5;
  EXPECT_EQ(Json::parse(to_json(r))["patches"]["wing"]["area"].get<double>(), 1e-5);
}

TEST(ReportJson, SurvivesNamesThatAreNoText) {
  Report r = sample();
  r.patches[0].name = "\xff\xfe";
  EXPECT_NO_THROW(to_json(r));
  EXPECT_NO_THROW(to_html(r, "."));
}

TEST(ReasonsInWords, NameTheLargestFirst) {
  quality::PatchCoverage c;
  EXPECT_EQ(reasons_in_words(c, 3), "");
  c.limit_percent[static_cast<std::size_t>(mesh::LimitReason::Curvature)] = 0.4;
  c.limit_percent[static_cast<std::size_t>(mesh::LimitReason::Gap)] = 3.14;
  c.limit_percent[static_cast<std::size_t>(mesh::LimitReason::Quality)] = 0.01;
  EXPECT_EQ(reasons_in_words(c, 3), "gap 3.1, curvature 0.4");
  EXPECT_EQ(reasons_in_words(c, 1), "gap 3.1, …");
}

TEST(PercentInWords, NeverRoundsToAll) {
  EXPECT_EQ(percent_in_words(100), "100.0");
  EXPECT_EQ(percent_in_words(99.999), "99.9");
  EXPECT_EQ(percent_in_words(99.94), "99.9");
  EXPECT_EQ(percent_in_words(0), "0.0");
}

TEST(Report, IsShortWhereAPatchIsUnderItsMinimum) {
  Report r = sample();
  EXPECT_FALSE(r.is_short_of_coverage());
  r.patches[0].min_coverage = 95.5;
  EXPECT_TRUE(r.is_short_of_coverage());
  r.patches[0].type = PatchType::NoLayer;
  EXPECT_FALSE(r.is_short_of_coverage());
}

TEST(ReportHtml, NeedsNothingElse) {
  const ScratchFolder folder;
  folder.write("a.png", "\x89PNG!");
  Report r = sample();
  r.pictures = {{"a.png", "A picture"}, {"gone.png", "A picture that is gone"}};
  const std::string html = to_html(r, folder.path());
  EXPECT_THAT(html, HasSubstr("data:image/png;base64,iVBORyE="));
  for (const char* outside : {"http:", "https:", "<link", "<script", "src='a", "url(", "gone"}) {
    EXPECT_THAT(html, Not(HasSubstr(outside)));
  }
}

TEST(ReportHtml, TellsTheVerdictAndEscapesNames) {
  Report r = sample();
  const std::string html = to_html(r, ".");
  EXPECT_THAT(html, HasSubstr("wing &lt;2&gt;"));
  EXPECT_THAT(html, Not(HasSubstr("wing <2>")));
  EXPECT_THAT(html, HasSubstr("✓ certified"));
  r.certified = false;
  EXPECT_THAT(to_html(r, "."), HasSubstr("not certified"));
  r.patches[0].min_coverage = 99;
  EXPECT_THAT(to_html(r, "."), HasSubstr("coverage under min_coverage"));
}

}  // namespace
}  // namespace nearwall
