#include "nearwall/io/surface_reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "io/file_bytes.h"
#include "nearwall/core/errors.h"
#include "tests/io/temporary_folder.h"

namespace nearwall::io {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

mesh::SurfaceMesh read(std::string_view name, std::string_view bytes) {
  const TemporaryFolder folder;
  return read_surface(folder.file(name, bytes));
}

std::vector<std::array<std::uint32_t, 3>> faces_of(const mesh::SurfaceMesh& mesh) {
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (const auto& f : mesh.faces) faces.push_back({f[0].index(), f[1].index(), f[2].index()});
  return faces;
}

std::vector<std::string> patch_of_faces(const mesh::SurfaceMesh& mesh) {
  std::vector<std::string> names;
  for (const PatchId p : mesh.face_patch) names.push_back(mesh.patch_names[p]);
  return names;
}

void expect_refused(std::string_view name, std::string_view bytes, const testing::Matcher<std::string>& message) {
  EXPECT_THAT([&] { read(name, bytes); }, ThrowsMessage<GeometryError>(AllOf(HasSubstr(std::string(name)), message)));
}

std::string facet(double x) {
  return fmt::format("facet normal 0 0 1\nouter loop\nvertex {} 0 0\nvertex 1 0 0\nvertex 0 1e0 0\nendloop\nendfacet\n",
                     x);
}

template <class T>
void append(std::string& out, T value, bool big = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big) std::ranges::reverse(raw);
  out.append(raw, sizeof(T));
}

/// Two triangles, as many as `claimed` in the header.
std::string binary_stl(std::string header, std::uint32_t claimed, float last = 1) {
  header.resize(80, ' ');
  append(header, claimed);
  for (int t = 0; t < 2; ++t) {
    for (const float v : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, last, 0.25f}) append(header, v);
    append(header, std::uint16_t{7});
  }
  return header;
}

// Path and ending.

TEST(ReadSurface, ToldApartMissingFolderAndEnding) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "folder.stl");
  const auto reading = [&](std::string name) { return [&folder, name] { read_surface(folder / name); }; };
  EXPECT_THAT(reading("none.stl"), ThrowsMessage<InputError>(AllOf(HasSubstr("none.stl"), HasSubstr("no such file"))));
  EXPECT_THAT(reading("folder.stl"), ThrowsMessage<InputError>(HasSubstr("is a folder")));
  EXPECT_THAT(reading("wing.sltl"),
              ThrowsMessage<InputError>(AllOf(HasSubstr("unknown ending '.sltl'"), HasSubstr("stl obj ply off vtp vtk"),
                                              HasSubstr("did you mean .stl?"))));
  EXPECT_THAT(reading("wing"), ThrowsMessage<InputError>(HasSubstr("no ending")));
  EXPECT_THAT(reading("wing.meshb.gz"), ThrowsMessage<InputError>(HasSubstr("not in this version")));
}

TEST(ReadSurface, TakesEndingsInUpperCaseAndGzip) {
  const std::string text = "solid a\n" + facet(0) + "endsolid\n";
  EXPECT_EQ(read("A.STL", text).faces.size(), 1u);
  EXPECT_EQ(read("a.stl.gz", gzip(text)).faces.size(), 1u);
  EXPECT_EQ(read("a.stl.GZ", gzip(text)).faces.size(), 1u);
  EXPECT_EQ(read("a.stl", gzip(text)).faces.size(), 1u) << "gzip is told by the content";
}

TEST(SurfaceName, IsToldByItsEnding) {
  EXPECT_TRUE(is_surface_name("a.b/wing.STL"));
  EXPECT_TRUE(is_surface_name("wing.vtk.GZ"));
  EXPECT_FALSE(is_surface_name("wing.toml"));
  EXPECT_FALSE(is_surface_name("stl"));
  EXPECT_FALSE(is_surface_name("wing.gz"));
}

TEST(SurfaceName, HasAStemWithoutEndings) {
  EXPECT_EQ(surface_stem("a.b/wing.v2.stl"), "wing.v2");
  EXPECT_EQ(surface_stem("a.b/wing.STL.GZ"), "wing");
}

TEST(ReadSurface, ReadsGzipOfSeveralMembers) {
  const auto mesh = read("a.stl.gz", gzip("solid a\n" + facet(0)) + gzip(facet(2) + "endsolid\n"));
  EXPECT_EQ(mesh.faces.size(), 2u);
}

