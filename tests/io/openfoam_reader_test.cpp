#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <map>

#include "io/file_bytes.h"
#include "io/openfoam_folder.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/openfoam_writer.h"
#include "nearwall/io/volume_reader.h"
#include "tests/io/mutator.h"
#include "tests/io/openfoam_meshes.h"
#include "tests/io/temporary_folder.h"

namespace nearwall::io {
namespace {

using mesh::BoundaryType;
using mesh::CellType;
using Files = std::map<std::string, std::string>;

std::string head(const std::string& foam_class, const std::string& format = "ascii", const std::string& arch = {}) {
  return fmt::format("/* a\n comment */ FoamFile {{ version 2.0; format {}; class {}; {} object x; }}\n// * * * //\n",
                     format, foam_class, arch.empty() ? "" : fmt::format("arch \"{}\";", arch));
}

/// One tetrahedron, as a person would type it.
Files typed() {
  return {
      {"points", head("vectorField") + "4 ( (0 0 0) (1 0 0) // x\n (0 1e0 0) (0 0 +1.) )\n"},
      {"faces", head("faceList") + "4(3(0 2 1) 3(0 1 3) 3(1 2 3) 3(2 0 3))"},
      {"owner", head("labelList") + "4{0}"},
      {"neighbour", head("labelList") + "0()"},
      {"boundary", head("polyBoundaryMesh") +
                       "2 ( \"the floor\" { type wall; inGroups 1(wall); nFaces 1; startFace 0; }\n"
                       "grad(p) { type patch; inGroups List<word> 2(a farfield); sub { a 1; } b (1 2);\n"
                       " nFaces 3; startFace 1; } )"},
  };
}

FoamSource source_of(const Files& files) {
  return [&files](std::string_view name) -> FoamFile {
    const auto found = files.find(std::string(name));
    return found == files.end() ? FoamFile{} : FoamFile{fmt::format("file/{}", name), found->second};
  };
}

VolumeFile parse(const Files& files) { return parse_openfoam(source_of(files), "file"); }

std::string message_of(const Files& files) {
  try {
    parse(files);
  } catch (const GeometryError& error) {
    return error.what();
  } catch (const InputError& error) {
    return std::string("input: ") + error.what();
  }
  return "read";
}

Files with(Files files, const std::string& name, const std::string& bytes) {
  files[name] = bytes;
  return files;
}

/// Files of a mesh that we wrote.
Files written(const openfoam_meshes::FoamMesh& mesh, FoamForm form) {
  const TemporaryFolder folder;
  write_openfoam(folder.path(), mesh.whole(), form);
  Files files;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    files[entry.path().filename().string()] = bytes_of(entry.path());
  }
  return files;
}

TEST(OpenfoamReader, ReadsWhatPeopleType) {
  const VolumeFile file = parse(typed());
  ASSERT_EQ(file.mesh.points, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  ASSERT_EQ(file.mesh.type, std::vector<CellType>{CellType::Tetrahedron});
  EXPECT_GT(mesh::cell_volume(CellType::Tetrahedron, file.mesh.corners_of(0)), 0);
  EXPECT_EQ(file.mesh.layer, std::vector<std::int32_t>{0});
  ASSERT_EQ(file.boundary.patches.size(), 2U);
  EXPECT_EQ(file.boundary.patches[PatchId(0)], (mesh::BoundaryPatch{"the floor", BoundaryType::Wall}));
  EXPECT_EQ(file.boundary.patches[PatchId(1)], (mesh::BoundaryPatch{"grad(p)", BoundaryType::FarField}));
  EXPECT_EQ(file.boundary.faces[0], (mesh::BoundaryFace{0, 2, 1, mesh::kNoFourthNode}));
  EXPECT_EQ(file.boundary.patch, (std::vector<PatchId>{PatchId(0), PatchId(1), PatchId(1), PatchId(1)}));
}

TEST(OpenfoamReader, ReadsListsWithoutCountsAndCompactOnesInAscii) {
  Files files = typed();
  files["points"] = head("vectorField") + "((0 0 0) (1 0 0) (0 1 0) (0 0 1))";
  files["faces"] = head("faceCompactList") + "5 (0 3 6 9 12) 12 (0 2 1 0 1 3 1 2 3 2 0 3)";
  files["owner"] = head("labelList") + "(0 0 0 0)";
  files["cellZones"] = head("regIOobject") +
                       "2 ( other { type cellZone; cellLabels List<label> 0(); }\n"
                       "layers { type cellZone; cellLabels List<label> 1(0); } )";
  const VolumeFile file = parse(files);
  EXPECT_EQ(file.mesh.nodes, parse(typed()).mesh.nodes);
  EXPECT_EQ(file.mesh.layer, std::vector<std::int32_t>{1});
}

template <class T>
void append(std::string& out, T value, std::endian order) {
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  if (order != std::endian::native) bytes.assign(bytes.rbegin(), bytes.rend());
  out += bytes;
}

template <class Label, class Scalar>
Files binary(const std::string& arch, std::endian order) {
  const auto labels = [&](std::initializer_list<int> list) {
    std::string text = fmt::format("\n{}\n(", list.size());
    for (const int label : list) append(text, static_cast<Label>(label), order);
    return text + ")";
  };
  Files files = typed();
  files["points"] = head("vectorField", "binary", arch) + "4(";
  for (const double value : {0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 0.1}) {
    append(files["points"], static_cast<Scalar>(value), order);
  }
  files["points"] += ")";
  const std::string begin = head("labelList", "binary", arch);
  files["owner"] = begin + labels({0, 0, 0, 0});
  files["neighbour"] = begin + "0\n";
  files["faces"] = head("faceList", "binary", arch) + "4\n(" + labels({0, 2, 1}) + labels({0, 1, 3}) +
                   labels({1, 2, 3}) + labels({2, 0, 3}) + ")";
  return files;
}

TEST(OpenfoamReader, ReadsBinaryNumbersOfEachSizeAndOrder) {
  const VolumeFile small = parse(binary<std::int32_t, float>("LSB;label=32;scalar=32", std::endian::little));
  const VolumeFile large = parse(binary<std::int64_t, double>("MSB;label=64;scalar=64", std::endian::big));
  EXPECT_EQ(small.mesh.points.back(), Vec3(0, 0, double{0.1F}));
  EXPECT_EQ(large.mesh.points.back(), Vec3(0, 0, 0.1));
  EXPECT_EQ(small.mesh.nodes, parse(typed()).mesh.nodes);
  EXPECT_EQ(large.mesh.nodes, small.mesh.nodes);
}

TEST(OpenfoamReader, FindsTheMeshOfACaseAndPackedFiles) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const fs::path poly_mesh = folder / "wing" / "constant" / "polyMesh";
  const auto mesh = openfoam_meshes::mixed();
  write_openfoam(poly_mesh, mesh.whole(), FoamForm::Ascii);
  for (const char* name : {"points", "owner", "cellZones"}) {
    const std::string packed = gzip(bytes_of(poly_mesh / name));
    fs::remove(poly_mesh / name);
    std::ofstream(poly_mesh / (std::string(name) + ".gz"), std::ios::binary) << packed;
  }
  folder.file("wing/wing.foam", "");
  for (const fs::path& path :
       {folder / "wing", folder / "wing/", folder / "wing" / "wing.foam", poly_mesh, poly_mesh / ""}) {
    EXPECT_TRUE(is_volume_name(path)) << path;
    const VolumeFile file = read_volume_mesh(path);
    EXPECT_EQ(file.mesh.points, mesh.volume.points) << path;
    EXPECT_EQ(file.mesh.layer, mesh.volume.layer) << path;
  }
  EXPECT_FALSE(is_volume_name(folder.path()));
  EXPECT_THROW(read_volume_mesh(folder.path()), InputError);
  fs::remove(poly_mesh / "faces");
  EXPECT_THROW(read_volume_mesh(poly_mesh), InputError);
}

TEST(OpenfoamReader, NamesTheFirstPolyhedronAndTellsHowManyThereAre) {
  // Two pyramids with their tips apart, over one quad whose other side is divided: the second has two triangles there.
  Files files;
  files["points"] = head("vectorField") + "6((0 0 0)(1 0 0)(1 1 0)(0 1 0)(.5 .5 -1)(.5 .5 1))";
  files["faces"] = head("faceList") +
                   "10(3(0 1 2) 3(0 2 3) 3(0 4 1) 3(1 4 2) 3(2 4 3) 3(3 4 0) 3(0 1 5) 3(1 2 5) 3(2 3 5) 3(3 0 5))";
  files["owner"] = head("labelList") + "10(0 0 0 0 0 0 1 1 1 1)";
  files["neighbour"] = head("labelList") + "2(1 1)";
  files["boundary"] = head("polyBoundaryMesh") + "0()";
  const std::string message = message_of(files);
  EXPECT_TRUE(message.starts_with("input: file: cell 0 is a polyhedron with 6 faces, and 1 more of 2 cells"))
      << message;
}

TEST(OpenfoamReader, RefusesFilesThatDoNotFitTogether) {
  const Files good = typed();
  ASSERT_EQ(message_of(good), "read");
  const auto expect_refused = [](const Files& files, const std::string& what) {
    EXPECT_NE(message_of(files).find(what), std::string::npos) << message_of(files);
  };
  const std::string faces = head("faceList"), labels = head("labelList"), patches = head("polyBoundaryMesh");
  expect_refused(with(good, "faces", faces + "4(3(0 2 1) 3(0 1 4) 3(1 2 3) 3(2 0 3))"), "point 4");
  expect_refused(with(good, "faces", faces + "4(3(0 2 1) 3(0 3 1) 3(1 2 3) 3(2 0 3))"), "point away");
  expect_refused(with(good, "faces", faces + "4(3(0 2 1) 2(0 1) 3(1 2 3) 3(2 0 3))"), "3 points or more");
  expect_refused(with(good, "faces", faces + "3(3(0 2 1) 3(0 1 3) 3(1 2 3))"), "owner");
  expect_refused(with(good, "faces", head("faceCompactList") + "3(0 3 2) 3(0 1 2)"), "ascending");
  expect_refused(with(good, "faces", labels + "4(0 0 0 0)"), "faceCompactList");
  expect_refused(with(good, "owner", labels + "4{99999999999}"), "no number of a cell");
  expect_refused(with(good, "owner", labels + "99999999999{0}"), "at most 4");
  expect_refused(with(good, "owner", labels + "99999999999(0 0 0 0)"), "more than the");
  expect_refused(with(good, "owner", labels + "4{2}"), "cell 0: expected 4 faces or more, found 0");
  expect_refused(with(good, "neighbour", labels + "5(0 0 0 0 0)"), "at most 4");
  expect_refused(with(good, "points", head("vectorField") + "4((0 0 0) (1 0 0) (0 nan 0) (0 0 1))"), "finite");
  expect_refused(with(good, "points", "4((0 0 0) (1 0 0) (0 1 0) (0 0 1))"), "FoamFile");
  expect_refused(with(good, "boundary", patches + "1(a { type wall; nFaces 5; startFace 0; })"), "startFace 0");
  expect_refused(with(good, "boundary", patches + "1(a { type wall; nFaces 2; startFace 1; })"), "startFace 0");
  expect_refused(with(good, "boundary", patches + "1(a { type wall; nFaces 2;"), "end of the file");
  expect_refused(with(good, "cellZones", labels + "1(layers{ cellLabels List<label> 1(7); })"), "cell 7");
}

/// Whether the files were read, and then to a mesh whose parts fit together.
bool is_read_or_refused(const Files& files) {
  try {
    const VolumeFile file = parse(files);
    EXPECT_EQ(file.mesh.first_node.back(), file.mesh.nodes.size());
    for (const std::uint32_t node : file.mesh.nodes) EXPECT_LT(node, file.mesh.points.size());
    for (const mesh::BoundaryFace& face : file.boundary.faces) EXPECT_LT(face[0], file.mesh.points.size());
    return true;
  } catch (const GeometryError& error) {
    EXPECT_TRUE(std::string_view(error.what()).starts_with("file")) << error.what();
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string_view(error.what()).starts_with("file: cell ")) << error.what();
  }
  return false;
}

