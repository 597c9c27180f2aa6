#pragma once

#include <fmt/format.h>

#include <string>

#include "nearwall/mesh/surface_mesh.h"

/// Surfaces as other programs write them into files of meshes: text of solvers' formats without a cell.
namespace nearwall::surface_files_for_tests {

using mesh::SurfaceMesh;

/// "3 4 7" for each triangle of a patch, behind `head`, from `first` on.
inline std::string triangles(const SurfaceMesh& surface, PatchId patch, const std::string& head, int first) {
  std::string text;
  for (const FaceId f : surface.faces.ids()) {
    if (surface.face_patch[f] != patch) continue;
    text += head;
    for (const VertexId v : surface.faces[f]) text += fmt::format(" {}", v.index() + static_cast<std::size_t>(first));
    text += '\n';
  }
  return text;
}

inline std::size_t n_faces(const SurfaceMesh& surface, PatchId patch) {
  std::size_t n = 0;
  for (const PatchId p : surface.face_patch) n += p == patch ? 1 : 0;
  return n;
}

inline std::string coordinates(const SurfaceMesh& surface) {
  std::string text;
  for (const Vec3& p : surface.points) text += fmt::format("{} {} {}\n", p.x(), p.y(), p.z());
  return text;
}

inline std::string su2(const SurfaceMesh& surface) {
  std::string text = fmt::format("NDIME= 3\nNELEM= 0\nNPOIN= {}\n{}NMARK= {}\n", surface.points.size(),
                                 coordinates(surface), surface.patch_names.size());
  for (const PatchId p : surface.patch_names.ids()) {
    text += fmt::format("MARKER_TAG= {}\nMARKER_ELEMS= {}\n{}", surface.patch_names[p], n_faces(surface, p),
                        triangles(surface, p, "5", 0));
  }
  return text;
}

/// Patches in the order of the triangles; their names stand in `mapbc`.
inline std::string ugrid(const SurfaceMesh& surface) {
  std::string text =
      fmt::format("{} {} 0 0 0 0 0\n{}", surface.points.size(), surface.faces.size(), coordinates(surface));
  for (const PatchId p : surface.patch_names.ids()) text += triangles(surface, p, "", 1);
  for (const PatchId p : surface.patch_names.ids()) {
    for (std::size_t i = 0; i < n_faces(surface, p); ++i) text += fmt::format("{}\n", p.index() + 1);
  }
  return text;
}

inline std::string mapbc(const SurfaceMesh& surface) {
  std::string text = fmt::format("{}\n", surface.patch_names.size());
  for (const PatchId p : surface.patch_names.ids()) {
    text += fmt::format("{} 4000 {}\n", p.index() + 1, surface.patch_names[p]);
  }
  return text;
}

inline std::string physical_names(const SurfaceMesh& surface) {
  std::string text = fmt::format("$PhysicalNames\n{}\n", surface.patch_names.size());
  for (const PatchId p : surface.patch_names.ids()) {
    text += fmt::format("2 {} \"{}\"\n", p.index() + 1, surface.patch_names[p]);
  }
  return text + "$EndPhysicalNames\n";
}

inline std::string msh22(const SurfaceMesh& surface) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + physical_names(surface);
  text += fmt::format("$Nodes\n{}\n", surface.points.size());
  for (const VertexId v : surface.points.ids()) {
    const Vec3& p = surface.points[v];
    text += fmt::format("{} {} {} {}\n", v.index() + 1, p.x(), p.y(), p.z());
  }
  text += fmt::format("$EndNodes\n$Elements\n{}\n", surface.faces.size());
  std::size_t number = 0;
  for (const PatchId p : surface.patch_names.ids()) {
    for (const FaceId f : surface.faces.ids()) {
      if (surface.face_patch[f] != p) continue;
      const auto& v = surface.faces[f];
      text += fmt::format("{} 2 2 {} {} {} {} {}\n", ++number, p.index() + 1, p.index() + 11, v[0].index() + 1,
                          v[1].index() + 1, v[2].index() + 1);
    }
  }
  return text + "$EndElements\n";
}

inline std::string msh41(const SurfaceMesh& surface) {
  const std::size_t n = surface.points.size();
  std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + physical_names(surface);
  text += fmt::format("$Entities\n0 0 {} 0\n", surface.patch_names.size());
  for (const PatchId p : surface.patch_names.ids()) {
    text += fmt::format("{} -9 -9 -9 9 9 9 1 {} 0\n", p.index() + 11, p.index() + 1);
  }
  text += fmt::format("$EndEntities\n$Nodes\n1 {} 1 {}\n2 11 0 {}\n", n, n, n);
  for (std::size_t i = 1; i <= n; ++i) text += fmt::format("{}\n", i);
  text += coordinates(surface) + "$EndNodes\n";
  text +=
      fmt::format("$Elements\n{} {} 1 {}\n", surface.patch_names.size(), surface.faces.size(), surface.faces.size());
  std::size_t number = 0;
  for (const PatchId p : surface.patch_names.ids()) {
    text += fmt::format("2 {} 2 {}\n", p.index() + 11, n_faces(surface, p));
    for (const FaceId f : surface.faces.ids()) {
      if (surface.face_patch[f] != p) continue;
      const auto& v = surface.faces[f];
      text += fmt::format("{} {} {} {}\n", ++number, v[0].index() + 1, v[1].index() + 1, v[2].index() + 1);
    }
  }
  return text + "$EndElements\n";
}

/// Coordinates with three decimals.
inline std::string nastran(const SurfaceMesh& surface) {
  std::string text = "BEGIN BULK\n";
  for (const PatchId p : surface.patch_names.ids()) {
    text += fmt::format("$ANSA_NAME_COMMENT;{};PSHELL;{};\n", p.index() + 1, surface.patch_names[p]);
  }
  for (const VertexId v : surface.points.ids()) {
    const Vec3& p = surface.points[v];
    text += fmt::format("GRID,{},,{:.3f},{:.3f},{:.3f}\n", v.index() + 1, p.x(), p.y(), p.z());
  }
  std::size_t number = 0;
  for (const PatchId p : surface.patch_names.ids()) {
    for (const FaceId f : surface.faces.ids()) {
      if (surface.face_patch[f] != p) continue;
      const auto& v = surface.faces[f];
      text += fmt::format("CTRIA3,{},{},{},{},{}\n", ++number, p.index() + 1, v[0].index() + 1, v[1].index() + 1,
                          v[2].index() + 1);
    }
  }
  return text + "ENDDATA\n";
}

}  // namespace nearwall::surface_files_for_tests