TEST(ReadSurface, RefusesDamagedGzip) {
  const std::string packed = gzip("solid a\n" + facet(0) + "endsolid\n");
  expect_refused("cut.stl.gz", packed.substr(0, packed.size() / 2), HasSubstr("ends too early"));
  std::string damaged = packed;
  damaged[packed.size() / 2] ^= 0x55;
  EXPECT_THROW(read("bad.stl.gz", damaged), GeometryError);
  expect_refused("plain.stl.gz", "solid", HasSubstr("not gzipped"));
}

TEST(ReadSurface, ReportsAFileThatCannotBeOpened) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink(folder / "round.stl", folder / "round.stl");  // refused to root, too
  EXPECT_THAT([&] { read_surface(folder / "round.stl"); },
              ThrowsMessage<IoError>(AllOf(HasSubstr("round.stl"), HasSubstr("cannot be read"))));
}

// STL.

TEST(ReadStl, MakesAPatchOfEachSolid) {
  const auto mesh =
      read("a.stl", "solid left wing\n" + facet(0) + facet(0.5) + "endsolid left wing\nsolid\n" + facet(0) +
                        "endsolid\nsolid empty\nendsolid\nsolid left wing\n" + facet(0) + "endsolid\n");
  EXPECT_THAT(mesh.patch_names.raw(), ElementsAre("left wing", "solid1"));
  EXPECT_THAT(patch_of_faces(mesh), ElementsAre("left wing", "left wing", "solid1", "left wing"));
  EXPECT_EQ(mesh.points.size(), 12u) << "corners are not welded";
  EXPECT_EQ(mesh.points[VertexId(3)], Vec3(0.5, 0, 0));
}

