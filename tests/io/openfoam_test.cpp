#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "io/file_bytes.h"
#include "io/openfoam_folder.h"
#include "io/openfoam_input.h"
#include "io/openfoam_text.h"
#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/io/openfoam_writer.h"
#include "nearwall/io/volume_reader.h"
#include "nearwall/mesh/volume_neighbours.h"
#include "tests/io/mesh_for_tests.h"
#include "tests/io/openfoam_meshes.h"
#include "tests/io/temporary_folder.h"

namespace nearwall::io {
namespace {

using mesh::BoundaryType;
using openfoam_meshes::FoamMesh;

const char* const kFiles[] = {"points",   "faces",     "owner",     "neighbour",
                              "boundary", "cellZones", "faceZones", "pointZones"};

/// What the files of a polyMesh say, list by list.
struct FoamLists {
  std::vector<Vec3> points;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<std::size_t> owner, neighbour;

  explicit FoamLists(const std::filesystem::path& folder) {
    const auto open = [&](const char* name) { return read_bytes(folder / name); };
    const auto labels = [](FoamInput& in) {
      std::vector<std::size_t> list;
      in.read_labels("n", 0, [&](std::int64_t label) { list.push_back(static_cast<std::size_t>(label)); });
      return list;
    };
    const std::string owner_bytes = open("owner"), neighbour_bytes = open("neighbour"), face_bytes = open("faces"),
                      point_bytes = open("points");
    FoamInput owner_in(owner_bytes, "owner"), neighbour_in(neighbour_bytes, "neighbour"), face_in(face_bytes, "faces"),
        point_in(point_bytes, "points");
    owner = labels(owner_in);
    neighbour = labels(neighbour_in);
    point_in.read_points([](std::size_t) {}, [&](const Vec3& p) { points.push_back(p); });
    if (face_in.foam_class() == "faceList") {
      face_in.read_items("n", [&](std::size_t) { faces.push_back(labels(face_in)); });
    } else {
      const auto offsets = labels(face_in), corners = labels(face_in);
      for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
        faces.emplace_back(corners.begin() + static_cast<std::ptrdiff_t>(offsets[f]),
                           corners.begin() + static_cast<std::ptrdiff_t>(offsets[f + 1]));
      }
    }
  }

  /// By triangles from the first corner: exact for the plane faces of these meshes.
  Vec3 area(std::size_t f) const {
    Vec3 sum(0, 0, 0);
    for (std::size_t k = 1; k + 1 < faces[f].size(); ++k) {
      sum += cross(points[faces[f][k]] - points[faces[f][0]], points[faces[f][k + 1]] - points[faces[f][0]]) / 2.0;
    }
    return sum;
  }
};

struct Choice {
  std::string name;
  FoamMesh (*make)();
  FoamForm form;
};

class Openfoam : public testing::TestWithParam<Choice> {
 protected:
  const FoamMesh mesh_ = GetParam().make();
  const TemporaryFolder folder_;
  const std::filesystem::path poly_mesh_ = folder_ / "polyMesh";

