#include "pipeline/output_directory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "tests/pipeline/scratch_folder.h"

namespace nearwall::pipeline {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

TEST(OutputDirectory, ShowsFilesOnlyWhenPublished) {
  const ScratchFolder folder;
  {
    OutputDirectory output(folder / "out", "wing", false);
    write(output.aside("wing.vtu"), "mesh");
    write(output.scratch("wing-close-up.vtu"), "part");
    EXPECT_FALSE(fs::exists(folder / "out/wing.vtu"));
    EXPECT_EQ(output.publish(), std::vector<std::string>{"wing.vtu"});
  }
  EXPECT_EQ(folder.read("out/wing.vtu"), "mesh");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "out"), {}), 1) << "nothing else is left behind";
}

TEST(OutputDirectory, LeavesNothingBehindWhenGivenUp) {
  const ScratchFolder folder;
  {
    OutputDirectory output(folder / "a/b", "wing", false);
    write(output.aside("wing.vtu"), "half");
  }
  EXPECT_FALSE(fs::exists(folder / "a/b"));
}

TEST(OutputDirectory, LeavesNoFolderBehindForANameThatIsTooLong) {
  const ScratchFolder folder;
  EXPECT_THROW(OutputDirectory(folder / "out", std::string(300, 'x'), false), IoError);
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(OutputDirectory, IsWrittenByOneRunAtATime) {
  const ScratchFolder folder;
  {
    OutputDirectory first(folder / "out", "wing", false);
    write(first.aside("wing.vtu"), "first");
    EXPECT_THROW(OutputDirectory(folder / "out", "wing", false), InputError);
    EXPECT_THROW(OutputDirectory(folder / "out", "wing", true), InputError);
    first.publish();
  }
  EXPECT_EQ(folder.read("out/wing.vtu"), "first");
  EXPECT_NO_THROW(OutputDirectory(folder / "out", "wing", false));
}

TEST(OutputDirectory, KeepsEarlierResultsIfAFileVanished) {
  const ScratchFolder folder;
  fs::create_directories(folder / "out");
  folder.write("out/wing.vtu", "old");
  OutputDirectory output(folder / "out", "wing", false);
  write(output.aside("wing.vtu"), "new");
  fs::remove_all(folder / "out/.wing-partial");
  EXPECT_THROW(output.publish(), IoError);
  EXPECT_EQ(folder.read("out/wing.vtu"), "old");
}

TEST(OutputDirectory, ReplacesResultsOfAnEarlierRun) {
  const ScratchFolder folder;
  fs::create_directories(folder / "out/.wing-partial");
  for (const char* file : {"wing.vtu", "wing-faults.vtp", "wing-surface-kinds.png", "report.json", "report.html"}) {
    folder.write(std::string("out/") + file, "old");
  }
  OutputDirectory output(folder / "out", "wing", false);
  EXPECT_EQ(folder.read("out/wing.vtu"), "old") << "kept until there is something new";
  write(output.aside("wing.vtu"), "new");
  output.publish();
  EXPECT_EQ(folder.read("out/wing.vtu"), "new");
  EXPECT_FALSE(fs::exists(folder / "out/report.json"));
  EXPECT_FALSE(fs::exists(folder / "out/wing-faults.vtp"));
}

TEST(OutputDirectory, ReplacesAFolderOfTheMeshAndNothingBesideIt) {
  const ScratchFolder folder;
  fs::create_directories(folder / "out/wing-openfoam/constant/polyMesh");
  fs::create_directories(folder / "out/wing-openfoam/0");
  folder.write("out/wing-openfoam/constant/polyMesh/points", "old");
  folder.write("out/wing-openfoam/constant/polyMesh/pointZones", "old");
  folder.write("out/wing-openfoam/0/U", "mine");
  OutputDirectory output(folder / "out", "wing", false);
  const fs::path mesh = output.aside("wing-openfoam/constant/polyMesh");
  fs::create_directories(mesh);
  write(mesh / "points", "new");
  EXPECT_EQ(folder.read("out/wing-openfoam/constant/polyMesh/points"), "old") << "kept until there is something new";
  output.publish();
  EXPECT_EQ(folder.read("out/wing-openfoam/constant/polyMesh/points"), "new");
  EXPECT_FALSE(fs::exists(folder / "out/wing-openfoam/constant/polyMesh/pointZones"));
  EXPECT_EQ(folder.read("out/wing-openfoam/0/U"), "mine");
}

TEST(OutputDirectory, TakesFoldersOfAnotherCaseForOtherThings) {
  const ScratchFolder folder;
  fs::create_directories(folder / "winglet-openfoam");
  EXPECT_THROW(OutputDirectory(folder.path(), "wing", false), InputError);
  EXPECT_NO_THROW(OutputDirectory(folder.path(), "winglet", false));
}

TEST(OutputDirectory, DoesNotTouchAFolderThatHoldsOtherThings) {
  const ScratchFolder folder;
  folder.write("thesis.tex", "years");
  try {
    OutputDirectory output(folder.path(), "wing", false);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("for instance thesis.tex"));
    EXPECT_THAT(e.what(), testing::HasSubstr("--force"));
  }
  OutputDirectory forced(folder.path(), "wing", true);
  write(forced.aside("wing.vtu"), "new");
  forced.publish();
  EXPECT_EQ(folder.read("thesis.tex"), "years");
  EXPECT_EQ(folder.read("wing.vtu"), "new");
}

TEST(OutputDirectory, TakesResultsOfAnotherCaseForOtherThings) {
  const ScratchFolder folder;
  folder.write("winglet.vtu", "");
  EXPECT_THROW(OutputDirectory(folder.path(), "wing", false), InputError);
}

TEST(OutputDirectory, IsNoFile) {
  const ScratchFolder folder;
  folder.write("out", "");
  EXPECT_THROW(OutputDirectory(folder / "out", "wing", true), InputError);
}

}  // namespace
}  // namespace nearwall::pipeline
