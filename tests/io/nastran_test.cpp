#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/volume_formats.h"
#include "tests/io/solver_files.h"

namespace nearwall::io {
namespace {

using namespace volume_meshes_for_tests;
using testing::ElementsAre;
using testing::HasSubstr;

enum class Form { Small, Large, Free, Tabs };

/// A card in one of the forms, on as many lines as it takes.
std::string card(Form form, const std::string& name, const std::vector<std::string>& fields) {
  const bool is_large = form == Form::Large;
  const std::size_t n_per_line = is_large ? 4 : 8;
  std::string text;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i % n_per_line == 0) {
      const std::string head = (i == 0               ? name
                                : form == Form::Free ? "+"
                                : is_large           ? ""
                                                     : "+C") +
                               (is_large ? "*" : "");
      text += i == 0 ? "" : "\n";
      text += form == Form::Small || is_large ? fmt::format("{:<8}", head) : head;
    }
    text += form == Form::Free    ? ", " + fields[i]
            : form == Form::Tabs  ? "\t" + fields[i]
            : form == Form::Large ? fmt::format("{:<16}", fields[i])
                                  : fmt::format("{:>8}", fields[i]);
  }
  return text + "\n";
}

std::string name_of(CellType type) {
  return std::vector<std::string>{"CTETRA", "CPYRAM", "CPENTA", "CHEXA"}[static_cast<std::size_t>(type)];
}

VolumeMesh cells_of_all_types() {
  const auto moved = [](VolumeMesh mesh, double x) {
    return mapped(std::move(mesh), [x](const Vec3& p) { return p * 0.5 + Vec3(x, 0, 0); });
  };
  return joined(joined(moved(block(1, as_hexahedron()), 0), moved(block(1, as_wedges()), 2)),
                joined(moved(block(1, as_tetrahedra()), 4), moved(six_pyramids(), 6)));
}

/// Numbers of points are 10, 17, 24, …, and stand behind the elements.
std::string in_form(Form form, const VolumeMesh& mesh) {
  std::string text = "SOL 101\nCEND\nGRID = a title\nbegin bulk\n$ comment\n";
  for (std::size_t c = 0; c < mesh.n_cells(); ++c) {
    std::vector<std::string> fields = {std::to_string(c + 1), "7"};
    for (const std::uint32_t node : mesh.nodes_of(c)) fields.push_back(std::to_string(10 + 7 * node));
    text += card(form, name_of(mesh.type[c]), fields);
  }
  text += card(form, "CTRIA3", {"900", "3", "10", "17", "24"});
  text += card(form, "CBAR", {"901", "3", "10", "17"});
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vec3& p = mesh.points[i];
    text += card(form, "GRID",
                 {std::to_string(10 + 7 * i), "", fmt::format("{:.2f}", p.x()), fmt::format("{:.2f}", p.y()),
                  fmt::format("{:.2f}", p.z())});
  }
  return text + "ENDDATA\nnothing here counts\n";
}

class Nastran : public testing::TestWithParam<Form> {};

TEST_P(Nastran, ReadsAllFormsOfCards) {
  const VolumeMesh mesh = cells_of_all_types();
  const VolumeFile file = parse_nastran(in_form(GetParam(), mesh), "file");
  EXPECT_EQ(file.mesh.points, mesh.points);
  EXPECT_EQ(file.mesh.type, mesh.type);
  EXPECT_EQ(file.mesh.nodes, mesh.nodes);
  EXPECT_THAT(file.boundary.faces, ElementsAre(mesh::BoundaryFace{0, 1, 2, mesh::kNoFourthNode}));
  EXPECT_THAT(file.patch_names, ElementsAre("pid3"));
  EXPECT_EQ(file.skipped.lines, 1u);
}

TEST_P(Nastran, WithstandsDamage) {
  const std::string seed = in_form(GetParam(), block(1, as_tetrahedra()));
  ASSERT_TRUE(is_read_or_refused(parse_nastran, seed));
  for (std::size_t n = 0; n < seed.size(); ++n) is_read_or_refused(parse_nastran, std::string_view(seed).substr(0, n));
  for (std::size_t n = 0; n < seed.find("GRID", seed.find("CBAR")); ++n) {
    EXPECT_FALSE(is_read_or_refused(parse_nastran, std::string_view(seed).substr(0, n))) << "has no points";
  }
  Mutator mutator(5);
  int n_refused = 0;
  for (int round = 0; round < 4000; ++round) {
    n_refused += is_read_or_refused(parse_nastran, mutator.mutated(seed)) ? 0 : 1;
  }
  EXPECT_GT(n_refused, 1000) << "the changes do reach the reader";
}