TEST(ReadStl, TakesAnyLineEndCaseAndNotation) {
  std::string text = "  SOLID A\n" + facet(0) + "ENDSOLID\n";
  for (const std::string end : {"\r\n", "\r", "\n\n"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    EXPECT_EQ(read("a.stl", other).points[VertexId(2)], Vec3(0, 1, 0));
  }
  const auto odd = read("b.stl",
                        "solid\nfacet normal\nOuter Loop\nvertex +1.5E-3 -.25 1e-400\nvertex\t1,5 0 0\n"
                        "vertex 1 1 1\nendloop by hand\nendfacet 17\nendsolid");
  EXPECT_EQ(odd.points[VertexId(0)], Vec3(1.5e-3, -0.25, 0));
  EXPECT_EQ(odd.points[VertexId(1)], Vec3(1.5, 0, 0)) << "decimal comma";
}

TEST(ReadStl, ReadsBinaryWhateverTheHeaderSays) {
  for (const char* header : {"made by hand", "solid made by hand", ""}) {
    const auto mesh = read("a.stl", binary_stl(header, 2));
    EXPECT_EQ(mesh.faces.size(), 2u);
    EXPECT_EQ(mesh.points[VertexId(5)], Vec3(0, 1, 0.25));
    EXPECT_THAT(mesh.patch_names.raw(), ElementsAre("surface"));
  }
}

TEST(ReadStl, RefusesBinaryOfTheWrongSize) {
  expect_refused("a.stl", binary_stl("x", 3), AllOf(HasSubstr("byte 80"), HasSubstr("claims 3"), HasSubstr("holds 2")));
  expect_refused("a.stl", binary_stl("solid", 4000000000u), HasSubstr("claims 4000000000"));
  expect_refused("a.stl", binary_stl("x", 1), HasSubstr("50 bytes follow"));
  expect_refused("a.stl", binary_stl("x", 2).substr(0, 150), HasSubstr("holds 1"));
  expect_refused("a.stl", binary_stl("x", 0).substr(0, 84), HasSubstr("no triangle"));
  expect_refused("a.stl", "x", HasSubstr("found 1 bytes"));
}

TEST(ReadStl, RefusesNumbersThatAreNotFinite) {
  expect_refused("a.stl", binary_stl("x", 2, std::numeric_limits<float>::quiet_NaN()),
                 AllOf(HasSubstr("byte 84"), HasSubstr("finite")));
  expect_refused("a.stl", "solid\nfacet\nouter loop\nvertex 1 nan 0",
                 AllOf(HasSubstr(":4:"), HasSubstr("y as a finite")));
  expect_refused("a.stl", "solid\nfacet\nouter loop\nvertex 1 2 1e400", HasSubstr("z as a finite"));
}

TEST(ReadStl, NamesTheLineOfAMistake) {
  expect_refused("a.stl", "", HasSubstr("no triangle"));
  expect_refused("a.stl", "solid\nendsolid\n", HasSubstr("no triangle"));
  expect_refused("a.stl", "solid\n" + facet(0), AllOf(HasSubstr(":9:"), HasSubstr("end of the file")));
  expect_refused("a.stl", "solid\nfacet\nouter\nvertex", AllOf(HasSubstr(":4:"), HasSubstr("'loop'")));
  expect_refused("a.stl", "solid\nfacet\nouter loop\nvertex 1 2 blah", HasSubstr("expected z, found 'blah'"));
  expect_refused("a.stl", "solid\nfacet\nouter loop\nvertex 1 2 3\nvertex 1 2 3\nvertex 1 2 3\nvertex 1 2 3",
                 AllOf(HasSubstr(":7:"), HasSubstr("more than 3")));
}

// OBJ.

constexpr std::string_view kSquare = "v 0 0 0\nv 1 0 0 1\nv 1 1 0\nv 0 1 0 0.5 0.5 0.5\n";

TEST(ReadObj, ReadsEveryFormOfAFace) {
  const auto mesh = read("a.obj", std::string(kSquare) +
                                      "vt 0 0\nvn 0 0 1\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\n"
                                      "f -4/1/1 -3/1/1 -2/1/1 # remark\nf 1 \\\n 2 3\nf 1 2\\\n 3");
  EXPECT_EQ(mesh.faces.size(), 6u);
  for (const auto& f : faces_of(mesh)) EXPECT_THAT(f, ElementsAre(0, 1, 2));
  EXPECT_EQ(mesh.points.size(), 4u) << "shared points stay shared";
}

TEST(ReadObj, MakesPatchesOfGroupsElseObjectsElseMaterials) {
  const std::string f = "f 1 2 3\n";
  const std::string square(kSquare);
  const auto groups =
      read("a.obj", square + f + "usemtl m\no obj\ng  b  c\n" + f + "g a\n" + f + "g b c\n" + f + "g\n" + f);
  EXPECT_THAT(patch_of_faces(groups), ElementsAre("default", "b c", "a", "b c", "default"));
  EXPECT_THAT(groups.patch_names.raw(), ElementsAre("b c", "a", "default"));
  EXPECT_THAT(patch_of_faces(read("a.obj", square + "usemtl m\no obj\n" + f)), ElementsAre("obj"));
  EXPECT_THAT(patch_of_faces(read("a.obj", square + "usemtl m\n" + f)), ElementsAre("m"));
  EXPECT_THAT(patch_of_faces(read("a.obj", square + f)), ElementsAre("surface"));
}

TEST(ReadObj, NamesTheLineOfAMistake) {
  const std::string square(kSquare);
  expect_refused("a.obj", square + "f 1 2 5", AllOf(HasSubstr(":5:"), HasSubstr("point 5"), HasSubstr("1 to 4")));
  expect_refused("a.obj", square + "f 1 2 0", HasSubstr("point 0"));
  expect_refused("a.obj", square + "f -5 2 1", HasSubstr("point -5"));
  expect_refused("a.obj", square + "f 1 2", HasSubstr("3 corners or more, found 2"));
  expect_refused("a.obj", square + "f 1 2 x", HasSubstr("found 'x'"));
  expect_refused("a.obj", "v 0 0\nf 1 1 1",
                 AllOf(HasSubstr(":1:"), HasSubstr("expected z"), HasSubstr("end of the line")));
  expect_refused("a.obj", square, HasSubstr("no triangle"));
}

TEST(ReadObj, RefusesAFaceOfTooManyCorners) {
  std::string text(kSquare);
  text += "f";
  for (int i = 0; i < 5000; ++i) text += " 1";
  expect_refused("a.obj", text, HasSubstr("5000 corners"));
}

// OFF.

TEST(ReadOff, ReadsHeadersColoursNormalsAndRemarks) {
  const std::string body =
      "# remark\n4 1 0 # counts\n\n0 0 0 9 9\n1 0 0\n# in between\n1 1 0\n0 1 0\n4 0 1 2 3  255 0 0\n";
  for (const char* header : {"OFF\n", "COFF\n", "NOFF\n", "STOFF\n", "", "OFF "}) {
    EXPECT_THAT(faces_of(read("a.off", header + body)), ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0, 2, 3)))
        << header;
  }
}