TEST(OpenfoamReader, ReadsOrRefusesWhateverIsDamaged) {
  constexpr int kRounds = 3000;
  const std::vector<Files> seeds = {typed(), written(openfoam_meshes::pyramids(), FoamForm::Binary),
                                    written(openfoam_meshes::pyramids(), FoamForm::Ascii),
                                    binary<std::int64_t, float>("MSB;label=64;scalar=32", std::endian::big)};
  for (const Files& seed : seeds) {
    ASSERT_TRUE(is_read_or_refused(seed));
    Mutator mutator(31);
    int n_refused = 0, round = 0;
    while (round < kRounds) {
      for (const auto& [name, bytes] : seed) {
        n_refused += is_read_or_refused(with(seed, name, mutator.mutated(bytes))) ? 0 : 1;
        ++round;
      }
    }
    EXPECT_GT(n_refused, kRounds / 4) << "the changes do reach the reader";
  }
}

TEST(OpenfoamReader, ReadsOrRefusesWhereverAFileIsCutOff) {
  const Files seed = written(openfoam_meshes::pyramids(), FoamForm::Binary);
  for (const auto& [name, bytes] : seed) {
    for (std::size_t n = 0; n < bytes.size(); n += 3) is_read_or_refused(with(seed, name, bytes.substr(0, n)));
  }
}

}  // namespace
}  // namespace nearwall::io
