#include "io/openfoam_text.h"

#include <fmt/format.h>

#include <bit>
#include <set>

#include "io/boundary_output.h"
#include "nearwall/core/expect.h"
#include "nearwall/mesh/cell_faces.h"

namespace nearwall::io {
namespace {

using mesh::BoundaryPatch;
using mesh::BoundaryType;

constexpr bool kIsBigEndian = std::endian::native == std::endian::big;  // numbers stand as in memory

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// OpenFOAM's own rule forbids blanks, quotes, '/', ';' and braces only; but its reader takes some other characters for
// operators, variables or numbers where they stand first.
std::string word_of(std::string_view name) {
  std::string word;
  for (const char c : name) {
    constexpr unsigned kContinuation = 0x80;  // of a character of several bytes in UTF-8: one '_' for all of them
    if ((static_cast<unsigned char>(c) & 0xc0u) == kContinuation) continue;
    word += is_letter(c) || is_digit(c) || c == '_' || c == '-' || c == '.' ? c : '_';
  }
  if (word.empty() || !(is_letter(word[0]) || word[0] == '_')) word.insert(word.begin(), '_');
  return word;
}

std::string_view foam_type(BoundaryType type) {
  switch (type) {
    case BoundaryType::Wall:
      return "wall";
    case BoundaryType::Symmetry:
      return "symmetry";
    default:
      return "patch";
  }
}

}  // namespace

FoamCounts foam_counts(const WholeMesh& mesh) {
  FoamCounts counts;
  counts.n_points = mesh.cells.n_points();
  counts.n_cells = mesh.cells.n_cells();
  std::uint64_t n_sides = 0, n_side_corners = 0;  // each internal face twice
  const auto n_by_type = mesh.cells.n_cells_by_type();
  for (std::size_t type = 0; type < n_by_type.size(); ++type) {
    for (const mesh::CellFace& face : mesh::cell_faces(static_cast<mesh::CellType>(type))) {
      n_sides += n_by_type[type];
      n_side_corners += face.size * n_by_type[type];
    }
  }
  const std::uint64_t n_boundary = mesh.boundary.faces.size();
  std::uint64_t n_boundary_corners = 0;
  for (const mesh::BoundaryFace& face : mesh.boundary.faces) {
    n_boundary_corners += static_cast<std::uint64_t>(mesh::size_of(face));
  }
  expect(n_sides >= n_boundary && (n_sides - n_boundary) % 2 == 0, "each face inside to be one of two cells");
  counts.n_internal_faces = (n_sides - n_boundary) / 2;
  counts.n_faces = counts.n_internal_faces + n_boundary;
  counts.n_corners = (n_side_corners - n_boundary_corners) / 2 + n_boundary_corners;
  return counts;
}

std::string foam_header(FoamForm form, std::string_view foam_class, std::string_view object, std::string_view note) {
  std::string text = fmt::format(
      "FoamFile\n{{\n    version     2.0;\n    format      {};\n    class       {};\n"
      "    arch        \"{};label=32;scalar=64\";\n",
      form == FoamForm::Binary ? "binary" : "ascii", foam_class, kIsBigEndian ? "MSB" : "LSB");
  if (!note.empty()) text += fmt::format("    note        \"{}\";\n", note);
  return text + fmt::format("    location    \"constant/polyMesh\";\n    object      {};\n}}\n\n", object);
}

std::string foam_note(const FoamCounts& counts) {
  return fmt::format("nPoints:{}  nCells:{}  nFaces:{}  nInternalFaces:{}", counts.n_points, counts.n_cells,
                     counts.n_faces, counts.n_internal_faces);
}

IdVector<PatchId, std::string> foam_names(const IdVector<PatchId, BoundaryPatch>& patches) {
  return unique_names(patches, word_of, {});
}

std::string foam_boundary(FoamForm form, const IdVector<PatchId, BoundaryPatch>& patches,
                          const IdVector<PatchId, std::uint64_t>& n_faces, std::uint64_t n_internal_faces) {
  const auto names = foam_names(patches);
  const std::set<std::string> all_names(names.begin(), names.end());
  std::string entries;
  std::size_t n_entries = 0;
  std::uint64_t start = n_internal_faces;
  for (const PatchId patch : patches.ids()) {
    if (n_faces[patch] == 0) continue;
    const BoundaryType type = patches[patch].type;
    entries += fmt::format("    {}\n    {{\n        type            {};\n", names[patch], foam_type(type));
    // OpenFOAM warns of groups that bear the name of a patch.
    const std::string group(name_of(type));
    if (type != BoundaryType::Other && !all_names.contains(group)) {
      entries += fmt::format("        inGroups        1({});\n", group);
    }
    entries += fmt::format("        nFaces          {};\n        startFace       {};\n    }}\n", n_faces[patch], start);
    start += n_faces[patch];
    ++n_entries;
  }
  return foam_header(form, "polyBoundaryMesh", "boundary") + fmt::format("{}\n(\n{})\n", n_entries, entries);
}

}  // namespace nearwall::io