TEST(ReadOff, NamesTheLineOfAMistake) {
  expect_refused("a.off", "OFF BINARY\n1 2 3", HasSubstr("convert it to ascii"));
  expect_refused("a.off", "4OFF\n1 2 3", HasSubstr("not supported"));
  expect_refused("a.off", "ply\n1 2 3", HasSubstr("expected 'OFF', found 'ply'"));
  expect_refused("a.off", "OFF\n1000000000000 1 0\n", HasSubstr("more than"));
  expect_refused("a.off", "OFF\n-1 1 0\n", HasSubstr("found -1"));
  expect_refused("a.off", "OFF\n2 1 0\n0 0 0\n1 0\n3 0 1 2\n", AllOf(HasSubstr(":4:"), HasSubstr("expected z")));
  expect_refused("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", HasSubstr("point 3"));
  expect_refused("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n999999999 0 1 3\n", HasSubstr("999999999"));
  expect_refused("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0      \n", HasSubstr("expected 1 faces"));
}

// PLY.

std::string ply_header(std::string_view format) {
  return fmt::format(
      "ply\r\nformat {} 1.0\r\ncomment by hand\r\nelement vertex 3\r\nproperty float x\r\nproperty double y\r\n"
      "property list uchar short tags\r\nproperty short z\r\nelement face 1\r\nproperty uchar flag\r\n"
      "property list uchar int vertex_indices\r\nelement edge 1\r\nproperty int a\r\nend_header\r\n",
      format);
}

std::string binary_ply(bool big) {
  std::string out = ply_header(big ? "binary_big_endian" : "binary_little_endian");
  for (int i = 0; i < 3; ++i) {
    append(out, static_cast<float>(i) + 0.5f, big);
    append(out, i * 0.1, big);
    append(out, std::uint8_t{1});
    append(out, std::int16_t{77}, big);
    append(out, static_cast<std::int16_t>(-i * i), big);
  }
  append(out, std::uint8_t{200});
  append(out, std::uint8_t{3});
  for (const int i : {2, 0, 1}) append(out, i, big);
  append(out, 5, big);
  return out;
}

TEST(ReadPly, ReadsTheSameFromAllThreeEncodings) {
  const std::string ascii = ply_header("ascii") + "0.5 0 1 77 0\n1.5 0.1 1 77 -1\n2.5 0.2 1 77 -4\n200 3 2 0 1\n5\n";
  for (const std::string& bytes : {ascii, binary_ply(false), binary_ply(true)}) {
    const auto mesh = read("a.ply", bytes);
    EXPECT_THAT(faces_of(mesh), ElementsAre(ElementsAre(2, 0, 1)));
    EXPECT_EQ(mesh.points[VertexId(2)], Vec3(2.5, 0.2, -4));
  }
}

TEST(ReadPly, NamesThePlaceOfAMistake) {
  const std::string big = binary_ply(true);
  expect_refused("a.ply", big.substr(0, big.size() - 1), AllOf(HasSubstr("byte"), HasSubstr("more than the 3 bytes")));
  expect_refused("a.ply", big.substr(0, big.size() - 8), HasSubstr("'vertex_indices' is 3, more than"));
  expect_refused("a.ply", "plyx\n", HasSubstr("expected 'ply'"));
  expect_refused("a.ply", "ply\nformat ascii 1.0\nformat text 1.0\n", AllOf(HasSubstr(":3:"), HasSubstr("'text'")));
  expect_refused("a.ply", "ply\nhello\n", HasSubstr("a statement of a PLY header, found 'hello'"));
  expect_refused("a.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\nend_header\n",
                 HasSubstr("more than"));
  expect_refused("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1 2 3\n",
                 HasSubstr("no property 'y'"));
  expect_refused("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float128 x\n", HasSubstr("float128"));
  expect_refused("a.ply", "ply\nproperty float x\n", HasSubstr("before the first element"));
}

// VTK's two formats.

TEST(ReadVtk, ReadsLegacyAsciiWithPatchesBehindLines) {
  const auto mesh =
      read("a.vtk",
           "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0\n1 1 0 0 1 0\n"
           "METADATA\nINFORMATION 1\nNAME L2 LOCATION vtk\n\n"
           "LINES 1 3\n2 0 1\nPOLYGONS 1 4\n3 0 1 2\nTRIANGLE_STRIPS 1 5\n4 0 1 3 2\n"
           "POINT_DATA 4\nSCALARS s float 2\nLOOKUP_TABLE default\n1 2 3 4 5 6 7 8\nNORMALS n float\n"
           "0 0 1 0 0 1 0 0 1 0 0 1\nCELL_DATA 3\nFIELD FieldData 2\nother 1 3 float\n1 2 3\nPatchId 1 3 int\n9 4 2\n");
  EXPECT_THAT(faces_of(mesh), ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0, 1, 3), ElementsAre(1, 2, 3)));
  EXPECT_THAT(patch_of_faces(mesh), ElementsAre("patch4", "patch2", "patch2"));
  EXPECT_THAT(mesh.patch_names.raw(), ElementsAre("patch2", "patch4"));
}

