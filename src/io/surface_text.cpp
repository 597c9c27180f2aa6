#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>

#include "io/cursor.h"
#include "io/surface_formats.h"
#include "nearwall/core/errors.h"

// The doubles of text formats are printed with as many digits as it takes to read the same double back.

namespace nearwall::io {
namespace {

static_assert(std::endian::native == std::endian::little, "binary files are written in the machine's own byte order");

template <class T>
void append(std::string& out, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  out.append(raw, sizeof(T));
}

void append_point(std::string& out, std::string_view before, const Vec3& p) {
  fmt::format_to(std::back_inserter(out), "{}{} {} {}\n", before, p.x(), p.y(), p.z());
}

Vec3 face_normal(const mesh::SurfaceMesh& mesh, FaceId f) {
  const auto [a, b, c] = mesh.triangle(f);
  return normalized(cross(b - a, c - a));
}

void append_single(std::string& out, const Vec3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    const float value = static_cast<float>(p[axis]);
    if (!std::isfinite(value)) {
      throw InputError(
          fmt::format("coordinate {} is too large for the single precision of binary STL; write obj or ply", p[axis]));
    }
    append(out, value);
  }
}

std::string binary_stl(const mesh::SurfaceMesh& mesh) {
  constexpr std::size_t kHeaderBytes = 80, kTriangleBytes = 50;
  std::string out = "nearwall, binary STL";
  out.resize(kHeaderBytes, ' ');
  out.reserve(kHeaderBytes + sizeof(std::uint32_t) + kTriangleBytes * mesh.faces.size());
  append(out, static_cast<std::uint32_t>(mesh.faces.size()));
  for (const FaceId f : mesh.faces.ids()) {
    append_single(out, face_normal(mesh, f));
    for (const Vec3& p : mesh.triangle(f)) append_single(out, p);
    append(out, std::uint16_t{0});
  }
  return out;
}

/// Words of ascii VTK files: blanks, controls, '%' and '"' as %XX.
std::string percent_encoded(std::string_view text) {
  std::string out;
  for (const unsigned char c : text) {
    if (c <= 0x20 || c >= 0x7f || c == '%' || c == '"') {
      out += fmt::format("%{:02X}", c);
    } else {
      out += static_cast<char>(c);
    }
  }
  return out;
}

}  // namespace

std::string format_stl(const mesh::SurfaceMesh& mesh) {
  if (mesh.patch_names.size() <= 1) return binary_stl(mesh);
  std::vector<std::string> solids(mesh.patch_names.size());
  for (const FaceId f : mesh.faces.ids()) {
    std::string& out = solids[mesh.face_patch[f].index()];
    append_point(out, "facet normal ", face_normal(mesh, f));
    out += "outer loop\n";
    for (const Vec3& p : mesh.triangle(f)) append_point(out, "vertex ", p);
    out += "endloop\nendfacet\n";
  }
  std::string all;
  for (const PatchId patch : mesh.patch_names.ids()) {
    const std::string& name = mesh.patch_names[patch];
    all += fmt::format("solid {}\n{}endsolid {}\n", name, solids[patch.index()], name);
  }
  return all;
}

std::string format_obj(const mesh::SurfaceMesh& mesh) {
  std::string out;
  for (const Vec3& p : mesh.points) append_point(out, "v ", p);
  for (const std::string& name : mesh.patch_names)
    out += fmt::format("g {}\n", name);  // keeps the order of the patches
  PatchId patch;
  for (const FaceId f : mesh.faces.ids()) {
    if (mesh.face_patch[f] != patch) {
      patch = mesh.face_patch[f];
      out += fmt::format("g {}\n", mesh.patch_names[patch]);
    }
    const auto& v = mesh.faces[f];
    fmt::format_to(std::back_inserter(out), "f {} {} {}\n", v[0].index() + 1, v[1].index() + 1, v[2].index() + 1);
  }
  return out;
}

std::string format_ply(const mesh::SurfaceMesh& mesh) {
  std::string out = "ply\nformat binary_little_endian 1.0\n";
  for (const PatchId patch : mesh.patch_names.ids()) {
    out += fmt::format("comment patch {} {}\n", patch.index(), mesh.patch_names[patch]);
  }
  out += fmt::format(
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "element face {}\nproperty list uchar uint vertex_indices\nproperty int patch\nend_header\n",
      mesh.points.size(), mesh.faces.size());
  for (const Vec3& p : mesh.points) {
    for (int axis = 0; axis < 3; ++axis) append(out, p[axis]);
  }
  for (const FaceId f : mesh.faces.ids()) {
    append(out, std::uint8_t{3});
    for (const VertexId v : mesh.faces[f]) append(out, v.index());
    append(out, static_cast<std::int32_t>(mesh.face_patch[f].index()));
  }
  return out;
}

std::string format_off(const mesh::SurfaceMesh& mesh) {
  std::string out = fmt::format("OFF\n{} {} 0\n", mesh.points.size(), mesh.faces.size());
  for (const Vec3& p : mesh.points) append_point(out, "", p);
  for (const auto& v : mesh.faces) {
    fmt::format_to(std::back_inserter(out), "3 {} {} {}\n", v[0].index(), v[1].index(), v[2].index());
  }
  return out;
}

std::string format_legacy_vtk(const mesh::SurfaceMesh& mesh) {
  std::string out = "# vtk DataFile Version 3.0\nnearwall\nASCII\nDATASET POLYDATA\nFIELD FieldData 1\n";
  out += fmt::format("PatchNames 1 {} string\n", mesh.patch_names.size());
  for (const std::string& name : mesh.patch_names) out += percent_encoded(name) + '\n';
  out += fmt::format("POINTS {} double\n", mesh.points.size());
  for (const Vec3& p : mesh.points) append_point(out, "", p);
  out += fmt::format("POLYGONS {} {}\n", mesh.faces.size(), 4 * mesh.faces.size());
  for (const auto& v : mesh.faces) {
    fmt::format_to(std::back_inserter(out), "3 {} {} {}\n", v[0].index(), v[1].index(), v[2].index());
  }
  out += fmt::format("CELL_DATA {}\nSCALARS Patch int 1\nLOOKUP_TABLE default\n", mesh.faces.size());
  for (const PatchId patch : mesh.face_patch) out += fmt::format("{}\n", patch.index());
  return out;
}

}  // namespace nearwall::io
