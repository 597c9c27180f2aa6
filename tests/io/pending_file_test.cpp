#include "nearwall/io/pending_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "nearwall/core/errors.h"
#include "tests/io/temporary_folder.h"

namespace nearwall::io {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(PendingFile, AppearsUnderItsNameOnlyWithCommit) {
  const TemporaryFolder folder;
  PendingFile file(folder / "mesh.vtu");
  file.write("one ");
  file.write("two");
  EXPECT_FALSE(std::filesystem::exists(folder / "mesh.vtu"));
  EXPECT_EQ(file.temporary().parent_path(), folder.path());
  EXPECT_TRUE(file.temporary().filename().string().starts_with('.'));
  file.commit();
  EXPECT_EQ(bytes_of(folder / "mesh.vtu"), "one two");
  EXPECT_EQ(file.size(), 7u);
  EXPECT_EQ(folder.n_files(), 1u);
}

TEST(PendingFile, LeavesNothingAndKeepsTheOldFileWithoutCommit) {
  const TemporaryFolder folder;
  folder.file("mesh.vtu", "old");
  {
    PendingFile file(folder / "mesh.vtu");
    file.write("half");
  }
  EXPECT_EQ(bytes_of(folder / "mesh.vtu"), "old");
  EXPECT_EQ(folder.n_files(), 1u);
}

TEST(PendingFile, WritesPartsInAnyOrder) {
  const TemporaryFolder folder;
  PendingFile file(folder / "mesh.ugrid");
  file.write("head");
  file.write_at(6, "tail");
  file.write_at(4, "--");
  file.commit();
  EXPECT_EQ(bytes_of(folder / "mesh.ugrid"), "head--tail");
}

TEST(PendingFile, ReplacesAnOlderFile) {
  const TemporaryFolder folder;
  folder.file("report.json", "old and longer");
  write_text(folder / "report.json", "new");
  EXPECT_EQ(bytes_of(folder / "report.json"), "new");
}

TEST(PendingFile, NamesPathAndReasonWhereTheFolderIsMissing) {
  const TemporaryFolder folder;
  EXPECT_THAT([&] { write_text(folder / "no/such/report.json", "x"); },
              ThrowsMessage<IoError>(testing::AllOf(HasSubstr("no/such/report.json"), HasSubstr("No such file"),
                                                    HasSubstr("create the folder"))));
}

TEST(PendingFile, RefusesToReplaceAFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "out");
  EXPECT_THROW(write_text(folder / "out", "x"), IoError);
  EXPECT_EQ(folder.n_files(), 1u);
}

TEST(PendingFile, ReportsAFullDisk) {
  if (!std::filesystem::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
  const TemporaryFolder folder;
  PendingFile file(folder / "mesh.vtu");
  // The temporary file gives way to a device that is always full.
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  ASSERT_GE(full, 0);
  for (int descriptor = 3; descriptor < full; ++descriptor) {
    std::error_code none;
    const auto target = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), none);
    if (target.filename() == file.temporary().filename()) ::dup2(full, descriptor);
  }
  ::close(full);
  EXPECT_THAT([&] { file.write("x"); },
              ThrowsMessage<IoError>(testing::AllOf(HasSubstr("mesh.vtu"), HasSubstr("space"))));
}

}  // namespace
}  // namespace nearwall::io