TEST(ReadVtk, NamesThePlaceOfAMistake) {
  const std::string head = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET POLYDATA\n";
  expect_refused("a.vtk", "solid", HasSubstr("expected '# vtk DataFile Version'"));
  expect_refused("a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n",
                 HasSubstr("Extract Surface"));
  expect_refused("a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_GRID\n",
                 AllOf(HasSubstr(":4:"), HasSubstr("Extract Surface")));
  expect_refused("a.vtk", head + "POINTS 99999999999999 float\n0 0 0\n", HasSubstr("more than"));
  expect_refused("a.vtk", head + "POINTS 1 quad\n0 0 0\n", HasSubstr("found 'quad'"));
  expect_refused("a.vtk", head + "POINTS 1 float\n0 0 0\nPOLYGONS 1 4\n3 0 1 2\n", HasSubstr("point 1"));
  expect_refused("a.vtk", head + "POINTS 1 float\n0 0 0\nPOLYGONS 1 5\n3 0 0 0\n",
                 HasSubstr("4 entries, 5 were announced"));
  expect_refused("a.vtk", head + "POINTS 1 float\n0 0 0\nSURPRISE 1 5\n", HasSubstr("found 'SURPRISE'"));
}

constexpr std::string_view kVtpHead =
    "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">";

std::string ascii_vtp(std::string_view ends) {
  return fmt::format(
      "{}<!-- remark --><PolyData><Piece NumberOfPoints=\"4\" NumberOfLines=\"1\" NumberOfPolys='1'>"
      "<CellData><DataArray type=\"Int32\" Name=\"Patch\" format=\"ascii\">7 3</DataArray></CellData>"
      "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 1 1 0 0 1 "
      "0</DataArray></Points>"
      "<Lines><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1</DataArray>"
      "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">2</DataArray></Lines>"
      "<Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray>"
      "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">{}</DataArray></Polys></Piece></PolyData></VTKFile>",
      kVtpHead, ends);
}

TEST(ReadVtp, ReadsAsciiWithPatchesBehindLines) {
  const auto mesh = read("a.vtp", ascii_vtp("4"));
  EXPECT_THAT(faces_of(mesh), ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0, 2, 3)));
  EXPECT_THAT(patch_of_faces(mesh), ElementsAre("patch3", "patch3"));
}

TEST(ReadVtp, NamesThePlaceOfAMistake) {
  expect_refused("a.vtp", ascii_vtp("5"), HasSubstr("ends at 5 of 4"));
  expect_refused("a.vtp", ascii_vtp("2 4"), HasSubstr("NumberOfPolys is 1, but the arrays hold 2"));
  expect_refused("a.vtp", ascii_vtp("x"), AllOf(HasSubstr("byte"), HasSubstr("found 'x'")));
  expect_refused("a.vtp", "<html></html>", HasSubstr("no VTK XML file"));
  expect_refused("a.vtp", "<VTKFile type=\"UnstructuredGrid\"></VTKFile>", HasSubstr("'UnstructuredGrid'"));
  expect_refused("a.vtp", "<VTKFile type=\"PolyData\" compressor=\"vtkLZ4DataCompressor\">",
                 HasSubstr("save the file with zlib"));
  expect_refused("a.vtp", "<VTKFile type=\"PolyData\"", HasSubstr("does not end"));
  expect_refused("a.vtp", std::string(kVtpHead) + "<PolyData></Points>", HasSubstr("unexpected </Points>"));
  expect_refused("a.vtp",
                 std::string(kVtpHead) +
                     "<Piece><Points><DataArray type=\"Float64\" format=\"appended\" offset=\"77\"/>"
                     "</Points></Piece>",
                 HasSubstr("outside of the file"));
  expect_refused("a.vtp",
                 std::string(kVtpHead) +
                     "<Piece><Points><DataArray type=\"Float64\" format=\"appended\" offset=\"0\"/>"
                     "</Points></Piece><AppendedData encoding=\"raw\">_\xff\xff\xff\xff",
                 HasSubstr("cut off"));
}

}  // namespace
}  // namespace nearwall::io
