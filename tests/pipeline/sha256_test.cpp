#include "pipeline/sha256.h"

#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "tests/pipeline/scratch_folder.h"

namespace nearwall::pipeline {
namespace {

std::string digest_of(const std::string& text, std::size_t piece) {
  Sha256 sum;
  for (std::size_t i = 0; i < text.size(); i += piece) {
    const std::string part = text.substr(i, piece);
    sum.add({reinterpret_cast<const unsigned char*>(part.data()), part.size()});
  }
  return sum.digest();
}

TEST(Sha256, HasTheDigestsOfTheStandard) {
  EXPECT_EQ(digest_of("", 1), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(digest_of("abc", 3), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(digest_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq", 56),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(digest_of(std::string(1000000, 'a'), 1000),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotFeelHowTheBytesAreCut) {
  const std::string text(1000, 'x');
  for (const std::size_t piece : {1, 7, 63, 64, 65, 128, 999}) EXPECT_EQ(digest_of(text, piece), digest_of(text, 1000));
}

TEST(Sha256, OfSeveralFilesIsThatOfTheirBytesOneAfterTheOther) {
  const ScratchFolder folder;
  const std::vector<std::filesystem::path> files = {folder.write("a", "ab"), folder.write("b", ""),
                                                    folder.write("c", "c")};
  EXPECT_EQ(sha256_of_files(files), digest_of("abc", 3));
}

TEST(Sha256, OfAMissingFileIsAnError) {
  const std::vector<std::filesystem::path> files = {"/nowhere/file"};
  EXPECT_THROW(sha256_of_files(files), IoError);
}

}  // namespace
}  // namespace nearwall::pipeline