  void write() const { write_openfoam(poly_mesh_, mesh_.whole(), GetParam().form); }
};

TEST_P(Openfoam, FacesAreInUpperTriangularOrder) {
  write();
  const FoamLists lists(poly_mesh_);
  ASSERT_EQ(lists.owner.size(), lists.faces.size());
  ASSERT_EQ(lists.neighbour.size() + mesh_.boundary.faces.size(), lists.faces.size());
  for (std::size_t f = 0; f < lists.neighbour.size(); ++f) {
    EXPECT_LT(lists.owner[f], lists.neighbour[f]);
    if (f == 0) continue;
    EXPECT_LT(std::pair(lists.owner[f - 1], lists.neighbour[f - 1]), std::pair(lists.owner[f], lists.neighbour[f]));
  }
}

TEST_P(Openfoam, FacesCloseEachCellAndPointOutOfTheirOwner) {
  write();
  const FoamLists lists(poly_mesh_);
  std::vector<Vec3> sum(mesh_.volume.n_cells(), Vec3(0, 0, 0));
  std::vector<double> volume(sum.size(), 0.0);  // ∮ x · n dA / 3; plane faces, so x may be any of its points
  for (std::size_t f = 0; f < lists.faces.size(); ++f) {
    const Vec3 area = lists.area(f);
    const double part = dot(area, lists.points[lists.faces[f][0]]) / 3.0;
    sum[lists.owner[f]] += area;
    volume[lists.owner[f]] += part;
    if (f >= lists.neighbour.size()) continue;
    sum[lists.neighbour[f]] -= area;
    volume[lists.neighbour[f]] -= part;
  }
  for (std::size_t c = 0; c < sum.size(); ++c) {
    EXPECT_LT(norm(sum[c]), 1e-14) << "cell " << c;
    EXPECT_NEAR(volume[c], mesh::cell_volume(mesh_.volume.type[c], mesh_.volume.corners_of(c)), 1e-14) << "cell " << c;
  }
}

TEST_P(Openfoam, IsReadBackAsItWas) {
  write();
  const VolumeFile read = read_volume_mesh(poly_mesh_);
  EXPECT_EQ(read.mesh.points, mesh_.volume.points) << "bit for bit";
  ASSERT_EQ(read.mesh.type, mesh_.volume.type);
  EXPECT_EQ(read.mesh.layer, mesh_.volume.layer);
  for (std::size_t c = 0; c < read.mesh.n_cells(); ++c) {
    EXPECT_EQ(openfoam_meshes::oriented_faces(read.mesh, c), openfoam_meshes::oriented_faces(mesh_.volume, c))
        << "cell " << c;
  }
  EXPECT_EQ(openfoam_meshes::faces_by_name(read.boundary, foam_names(read.boundary.patches)),
            openfoam_meshes::faces_by_name(mesh_.boundary, foam_names(mesh_.boundary.patches)));
  for (const mesh::BoundaryPatch& patch : read.boundary.patches) {
    const auto names = foam_names(mesh_.boundary.patches);
    const auto found = std::find(names.begin(), names.end(), patch.name);
    ASSERT_NE(found, names.end());
    EXPECT_EQ(patch.type, mesh_.boundary.patches[PatchId(static_cast<std::size_t>(found - names.begin()))].type);
  }
}

TEST_P(Openfoam, WritesTheSameBytesAtAnyNumberOfThreads) {
  std::map<std::string, std::string> bytes;
  for (const int n : {1, 2}) {
    const ThreadLimit limit(n);
    write();
    for (const char* file : kFiles) {
      const auto [place, is_new] = bytes.emplace(file, bytes_of(poly_mesh_ / file));
      EXPECT_TRUE(is_new || place->second == bytes_of(poly_mesh_ / file)) << file;
    }
  }
}

std::vector<Choice> choices() {
  std::vector<Choice> all;
  for (const auto& [name, make] : openfoam_meshes::kMeshes) {
    all.push_back({fmt::format("{}InBinary", name), make, FoamForm::Binary});
    all.push_back({fmt::format("{}InAscii", name), make, FoamForm::Ascii});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Meshes, Openfoam, testing::ValuesIn(choices()),
                         [](const auto& test) { return test.param.name; });

TEST(OpenfoamWriter, NotesTheSizesInTheHeadOfTheOwners) {
  const TemporaryFolder folder;
  const FoamMesh mesh = openfoam_meshes::hexahedra();
  write_openfoam(folder.path(), mesh.whole(), FoamForm::Ascii);
  // 3 × 3 × 3 cubes: 3 · 3 · 3 · 2 faces inside, 6 · 9 outside.
  EXPECT_NE(bytes_of(folder / "owner").find("note        \"nPoints:64  nCells:27  nFaces:108  nInternalFaces:54\";"),
            std::string::npos);
}

TEST(OpenfoamWriter, MakesWordsOfTheNamesOfPatches) {
  IdVector<PatchId, mesh::BoundaryPatch> patches;
  for (const char* name : {"a_b", "a b", "a/b", "1st", "Flügel", "", "x{;}\"y", "wall.up-2", "-x"}) {
    patches.push_back({name, BoundaryType::Wall});
  }
  const auto names = foam_names(patches);
  EXPECT_EQ(std::vector<std::string>(names.begin(), names.end()),
            (std::vector<std::string>{"a_b", "a_b_2", "a_b_3", "_1st", "Fl_gel", "_", "x____y", "wall.up-2", "_-x"}));
}

TEST(OpenfoamWriter, LeavesNoZonesOfAnOlderMesh) {
  const TemporaryFolder folder;
  FoamMesh mesh = openfoam_meshes::hexahedra();
  write_openfoam(folder.path(), mesh.whole(), FoamForm::Binary);
  mesh.volume.layer.assign(mesh.volume.n_cells(), 0);
  write_openfoam(folder.path(), mesh.whole(), FoamForm::Binary);
  EXPECT_EQ(bytes_of(folder / "cellZones").find("layers"), std::string::npos);
  EXPECT_EQ(read_volume_mesh(openfoam_meshes::as_case(folder)).mesh.layer, mesh.volume.layer);
}

/// Claims to be larger than it is.
class ClaimedMesh final : public mesh::MeshSource {
 public:
  NodeIndex points = 8;
  std::array<CellIndex, mesh::kNCellTypes> cells{};

  NodeIndex n_points() const override { return points; }
  CellIndex n_cells() const override { return cells[0] + cells[1] + cells[2] + cells[3]; }
  std::array<CellIndex, mesh::kNCellTypes> n_cells_by_type() const override { return cells; }
  std::size_t n_point_batches() const override { return 0; }
  void read_points(std::size_t, mesh::PointBatch&) const override {}
  std::size_t n_cell_batches() const override { return 0; }
  void read_cells(std::size_t, mesh::CellBatch&) const override {}
};

TEST(OpenfoamWriter, RefusesMoreThanLabelsHoldBeforeAnythingIsWritten) {
  const TemporaryFolder folder;
  const auto message_of = [&](NodeIndex points, CellIndex hexahedra, FoamForm form) -> std::string {
    ClaimedMesh source;
    source.points = points;
    source.cells[static_cast<std::size_t>(mesh::CellType::Hexahedron)] = hexahedra;
    const FoamMesh other = openfoam_meshes::hexahedra();
    const mesh::Boundary none;
    try {
      write_openfoam(folder / "polyMesh", {source, none, *other.neighbours, "large"}, form);
    } catch (const InputError& error) {
      return error.what();
    } catch (const InternalError&) {
      return "passed the limits";  // and then found that there is no such mesh
    }
    return "written";
  };
  constexpr std::uint64_t kMost = 2147483647;
  EXPECT_NE(message_of(kMost + 1, 2, FoamForm::Ascii).find("2147483648"), std::string::npos);
  EXPECT_NE(message_of(8, kMost + 1, FoamForm::Ascii).find("cells"), std::string::npos);
  EXPECT_NE(message_of(8, (kMost + 1) / 3 + 2, FoamForm::Ascii).find("faces"), std::string::npos);
  // 3 faces a cell with 4 corners each: too many for the list of all corners, which only the binary form has.
  constexpr std::uint64_t kCells = kMost / 12 + 2;
  EXPECT_NE(message_of(8, kCells, FoamForm::Binary).find("corners"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "polyMesh"));
  EXPECT_EQ(message_of(8, kCells, FoamForm::Ascii), "passed the limits");
}

/// Fails when asked.
class NoNeighbours final : public mesh::NeighbourSource {
 public:
  void read_neighbours(std::size_t, const mesh::CellBatch&, mesh::NeighbourBatch&) const override {
    throw Interrupted();
  }
};

TEST(OpenfoamWriter, LeavesTheOlderMeshWhereItFails) {
  const TemporaryFolder folder;
  const FoamMesh mesh = openfoam_meshes::hexahedra();
  write_openfoam(folder.path(), mesh.whole(), FoamForm::Binary);
  const std::string points = bytes_of(folder / "points");
  const FoamMesh other = openfoam_meshes::mixed();
  const NoNeighbours none;
  EXPECT_THROW(write_openfoam(folder.path(), {*other.source, other.boundary, none, "x"}, FoamForm::Binary),
               Interrupted);
  EXPECT_EQ(bytes_of(folder / "points"), points);
  EXPECT_EQ(folder.n_files(), std::size(kFiles));
}

}  // namespace
}  // namespace nearwall::io
