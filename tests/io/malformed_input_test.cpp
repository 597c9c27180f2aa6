#include <fmt/format.h>
#include <gtest/gtest.h>

#include "io/surface_formats.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/polydata_writer.h"
#include "tests/io/mutator.h"

namespace nearwall::io {
namespace {

/// A reader, and files of its format to begin with.
struct Format {
  std::string name;
  mesh::SurfaceMesh (*parse)(std::string_view, const std::string&);
  std::vector<std::string> seeds;
};

mesh::SurfaceMesh sample(std::size_t n_patches) {
  mesh::SurfaceMesh mesh;
  for (int i = 0; i < 12; ++i) mesh.points.push_back({0.25 * i, 1e-3 * i * i, -7.0 / (i + 1)});
  for (std::size_t i = 0; i + 2 < 12; ++i) {
    mesh.faces.push_back({VertexId(i), VertexId(i + 1), VertexId(i + 2)});
    mesh.face_patch.push_back(PatchId(i % n_patches));
  }
  for (std::size_t p = 0; p < n_patches; ++p) mesh.patch_names.push_back(fmt::format("patch {}", p));
  return mesh;
}

const std::string kVtpWithBase64 =
    "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData>"
    "<Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" "
    "format=\"binary\">JAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAA==</DataArray></Points><Polys>"
    "<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2</DataArray>"
    "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3</DataArray></Polys></Piece></PolyData></VTKFile>";

const std::string kVtkWithOffsets =
    "# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 2 3\nOFFSETS "
    "vtktypeint64\n"
    "0 3\nCONNECTIVITY vtktypeint64\n0 1 2\nCELL_DATA 1\nFIELD FieldData 1\nPatch 1 1 int\n4\n";

const std::string kPlyAscii =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

std::vector<Format> formats() {
  const auto one = sample(1), three = sample(3);
  return {{"stl", parse_stl, {format_stl(one), format_stl(three)}},
          {"obj",
           parse_obj,
           {format_obj(three), "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\nf -1/2/3 -2 \\\n -3 -4 -5\n"}},
          {"ply", parse_ply, {format_ply(three), kPlyAscii}},
          {"off", parse_off, {format_off(one), "COFF\n4 1 0\n0 0 0 9\n1 0 0 9\n1 1 0 9\n0 1 0 9\n4 0 1 2 3 255 0 0\n"}},
          {"vtp", parse_vtp, {format_polydata(polydata_of(three)), kVtpWithBase64}},
          {"vtk", parse_legacy_vtk, {format_legacy_vtk(three), kVtkWithOffsets}}};
}

class MalformedInput : public testing::TestWithParam<Format> {};

TEST_P(MalformedInput, IsReadOrRefusedButNeverHarms) {
  constexpr int kRounds = 1000;
  const Format& format = GetParam();
  int n_refused = 0;
  for (std::size_t s = 0; s < format.seeds.size(); ++s) {
    ASSERT_GT(format.parse(format.seeds[s], "seed").faces.size(), 0u) << "the file is good to begin with";
    Mutator mutator(static_cast<unsigned>(17 + s));
    for (int round = 0; round < kRounds; ++round) {
      const std::string bytes = mutator.mutated(format.seeds[s]);
      try {
        const auto mesh = format.parse(bytes, "file");
        EXPECT_EQ(mesh.face_patch.size(), mesh.faces.size());
        for (const auto& f : mesh.faces) {
          for (const VertexId v : f) ASSERT_LT(v.index(), mesh.points.size());
        }
        for (const PatchId p : mesh.face_patch) ASSERT_LT(p.index(), mesh.patch_names.size());
      } catch (const GeometryError& error) {
        ++n_refused;
        EXPECT_TRUE(std::string_view(error.what()).starts_with("file:")) << error.what();
      }
    }
  }
  EXPECT_GT(n_refused, kRounds / 4) << "the changes do reach the reader";
}

TEST_P(MalformedInput, IsReadOrRefusedWhereverItIsCutOff) {
  for (const std::string& seed : GetParam().seeds) {
    for (std::size_t n = 0; n < seed.size(); ++n) {
      try {
        GetParam().parse(std::string_view(seed).substr(0, n), "file");
      } catch (const GeometryError&) {
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, MalformedInput, testing::ValuesIn(formats()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace nearwall::io