std::string name_of(Form form) {
  static const std::vector<std::string> names = {"Small", "Large", "Free", "Tabs"};
  return names[static_cast<std::size_t>(form)];
}

INSTANTIATE_TEST_SUITE_P(Forms, Nastran, testing::Values(Form::Small, Form::Large, Form::Free, Form::Tabs),
                         [](const auto& test) { return name_of(test.param); });

const std::string kTriangle = "CTRIA3,1,4,1,2,3\nGRID,1,,1.5-3,-2.5+2,1.D-2\nGRID,2,0,+1.,.5,-1E1\nGRID,3,,,1,\n";

TEST(ReadNastran, ReadsExponentsWithoutALetter) {
  const VolumeFile file = parse_nastran(kTriangle, "file");
  EXPECT_THAT(file.mesh.points, ElementsAre(Vec3(1.5e-3, -250, 0.01), Vec3(1, 0.5, -10), Vec3(0, 1, 0)));
}

TEST(ReadNastran, NamesPatchesByTheCommentsOfOtherPrograms) {
  const auto name = [](const std::string& comment) {
    return parse_nastran(comment + "\n" + kTriangle, "file").patch_names.at(0);
  };
  EXPECT_EQ(name("$ a comment"), "pid4");
  EXPECT_EQ(name("$ANSA_NAME_COMMENT;4;PSHELL;upper wing;;NO;NO;NO;NO;"), "upper wing");
  EXPECT_EQ(name("$ANSA_NAME_COMMENT;4;MAT1;steel;"), "pid4");
  EXPECT_EQ(name("$HMNAME COMP                   4\"wing\""), "wing");
  EXPECT_EQ(name("$HMNAME COMP 4 \"component\"\n$HMNAME PROP 4\"property\" 4"), "property");
  EXPECT_EQ(name("$ Femap Property 4 : tail plane\r"), "tail plane");
  EXPECT_EQ(name("$ FEMAP Property 5 : tail plane"), "pid4");
}

TEST(ReadNastran, TakesSolidsOfThePropertyLayersForLayers) {
  std::string bytes = in_form(Form::Small, block(1, as_tetrahedra()));
  EXPECT_THAT(parse_nastran(bytes, "file").mesh.layer, testing::Each(0));
  bytes.insert(bytes.find("$ comment"), "$ANSA_NAME_COMMENT;7;PSOLID;layers;;NO;\n");
  EXPECT_THAT(parse_nastran(bytes, "file").mesh.layer, testing::Each(1));
}

struct Refused {
  std::string from, to, message;
};

TEST(ReadNastran, SaysWhatIsWrongAndWhere) {
  const std::vector<Refused> all = {
      {"GRID,2,0", "GRID,2,9", "file:3: points in coordinate system 9"},
      {"CTRIA3", "CTRIA6", "file:1: CTRIA6 of higher order"},
      {"CTRIA3,1,4,1,2,3", "CTETRA,1,4,1,2,3,1,2", "file:1: CTETRA of higher order"},
      {"CTRIA3,1,4,1,2,3", "GRDSET,,3", "file:1: points in coordinate system 3"},
      {"CTRIA3,1,4,1,2,3", "INCLUDE 'wing.bdf'", "file:1: INCLUDE of another file"},
      {"CTRIA3,1,4,1,2,3", "CTRIA3,1,4,1,2,8", "file:1: expected a point with a GRID card, found 8"},
      {"CTRIA3,1,4,1,2,3", "CTRIA3,1,4,1,2", "file:1: expected a point, found ''"},
      {"GRID,3", "GRID,1", "two GRID cards have the number 1"},
      {"1.5-3", "nan", "file:2: expected a coordinate, found 'nan'"},
      {"1.5-3", "1.5+999", "file:2: expected a coordinate, found '1.5+999'"},
      {"GRID,3", "GRID,99999999999", "file:4: expected the number of a point, found '99999999999'"},
      {"CTRIA3", "PLOAD4", "expected elements such as CTRIA3"},
  };
  for (const Refused& test : all) {
    std::string bytes = kTriangle;
    ASSERT_NE(bytes.find(test.from), std::string::npos) << test.from;
    bytes.replace(bytes.find(test.from), test.from.size(), test.to);
    try {
      parse_nastran(bytes, "file");
      ADD_FAILURE() << "read in spite of " << test.to;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(test.message));
    }
  }
}

}  // namespace
}  // namespace nearwall::io
