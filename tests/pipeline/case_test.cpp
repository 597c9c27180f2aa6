#include "nearwall/pipeline/case.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "tests/pipeline/scratch_folder.h"

namespace nearwall {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string kLeast = "[surface]\nfile = \"wing.stl\"\n[layers]\nfirst_height = 1e-5\n";

Case parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_case(text, "dir/case.toml", overrides);
}

std::string rejection(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parse(text, overrides);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

std::string patch_rejection(const std::string& text, const std::vector<std::string>& patches) {
  try {
    resolve_patches(parse(text), patches);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

TEST(ReadCase, AnswersAnEmptyFileWithWhatIsMissing) {
  const ScratchFolder folder;
  const auto file = folder.write("empty.toml", "");
  try {
    read_case(file);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("surface.file: missing"));
  }
}

TEST(ReadCase, NeedsOnlyTheSurfaceAndTheHeights) {
  const Case c = parse(kLeast);
  EXPECT_EQ(c.output_name(), "wing");
  EXPECT_EQ(c.surface_path(), "dir/wing.stl");
  EXPECT_EQ(c.output_directory(), "dir/out");
  EXPECT_EQ(c.surface.scale, 1);
  EXPECT_EQ(c.surface.fluid, surface::FluidSide::Outside);
  EXPECT_FALSE(c.surface.weld);
  EXPECT_EQ(c.ridge_angle_deg, 40);
  EXPECT_EQ(c.normals, surface::NormalMethod::MostVisible);
  EXPECT_EQ(c.smoothing.filter, surface::SmoothingFilter::Taubin);
  EXPECT_FALSE(c.smoothing.iterations);
  EXPECT_TRUE(c.output.report);
  EXPECT_TRUE(c.output.pictures);
  EXPECT_EQ(rejection("[layers]\nfirst_height = 1\n"),
            "dir/case.toml: surface.file: missing: the surface to mesh, relative to this file");
  EXPECT_EQ(rejection("[surface]\nfile = \"a.stl\"\n"),
            "dir/case.toml: layers: the heights are missing: give first_height (or y_plus with [flow]) or "
            "total_thickness");
  for (const char* until : {"[layers]\nuntil = \"isotropic\"\n", "[patches.wing]\nuntil = \"isotropic\"\n"}) {
    EXPECT_THAT(rejection(std::string("[surface]\nfile = \"a.stl\"\n") + until),
                EndsWith("the heights are missing: give first_height (or y_plus with [flow]), which until = "
                         "\"isotropic\" needs"));
  }
}

TEST(ReadCase, ReadsEveryKeyOfTheFormat) {
  const Case c = parse(R"(
format = 1
name   = "onera-m6"
[surface]
file   = "onera_m6.stl.gz"
scale  = 1e-3
fluid  = "inside"
weld   = 1e-6
repair = "safe"
[patches."*"]
type = "wall"
[patches.tip]
type = "nolayer"
growth = 1.1
[features]
ridge_angle = 30
[normals]
method = "angle"
multi  = false
multi_angle = 90.0
max_turn = 30.0
[smoothing]
filter = "laplacian"
iterations = 7
[layers]
y_plus = 1.0
growth       = 1.25
count        = 20
law          = "tanh"
on_conflict  = "compress"
max_level_step = 2
min_coverage = 90
[flow]
velocity = 50
kinematic_viscosity = 1.5e-5
reference_length = 1
[volume]
fill = "none"
farfield = { shape = "sphere", radius = "auto", size = "auto" }
growth = 1.3
[output]
directory = "results"
formats = ["vtu"]
report = false
pictures = false
)");
  EXPECT_EQ(c.name, "onera-m6");
  EXPECT_EQ(c.surface.scale, 1e-3);
  EXPECT_EQ(c.surface.fluid, surface::FluidSide::Inside);
  EXPECT_EQ(c.surface.weld, 1e-6);
  EXPECT_EQ(c.surface.repair, surface::Repair::Safe);
  ASSERT_EQ(c.patches.size(), 2u);
  EXPECT_EQ(c.patches[0].pattern, "*");
  EXPECT_EQ(c.patches[1].type, PatchType::NoLayer);
  EXPECT_EQ(c.patches[1].layers.growth, 1.1);
  EXPECT_EQ(c.ridge_angle_deg, 30);
  EXPECT_EQ(c.normals, surface::NormalMethod::Angle);
  EXPECT_FALSE(c.is_multi_allowed);
  EXPECT_EQ(c.multi_angle_deg, 90);
  EXPECT_EQ(c.max_turn_deg, 30);
  EXPECT_EQ(c.smoothing.filter, surface::SmoothingFilter::Laplacian);
  EXPECT_EQ(c.smoothing.iterations, 7);
  EXPECT_EQ(c.layers.y_plus, 1);
  EXPECT_EQ(c.layers.growth, 1.25);
  EXPECT_EQ(c.layers.count, 20);
  EXPECT_EQ(c.layers.law, spacing::Law::Tanh);
  EXPECT_EQ(c.layers.on_conflict, OnConflict::Compress);
  EXPECT_EQ(c.layers.max_level_step, 2);
  EXPECT_EQ(c.layers.min_coverage, 90);
  EXPECT_EQ(c.flow->velocity, 50);
  EXPECT_EQ(c.output.directory, "results");
  EXPECT_FALSE(c.output.report);
  EXPECT_FALSE(c.output.pictures);
}

struct Mistake {
  const char* name;
  std::string text;     ///< a line after kLeast, which has four; it is the fifth
  std::string message;  ///< exact
};

void PrintTo(const Mistake& mistake, std::ostream* os) { *os << mistake.name; }

class CaseMistake : public testing::TestWithParam<Mistake> {};

TEST_P(CaseMistake, IsNamedWithItsPlaceAndWhatIsAllowed) {
  EXPECT_EQ(rejection(kLeast + GetParam().text), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    All, CaseMistake,
    testing::ValuesIn(std::vector<Mistake>{
        {"MistypedKey", "growht = 1.2\n", "dir/case.toml:5:1: layers.growht: unknown key; nearest: growth"},
        {"KeyOfAnotherTable", "scale = 2.0\n", "dir/case.toml:5:1: layers.scale: unknown key; nearest: surface.scale"},
        {"MistypedTable", "[flwo]\nvelocity = 1\n", "dir/case.toml:5:2: flwo: unknown table; nearest: [flow]"},
        {"WrongType", "count = \"many\"\n",
         "dir/case.toml:5:9: layers.count: expected an integer from 1 to 1000 (layers), found \"many\""},
        {"FractionOfALayer", "count = 2.5\n",
         "dir/case.toml:5:9: layers.count: expected an integer from 1 to 1000 (layers), found 2.5"},
        {"WithUnit", "total_thickness = \"3 mm\"\n",
         "dir/case.toml:5:19: layers.total_thickness: expected a number above 0 (length) or { array = \"NAME\" }, "
         "found \"3 mm\"; write a "
         "plain "
         "number without quotes: length in the scaled unit of the surface"},
        {"OutOfRange", "growth = 0.8\n", "dir/case.toml:5:10: layers.growth: expected a number from 1 to 2, found 0.8"},
        {"NotFinite", "total_thickness = inf\n",
         "dir/case.toml:5:19: layers.total_thickness: expected a number above 0 (length) or { array = \"NAME\" }, "
         "found inf"},
        {"Radians", "[features]\nridge_angle = 0.7\n",
         "dir/case.toml:6:15: features.ridge_angle: expected a number from 1 to 179 (degrees), found 0.7"},
        {"MistypedChoice", "law = \"geometrc\"\n",
         "dir/case.toml:5:7: layers.law: expected \"geometric\", \"accelerating\", \"tanh\", \"table\", found "
         "\"geometrc\"; nearest: \"geometric\""},
        {"Conflict", "on_conflict = \"stairs\"\n",
         "dir/case.toml:5:15: layers.on_conflict: expected \"auto\", \"compress\", \"stair\", found \"stairs\"; "
         "nearest: "
         "\"stair\""},
        {"Until", "until = \"isotropy\"\n",
         "dir/case.toml:5:9: layers.until: expected \"count\", \"isotropic\", found \"isotropy\"; nearest: "
         "\"isotropic\""},
        {"UntilAndThickness", "until = \"isotropic\"\ntotal_thickness = 0.1\n",
         "dir/case.toml:4:1: layers: until = \"isotropic\" and total_thickness exclude each other: the layers are as "
         "thick as their triangles make them; leave out one (count = … bounds their number)"},
        {"UntilAndTanh", "until = \"isotropic\"\nlaw = \"tanh\"\n",
         "dir/case.toml:4:1: layers: until = \"isotropic\" cannot be had with the law \"tanh\", whose heights depend "
         "on "
         "the count; take \"geometric\" or \"accelerating\""},
        {"ArrayWithoutName", "total_thickness = { factor = 2 }\n",
         "dir/case.toml:5:1: layers.total_thickness.array: missing: the name of a point array of the surface file"},
        {"EmptyArrayTable", "total_thickness = {}\n",
         "dir/case.toml:5:1: layers.total_thickness.array: missing: the name of a point array of the surface file"},
        {"ArrayThatIsNoName", "total_thickness = { array = 3 }\n",
         "dir/case.toml:5:29: layers.total_thickness.array: expected the name of a point array of the surface file in "
         "quotes, found 3"},
        {"FactorOfNothing", "total_thickness = { array = \"T\", factor = 0 }\n",
         "dir/case.toml:5:43: layers.total_thickness.factor: expected a number above 0, found 0"},
        {"UnknownPartOfALength", "[patches.wing]\ntotal_thickness = { array = \"T\", fcator = 2 }\n",
         "dir/case.toml:6:34: patches.wing.total_thickness.fcator: unknown key; a length from an array takes array, "
         "factor"},
        {"ArrayWhereNoneIs", "[layers.growth]\narray = \"G\"\n",
         "dir/case.toml:5:1: layers.growth: expected a number from 1 to 2, found a table"},
        {"FourQuantitiesWithAnArray", "growth = 1.2\ncount = 3\ntotal_thickness = { array = \"T\" }\n",
         "dir/case.toml:4:1: layers: any three of first_height, growth, count and total_thickness determine the "
         "fourth; "
         "leave out one"},
        {"MistypedLengthFromAnArray", "totl_thickness = { array = \"T\" }\n",
         "dir/case.toml:5:1: layers.totl_thickness: unknown key; nearest: total_thickness"},
        {"MistypedLengthOfAPatch", "[patches.\"w*\".totl_thickness]\narray = \"T\"\n",
         "dir/case.toml:5:15: patches.\"w*\".totl_thickness: unknown key; nearest: total_thickness"},
        {"MistypedFarField", "[volume]\nfarfeld.radius = 3\n",
         "dir/case.toml:6:1: volume.farfeld: unknown table; nearest: [volume.farfield]"},
        {"UnknownTable", "[turbulence]\nx = 1\n",
         "dir/case.toml:5:2: turbulence: unknown table; tables are surface, patches, features, normals, smoothing, "
         "layers, flow, volume, volume.farfield, output"},
        {"LevelStep", "max_level_step = 0\n",
         "dir/case.toml:5:18: layers.max_level_step: expected an integer from 1 to 1000 (layers) or \"auto\", found 0"},
        {"Fill", "[volume]\nfill = \"tetgne\"\n",
         "dir/case.toml:6:8: volume.fill: expected \"none\", \"tetgen\", found \"tetgne\"; nearest: \"tetgen\""},
        {"VolumeGrowth", "[volume]\ngrowth = 1\n",
         "dir/case.toml:6:10: volume.growth: expected a number above 1, at most 3, found 1"},
        {"FarFieldRadius", "[volume.farfield]\nradius = 0\n",
         "dir/case.toml:6:10: volume.farfield.radius: expected a number above 0 (length) or \"auto\", found 0"},
        {"KeyOfTheFarField", "[volume]\nfarfield = { shape = \"box\", radus = 3 }\n",
         "dir/case.toml:6:29: volume.farfield.radus: unknown key; nearest: radius"},
        {"FarFieldThatIsNoTable", "[volume]\nfarfield = \"box\"\n",
         "dir/case.toml:6:12: volume.farfield: expected a table, found \"box\""},
        {"CentreInThePlane", "[volume.farfield]\ncentre = [1, 2]\n",
         "dir/case.toml:6:10: volume.farfield.centre: expected a list [x, y, z] of numbers (length) or \"auto\", found "
         "[1, 2]"},
        {"CornersOfASphere", "[volume.farfield]\nlower = [0, 0, 0]\nupper = [1, 1, 1]\n",
         "dir/case.toml:6:1: volume.farfield.lower: for shape = \"box\" alone; a sphere has radius and centre"},
        {"OneCorner", "[volume.farfield]\nshape = \"box\"\nupper = [1, 1, 1]\n",
         "dir/case.toml:7:1: volume.farfield.upper: lower is missing: a box needs both corners, or radius"},
        {"CornersInTheWrongOrder", "[volume.farfield]\nshape = \"box\"\nupper = [1, 1, 1]\nlower = [0, 1, 0]\n",
         "dir/case.toml:8:1: volume.farfield.lower: expected less than upper along every axis, found y = 1 to 1"},
        {"CornersAndRadius", "[volume.farfield]\nshape = \"box\"\nupper = [1, 1, 1]\nlower = [0, 0, 0]\nradius = 3\n",
         "dir/case.toml:9:1: volume.farfield.radius: lower and upper determine the box; leave one or the other out"},
        {"GivenOutside", "[volume.farfield]\nshape = \"given\"\n",
         "dir/case.toml:6:1: volume.farfield.shape: \"given\" needs fluid = \"inside\" in [surface]: the outer "
         "boundary "
         "is a part of the surface, and the fluid lies inside of that"},
        {"PlaneAcrossNothing", "[volume]\nsymmetry = [\"x\", \"w\"]\n",
         "dir/case.toml:6:18: volume.symmetry: expected \"x\", \"y\", \"z\", found \"w\""},
        {"PlaneByNumber", "[volume]\nsymmetry = [1]\n",
         "dir/case.toml:6:13: volume.symmetry: expected a list of \"x\", \"y\", \"z\" or { axis = \"y\", at = 0.0 }, "
         "found 1"},
        {"PlaneThatIsNoList", "[volume]\nsymmetry = 1\n",
         "dir/case.toml:6:12: volume.symmetry: expected a list of \"x\", \"y\", \"z\" or { axis = \"y\", at = 0.0 }, "
         "found 1"},
        {"KeyOfAPlane", "[volume]\nsymmetry = [{ axsi = \"y\" }]\n",
         "dir/case.toml:6:15: volume.symmetry.axsi: unknown key; nearest: axis"},
        {"PlaneWithoutAxis", "[volume]\nsymmetry = [\"x\", { at = 0 }]\n",
         "dir/case.toml:6:18: volume.symmetry.axis: missing: \"x\", \"y\" or \"z\", the axis that the plane is "
         "across"},
        {"PlaneAtNoNumber", "[volume]\nsymmetry = [{ axis = \"y\", at = \"0\" }]\n",
         "dir/case.toml:6:32: volume.symmetry.at: expected a number (length), found \"0\"; write a plain number "
         "without "
         "quotes: length in the scaled unit of the surface"},
        {"PlaneTwice", "[volume]\nsymmetry = [\"y\", { axis = \"y\", at = 1 }]\n",
         "dir/case.toml:6:1: volume.symmetry: two planes across \"y\" need an `at` each, and not the same one"},
        {"PatchType", "[patches.mid]\ntype = \"symetry\"\n",
         "dir/case.toml:6:8: patches.mid.type: expected \"wall\", \"nolayer\", \"symmetry\", \"inlet\", \"outlet\", "
         "\"farfield\", found \"symetry\"; nearest: \"symmetry\""},
        {"MultiAngle", "[normals]\nmulti_angle = 190\n",
         "dir/case.toml:6:15: normals.multi_angle: expected a number from 1 to 179 (degrees), found 190"},
        {"MaxTurn", "[normals]\nmax_turn = 0\n",
         "dir/case.toml:6:12: normals.max_turn: expected a number from 5 to 90 (degrees), found 0"},
        {"Format", "[output]\nformats = [\"vtu\", \"cgs\"]\n",
         "dir/case.toml:6:11: output.formats: expected a list of \"vtu\", \"vtkhdf\", \"cgns\", \"su2\", \"ugrid\", "
         "\"b8.ugrid\", \"lb8.ugrid\", \"msh\", \"msh2\", \"openfoam\", \"openfoam-ascii\", found [\"vtu\", \"cgs\"]; "
         "nearest: "
         "\"cgns\""},
        {"NoFormat", "[output]\nformats = []\n",
         "dir/case.toml:6:11: output.formats: expected a list of \"vtu\", \"vtkhdf\", \"cgns\", \"su2\", \"ugrid\", "
         "\"b8.ugrid\", \"lb8.ugrid\", \"msh\", \"msh2\", \"openfoam\", \"openfoam-ascii\", found []"},
        {"Boolean", "[output]\nreport = 1\n", "dir/case.toml:6:10: output.report: expected true or false, found 1"},
        {"Date", "[output]\ndirectory = 2024-01-01\n",
         "dir/case.toml:6:13: output.directory: expected a text in quotes, found 2024-01-01"},
        {"EmptyText", "[output]\ndirectory = \"\"\n",
         "dir/case.toml:6:13: output.directory: expected a text in quotes, found \"\", which is empty"},
        {"ValueForATable", "[output.report]\nx = 1\n",
         "dir/case.toml:5:1: output.report: expected true or false, found a table"},
        {"UnknownKeyOfPatch", "[patches.wing]\nkind = \"wall\"\n",
         "dir/case.toml:6:1: patches.wing.kind: unknown key; keys of [patches] are type, first_height, y_plus, growth, "
         "count, total_thickness, until, law, heights, constant_layers, acceleration, largest_growth, on_conflict, "
         "max_level_step, min_coverage"},
        {"TooManyQuantities", "growth = 1.2\ncount = 3\ntotal_thickness = 1.0\n",
         "dir/case.toml:4:1: layers: any three of first_height, growth, count and total_thickness determine "
         "the "
         "fourth; leave out one"},
        {"BothHeights", "y_plus = 1.0\n",
         "dir/case.toml:4:1: layers: first_height and y_plus exclude each other; leave out one"},
    }),
    [](const auto& parameter) { return std::string(parameter.param.name); });

TEST(ReadCase, NamesThePlaceOfWhatIsNoToml) {
  EXPECT_THAT(rejection("[surface]\nfile = wing.stl\n"), StartsWith("dir/case.toml:2:"));
  EXPECT_THAT(rejection("[surface]\nfile = \"a.stl\"\nfile = \"b.stl\"\n"), StartsWith("dir/case.toml:3:"));
}

TEST(ReadCase, NamesStrayCharactersOutsideOfQuotes) {
  EXPECT_EQ(rejection("# m² \"\nname = 'é' # '\nscale = 1 m²\n"),
            "dir/case.toml:3:12: unexpected character; what is not ASCII belongs in quotes or comments");
  EXPECT_THAT(rejection("a = \"\"\"\n\\\"² \"\"\"\n²"), StartsWith("dir/case.toml:3:1: unexpected character"));
  EXPECT_THAT(rejection("\n[= 3\n"), StartsWith("dir/case.toml:2:2: "));
}

TEST(ReadCase, QuotesLongTextsInPart) {
  std::string a(59, 'a');
  EXPECT_THAT(rejection(kLeast + "law = \"" + a + "ü and more\"\n"), HasSubstr("found \"" + a + "…\""));
}

TEST(ReadCase, WantsAFlowForYPlus) {
  EXPECT_EQ(rejection("[surface]\nfile = \"a.stl\"\n[layers]\ny_plus = 1.0\n[flow]\nvelocity = 1.0\n"),
            "dir/case.toml:4:1: layers: y_plus needs [flow] with velocity, kinematic_viscosity and reference_length; "
            "missing: kinematic_viscosity, reference_length");
}

TEST(ReadCase, SaysThatThereIsNoFile) {
  try {
    read_case("/nowhere/case.toml");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "/nowhere/case.toml: no such case file");
  }
}

TEST(ReadCase, FillsNothingByDefault) {
  EXPECT_EQ(parse(kLeast).volume, VolumeSettings());
  EXPECT_EQ(parse(case_template({})).volume, VolumeSettings());
}

TEST(ReadCase, ReadsAVolume) {
  const VolumeSettings v = parse(kLeast + R"(
[volume]
fill = "tetgen"
farfield = { shape = "box", lower = [-1, -2, -3], upper = [4, 5.5, 6], size = 0.5 }
growth = 1.5
symmetry = ["x", { axis = "z", at = -1 }]
)")
                               .volume;
  EXPECT_EQ(v.fill, Fill::TetGen);
  EXPECT_EQ(v.growth, 1.5);
  EXPECT_EQ(v.far_field.shape, FarFieldShape::Box);
  EXPECT_EQ(v.far_field.lower, Vec3(-1, -2, -3));
  EXPECT_EQ(v.far_field.upper, Vec3(4, 5.5, 6));
  EXPECT_EQ(v.far_field.size, 0.5);
  EXPECT_FALSE(v.far_field.radius);
  EXPECT_EQ(v.symmetry, (std::vector<SymmetrySetting>{{0, std::nullopt}, {2, -1.0}}));
}

TEST(ReadCase, ReadsAPlaneInEveryForm) {
  const auto planes = [](const std::string& value) { return parse(kLeast + "[volume]\n" + value).volume.symmetry; };
  const std::vector<SymmetrySetting> expected = {{1, std::nullopt}};
  EXPECT_EQ(planes("symmetry = \"y\"\n"), expected);
  EXPECT_EQ(planes("symmetry = [\"y\"]\n"), expected);
  EXPECT_EQ(planes("symmetry = [{ axis = \"y\" }]\n"), expected);
  EXPECT_EQ(planes("[[volume.symmetry]]\naxis = \"y\"\n"), expected);
  EXPECT_TRUE(planes("symmetry = []\n").empty());
  EXPECT_EQ(planes("symmetry = [{ axis = \"y\", at = 0 }, { axis = \"y\", at = 2 }]\n").size(), 2u);
}

TEST(ReadCase, TakesAFarFieldOfTheSurfaceWhereOneIs) {
  const std::string inside = "[surface]\nfile = \"a.stl\"\nfluid = \"inside\"\n[layers]\nfirst_height = 1\n";
  const std::string given = inside + "[volume.farfield]\nshape = \"given\"\n";
  EXPECT_EQ(rejection(given),
            "dir/case.toml:7:1: volume.farfield.shape: \"given\" needs the patch of the surface that is the outer "
            "boundary: [patches.NAME] with type = \"farfield\"");
  EXPECT_EQ(parse(given + "[patches.far]\ntype = \"farfield\"\n").volume.far_field.shape, FarFieldShape::Given);
  EXPECT_EQ(
      rejection(inside + "[volume]\nfarfield = { size = 3 }\n"),
      "dir/case.toml:7:14: volume.farfield.size: no far field is made where the fluid lies inside of the surface, "
      "which is the outer boundary then; leave it out");
}

TEST(PatchType, GivesLayersToWallsAlone) {
  std::string text = kLeast;
  std::vector<std::string> names;
  for (const char* type : {"wall", "nolayer", "symmetry", "inlet", "outlet", "farfield"}) {
    names.emplace_back(type);
    text += "[patches." + names.back() + "]\ntype = \"" + type + "\"\ngrowth = 1.1\n";
  }
  const auto patches = resolve_patches(parse(text), names);
  for (std::size_t p = 0; p < names.size(); ++p) {
    EXPECT_EQ(type_name(patches[p].type), names[p]);
    EXPECT_EQ(has_layers(patches[p].type), p == 0);
    EXPECT_EQ(is_side(patches[p].type), p > 1);
    EXPECT_EQ(patches[p].schedule.heights.empty(), p != 0);
  }
}

TEST(Overrides, ReachIntoTheVolume) {
  const auto volume = [](const std::vector<std::string>& overrides) {
    return parse(kLeast + "[volume]\nfarfield = { radius = 3, size = 1 }\nsymmetry = \"x\"\n", overrides).volume;
  };
  EXPECT_EQ(volume({"volume.fill=tetgen"}).fill, Fill::TetGen);
  EXPECT_EQ(volume({"volume.farfield.radius=30"}).far_field.radius, 30);
  EXPECT_EQ(volume({"volume.farfield.radius=30"}).far_field.size, 1);
  EXPECT_EQ(volume({"volume.symmetry=z"}).symmetry, (std::vector<SymmetrySetting>{{2, std::nullopt}}));
  EXPECT_EQ(volume({"volume.symmetry=[{axis=\"z\", at=1}]"}).symmetry, (std::vector<SymmetrySetting>{{2, 1.0}}));
}

TEST(Overrides, TakeWholeTables) {
  const std::string text = kLeast + "[volume]\nfarfield = { radius = 3, size = 1 }\n";
  const FarFieldSettings far = parse(text, {"volume.farfield={shape=\"box\", radius=4}"}).volume.far_field;
  EXPECT_EQ(far.shape, FarFieldShape::Box);
  EXPECT_EQ(far.radius, 4);
  EXPECT_FALSE(far.size) << "a table replaces the one of the file";
  const LayerSettings layers = parse(text, {"layers.first_height={ array=\"H\", factor=2 }"}).layers;
  EXPECT_EQ(layers.first_height_array, (ArrayLength{"H", 2}));
  EXPECT_FALSE(layers.first_height);
  EXPECT_EQ(rejection(text, {"volume.farfield={radus=4}"}),
            "--set volume.farfield={radus=4}: volume.farfield.radus: unknown key; nearest: radius");
  EXPECT_EQ(rejection(text, {"layers=3"}), "--set layers=3: layers: expected a table, found 3");
}

TEST(Overrides, ReplaceValuesAndAddNewOnes) {
  const Case c = parse(kLeast, {"layers.first_height=2e-5", "layers.count=12", "surface.file=other.ply",
                                "patches.\"wing.tip\".type=\"nolayer\"", "output.formats=[\"vtu\"]"});
  EXPECT_EQ(c.layers.first_height, 2e-5);
  EXPECT_EQ(c.layers.count, 12);
  EXPECT_EQ(c.surface.file, "other.ply");
  ASSERT_EQ(c.patches.size(), 1u);
  EXPECT_EQ(c.patches[0].pattern, "wing.tip");
}

TEST(Overrides, AreNamedWhenWrong) {
  EXPECT_EQ(rejection(kLeast, {"layers.cuont=12"}), "--set layers.cuont=12: layers.cuont: unknown key; nearest: count");
  EXPECT_THAT(rejection(kLeast, {"layers.count=0"}),
              StartsWith("--set layers.count=0: layers.count: expected an integer"));
  EXPECT_THAT(rejection(kLeast, {"count"}), HasSubstr("expected KEY=VALUE"));
  EXPECT_EQ(rejection(kLeast, {"layers.frist_height.array=H"}),
            "--set layers.frist_height.array=H: layers.frist_height: unknown key; nearest: first_height");
  EXPECT_EQ(rejection(kLeast, {"layers.growth.array=G"}),
            "--set layers.growth.array=G: layers.growth: expected a number from 1 to 2, found a table");
  EXPECT_EQ(rejection(kLeast, {"patches.wing.frist_height={array=\"H\"}"}),
            "--set patches.wing.frist_height={array=\"H\"}: patches.wing.frist_height: unknown key; nearest: "
            "first_height");
}

TEST(ResolvePatches, TakesFromLayersWhatThePatchDoesNotGive) {
  const Case c = parse(
      "[surface]\nfile = \"a.stl\"\n[layers]\nfirst_height = 1e-3\ngrowth = 1.5\ncount = 4\n"
      "[patches.\"w*\"]\ncount = 6\n[patches.wing]\ngrowth = 1.0\n[patches.tip]\ntype = \"nolayer\"\n");
  const std::vector<std::string> names = {"wing", "winglet", "tip", "body"};
  const auto p = resolve_patches(c, names);
  ASSERT_EQ(p.size(), 4u);
  EXPECT_EQ(p[0].schedule.count, 6);
  EXPECT_EQ(p[0].schedule.growth, 1);
  EXPECT_EQ(p[1].schedule.count, 6);
  EXPECT_EQ(p[1].schedule.growth, 1.5);
  EXPECT_EQ(p[2].type, PatchType::NoLayer);
  EXPECT_EQ(p[3].schedule.count, 4);
}

TEST(ResolvePatches, LetsAnInheritedQuantityGiveWay) {
  const std::string text =
      "[surface]\nfile = \"a.stl\"\n[layers]\nfirst_height = 1e-3\ngrowth = 1.5\ncount = 4\n[patches.a]\n";
  const std::vector<std::string> names = {"a"};
  const auto schedule = [&](const std::string& keys) { return resolve_patches(parse(text + keys), names)[0].schedule; };
  const auto growth_gave_way = schedule("total_thickness = 4e-3\n");
  EXPECT_EQ(growth_gave_way.growth, 1);
  EXPECT_EQ(growth_gave_way.count, 4);
  const auto count_gave_way = schedule("total_thickness = 4.75e-3\ngrowth = 1.5\n");
  EXPECT_EQ(count_gave_way.count, 3);
  EXPECT_EQ(schedule("heights = [1e-3, 3e-3]\n").heights, (std::vector<double>{1e-3, 3e-3}));
}

TEST(ResolvePatches, RejectsANameThatNoPatchHas) {
  EXPECT_EQ(patch_rejection(kLeast + "[patches.wnig]\ntype = \"nolayer\"\n", {"wing", "body"}),
            "dir/case.toml:5:10: patches.wnig: no patch of the surface has this name; nearest: \"wing\"");
  EXPECT_EQ(
      patch_rejection(kLeast + "[patches.\"q*\"]\ntype = \"nolayer\"\n", {"wing", "body"}),
      "dir/case.toml:5:10: patches.\"q*\": no patch of the surface has this name; its patches are \"wing\", \"body\"");
}

TEST(ResolvePatches, NamesThePatchOfAnImpossibleSchedule) {
  EXPECT_THAT(patch_rejection(kLeast + "count = 10\n[patches.wing]\ntotal_thickness = 1e-6\n", {"wing"}),
              StartsWith("dir/case.toml:7:1: layers of patch \"wing\": 10 layers from first_height = 1e-05"));
}

TEST(CaseTemplate, ParsesToTheDefaults) {
  const Case c = parse(case_template({}));
  const Case d = parse("[surface]\nfile = \"surface.stl\"\n[layers]\nfirst_height = 1e-5\ngrowth = 1.2\ncount = 30\n");
  EXPECT_EQ(c.surface.file, d.surface.file);
  EXPECT_EQ(c.surface.scale, d.surface.scale);
  EXPECT_EQ(c.surface.weld, d.surface.weld);
  EXPECT_EQ(c.ridge_angle_deg, d.ridge_angle_deg);
  EXPECT_EQ(c.is_multi_allowed, d.is_multi_allowed);
  EXPECT_EQ(c.multi_angle_deg, d.multi_angle_deg);
  EXPECT_EQ(c.max_turn_deg, d.max_turn_deg);
  EXPECT_EQ(c.smoothing.iterations, d.smoothing.iterations);
  EXPECT_EQ(c.layers.first_height, d.layers.first_height);
  EXPECT_EQ(c.layers.growth, d.layers.growth);
  EXPECT_EQ(c.layers.count, d.layers.count);
  EXPECT_EQ(c.layers.law_in_force(), d.layers.law_in_force());
  EXPECT_EQ(c.layers.min_coverage.value_or(-1), 0);
  EXPECT_EQ(c.flow.has_value(), d.flow.has_value());
  EXPECT_EQ(c.output.directory, d.output.directory);
  EXPECT_EQ(c.output_name(), d.output_name());
}

TEST(CaseTemplate, ProposesHeightsThatSuitTheSurface) {
  SurfaceFacts facts;
  facts.file = "big \"wing\".stl";
  facts.box.include(Vec3(0, 0, 0));
  facts.box.include(Vec3(300, 400, 0));
  facts.mean_edge = 20;
  facts.patch_names = {"upper", "lower"};
  const std::string text = case_template(facts);
  const Case c = parse(text);
  EXPECT_EQ(c.surface.file, facts.file);
  EXPECT_NEAR(*c.layers.first_height, 0.005, 1e-15);
  const std::vector<std::string> names = {"upper", "lower"};
  EXPECT_NEAR(resolve_patches(c, names)[0].schedule.total_thickness, 5, 1);
  EXPECT_THAT(text, HasSubstr("# [patches.\"upper\"]"));
  EXPECT_THAT(text, HasSubstr("diagonal 500"));
}

TEST(CaseTemplate, ListsThePointArraysOfTheSurface) {
  SurfaceFacts facts;
  facts.file = "wing.vtp";
  EXPECT_THAT(case_template(facts), Not(HasSubstr("array = ")));
  facts.point_arrays = {"FirstHeight", "a \"b\""};
  const std::string text = case_template(facts);
  EXPECT_THAT(text, HasSubstr("# first_height = { array = \"NAME\" } # or one of the surface's point arrays:\n"
                              "#   \"FirstHeight\"\n#   \"a \\\"b\\\"\"\n"));
  EXPECT_EQ(parse(text).layers.first_height_array, std::nullopt) << "a comment";
  facts.point_arrays.assign(50, "A");
  EXPECT_THAT(case_template(facts), HasSubstr("#   … and 30 more\n"));
}

TEST(CaseReference, IsWhatThePageSays) {
  std::ifstream page(std::string(NEARWALL_SOURCE_DIR) + "/docs/case-file.md");
  ASSERT_TRUE(page) << "docs/case-file.md is missing";
  std::ostringstream text;
  text << page.rdbuf();
  EXPECT_THAT(text.str(), HasSubstr(case_reference())) << "docs/case-file.md does not hold this text any more:\n"
                                                       << case_reference();
}

}  // namespace
}  // namespace nearwall
