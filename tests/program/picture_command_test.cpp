#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program/workplace.h"

namespace nearwall::program {
namespace {

using testing::HasSubstr;

/// Width and height as the head of a PNG file tells them: two big-endian numbers after 16 bytes.
std::array<int, 2> size_of_png(const std::string& bytes) {
  if (bytes.size() < 24 || !bytes.starts_with("\x89PNG")) return {0, 0};
  const auto number = [&](std::size_t at) {
    int n = 0;
    for (std::size_t i = at; i < at + 4; ++i) n = 256 * n + static_cast<unsigned char>(bytes[i]);
    return n;
  };
  return {number(16), number(20)};
}

TEST(PictureCommand, MakesAPictureOfTheSizeAskedFor) {
  Workplace place;
  place.write_cube("cube.obj");
  const Outcome outcome =
      place.run({"picture", "cube.obj", "-o", "cube.png", "--size", "320x200", "--view", "-1,-2,1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(size_of_png(place.read("cube.png")), (std::array<int, 2>{320, 200}));
}

TEST(PictureCommand, CutsAMeshAndColoursItByAnArray) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj");
  ASSERT_EQ(place.run({"run", "case.toml"}).exit_code, 0);
  const Outcome outcome =
      place.run({"picture", "out/cube.vtu", "-o", "cut.png", "--clip", "-x", "--color", "Layer", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["size"], (std::array<int, 2>{1600, 1000}));
  EXPECT_EQ(size_of_png(place.read("cut.png")), (std::array<int, 2>{1600, 1000}));
}

TEST(PictureCommand, RefusesWhatItCannotRead) {
  Workplace place;
  place.write_cube("cube.obj");
  const auto picture = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = {"picture", "cube.obj", "-o", "cube.png"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return place.run(arguments);
  };
  EXPECT_EQ(picture({"--size", "320"}).exit_code, 2);
  EXPECT_EQ(picture({"--size", "320x"}).exit_code, 2);
  EXPECT_EQ(picture({"--size", "axb"}).exit_code, 2);
  EXPECT_EQ(picture({"--clip", "w"}).exit_code, 2);
  EXPECT_EQ(picture({"--view", "1,2"}).exit_code, 2);
  EXPECT_THAT(picture({"--size", "320*200"}).err, HasSubstr("1600x1000"));
  EXPECT_EQ(picture({"--color", "NoSuchArray"}).exit_code, 2);
  EXPECT_FALSE(place.has("cube.png"));
}

}  // namespace
}  // namespace nearwall::program
