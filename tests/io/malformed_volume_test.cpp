#include <fmt/format.h>
#include <gtest/gtest.h>

#include "io/volume_formats.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/vtu_writer.h"
#include "tests/io/mesh_for_tests.h"
#include "tests/io/mutator.h"
#include "tests/io/temporary_folder.h"
#include "tests/io/volume_files.h"

namespace nearwall::io {
namespace {

struct Format {
  std::string name;
  VolumeFile (*parse)(std::string_view, const std::string&);
  std::string seed;
};

std::string written_by_us() {
  const auto path = std::filesystem::temp_directory_path() / fmt::format("malformed-volume-{}.vtu", ::getpid());
  write_vtu(path, one_of_each(), {}, {{"hull"}});
  std::string bytes = bytes_of(path);
  std::filesystem::remove(path);
  return bytes;
}

/// One tetrahedron, big endian, binary.
std::string binary_legacy() {
  std::string text = "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n";
  const auto add = [&](std::uint32_t bits) {
    for (const int shift : {24, 16, 8, 0}) text += static_cast<char>(bits >> shift & 0xff);
  };
  for (const float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f}) {
    add(std::bit_cast<std::uint32_t>(value));
  }
  text += "\nCELLS 1 5\n";
  for (const std::uint32_t value : {4u, 0u, 1u, 2u, 3u}) add(value);
  text += "\nCELL_TYPES 1\n";
  add(10);
  return text + "\n";
}

std::vector<Format> formats() {
  return {{"ours", parse_vtu, written_by_us()},
          {"ascii", parse_vtu, volume_files::kXmlAscii},
          {"old", parse_legacy_volume, volume_files::kLegacyOld},
          {"offsets", parse_legacy_volume, volume_files::kLegacyOffsets},
          {"binary", parse_legacy_volume, binary_legacy()}};
}

/// Whether the bytes were read, and then to a mesh whose parts fit together.
bool is_read_or_refused(const Format& format, std::string_view bytes) {
  try {
    const mesh::VolumeMesh mesh = format.parse(bytes, "file").mesh;
    EXPECT_EQ(mesh.first_node.size(), mesh.n_cells() + 1);
    EXPECT_EQ(mesh.file_cell.size(), mesh.n_cells());
    EXPECT_EQ(mesh.first_node.back(), mesh.nodes.size());
    for (std::size_t c = 0; c < mesh.n_cells(); ++c) {
      EXPECT_EQ(mesh.first_node[c] + static_cast<std::size_t>(mesh::size_of(mesh.type[c])), mesh.first_node[c + 1]);
    }
    for (const std::uint32_t node : mesh.nodes) EXPECT_LT(node, mesh.points.size());
    for (const Vec3& p : mesh.points) EXPECT_TRUE(is_finite(p));
    return true;
  } catch (const GeometryError& error) {
    EXPECT_TRUE(std::string_view(error.what()).starts_with("file:")) << error.what();
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string_view(error.what()).starts_with("file: cell ")) << error.what();
  }
  return false;
}

class MalformedVolume : public testing::TestWithParam<Format> {};

TEST_P(MalformedVolume, IsReadOrRefusedWhereverItIsDamaged) {
  constexpr int kRounds = 4000;
  const Format& format = GetParam();
  ASSERT_TRUE(is_read_or_refused(format, format.seed)) << "the file is good to begin with";
  Mutator mutator(29);
  int n_refused = 0;
  for (int round = 0; round < kRounds; ++round) {
    n_refused += is_read_or_refused(format, mutator.mutated(format.seed)) ? 0 : 1;
  }
  EXPECT_GT(n_refused, kRounds / 4) << "the changes do reach the reader";
}

TEST_P(MalformedVolume, IsReadOrRefusedWithAnyBitTurned) {
  std::string bytes = GetParam().seed;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    const char mask = static_cast<char>(1 << (bit % 8));
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ mask);
    is_read_or_refused(GetParam(), bytes);
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ mask);
  }
}

TEST_P(MalformedVolume, IsRefusedWhereverItIsCutOff) {
  const std::string& seed = GetParam().seed;
  int n_read = 0;
  for (std::size_t n = 0; n < seed.size(); ++n) {
    n_read += is_read_or_refused(GetParam(), std::string_view(seed).substr(0, n)) ? 1 : 0;
  }
  // Behind its last number a file may end anywhere; before, there is no mesh but the empty one.
  EXPECT_LT(n_read, 250);
}

INSTANTIATE_TEST_SUITE_P(Formats, MalformedVolume, testing::ValuesIn(formats()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace nearwall::io
