#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "io/file_bytes.h"
#include "io/mesh_builder.h"
#include "io/openfoam_cells.h"
#include "io/openfoam_folder.h"
#include "io/openfoam_input.h"
#include "io/volume_formats.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/whole_mesh.h"

namespace nearwall::io {
namespace {

using mesh::BoundaryType;
using mesh::FaceNodes;

/// Faces of any number of corners.
struct Faces {
  std::vector<std::uint64_t> first{0};  // (n_faces + 1)
  std::vector<std::uint32_t> corners;

  std::size_t size() const { return first.size() - 1; }
  std::span<const std::uint32_t> operator[](std::size_t f) const {
    return {corners.data() + first[f], corners.data() + first[f + 1]};
  }
};

std::uint32_t checked_point(const FoamInput& in, std::int64_t label, std::size_t n_points) {
  if (label < 0 || static_cast<std::uint64_t>(label) >= n_points) {
    in.fail(fmt::format("face with point {} (counted from 0), but there are {} points", label, n_points));
  }
  return static_cast<std::uint32_t>(label);
}

void require_corners(const FoamInput& in, std::size_t face, std::uint64_t n) {
  if (n < 3) in.fail(fmt::format("expected face {} to have 3 points or more, found {}", face, n));
}

Faces read_compact_faces(FoamInput& in, std::size_t n_points) {
  Faces faces;
  faces.first.clear();
  in.read_labels("number of offsets of faces", 0, [&](std::int64_t offset) {
    const std::uint64_t last = faces.first.empty() ? 0 : faces.first.back();
    if (offset < 0 || static_cast<std::uint64_t>(offset) < last || (faces.first.empty() && offset != 0)) {
      in.fail(fmt::format("expected offsets of faces from 0 on and ascending, found {} behind {}", offset, last));
    }
    if (!faces.first.empty()) require_corners(in, faces.first.size() - 1, static_cast<std::uint64_t>(offset) - last);
    faces.first.push_back(static_cast<std::uint64_t>(offset));
  });
  if (faces.first.empty()) faces.first.push_back(0);
  in.read_labels("number of points of all faces", 0,
                 [&](std::int64_t label) { faces.corners.push_back(checked_point(in, label, n_points)); });
  if (faces.corners.size() != faces.first.back()) {
    in.fail(fmt::format("expected {} points of all faces, as the offsets tell, found {}", faces.first.back(),
                        faces.corners.size()));
  }
  return faces;
}

Faces read_faces(const FoamFile& file, std::size_t n_points) {
  FoamInput in(file.bytes, file.name);
  if (in.foam_class() == "faceCompactList") return read_compact_faces(in, n_points);
  if (in.foam_class() != "faceList") {
    in.fail(fmt::format("expected class faceList or faceCompactList, found '{}'", io::quoted(in.foam_class())));
  }
  Faces faces;
  in.read_items("number of faces", [&](std::size_t f) {
    in.read_labels("number of points of a face", 0,
                   [&](std::int64_t label) { faces.corners.push_back(checked_point(in, label, n_points)); });
    require_corners(in, f, faces.corners.size() - faces.first.back());
    faces.first.push_back(faces.corners.size());
  });
  return faces;
}

/// Cells on the two sides of the faces.
struct Sides {
  std::vector<std::uint32_t> owner;      // (n_faces)
  std::vector<std::uint32_t> neighbour;  // of the faces inside, which come first
  std::size_t n_cells = 0;
};

std::vector<std::uint32_t> read_cell_labels(const FoamFile& file, std::size_t most, std::size_t n_faces) {
  FoamInput in(file.bytes, file.name);
  std::vector<std::uint32_t> cells;
  in.read_labels("number of faces", most, [&](std::int64_t cell) {
    // A cell has four faces or more, a face two cells or fewer.
    if (cell < 0 || static_cast<std::uint64_t>(cell) >= n_faces) {
      in.fail(fmt::format("face {}: {} is no number of a cell of a mesh with {} faces", cells.size(), cell, n_faces));
    }
    if (cells.size() == most) in.fail(fmt::format("expected cells of at most {} faces, found more", most));
    cells.push_back(static_cast<std::uint32_t>(cell));
  });
  return cells;
}

Sides read_sides(const FoamSource& open, std::size_t n_faces) {
  Sides sides;
  const FoamFile owner = open("owner");
  sides.owner = read_cell_labels(owner, n_faces, n_faces);
  if (sides.owner.size() != n_faces) {
    throw GeometryError(
        fmt::format("{}: expected one cell for each of {} faces, found {}", owner.name, n_faces, sides.owner.size()));
  }
  sides.neighbour = read_cell_labels(open("neighbour"), n_faces, n_faces);
  for (const auto* cells : {&sides.owner, &sides.neighbour}) {
    for (const std::uint32_t cell : *cells) sides.n_cells = std::max<std::size_t>(sides.n_cells, cell + std::size_t{1});
  }
  return sides;
}

/// Faces of each cell: those that it owns, and those that it is the neighbour of, by number.
struct CellFaces {
  std::vector<std::uint64_t> first;  // (n_cells + 1)
  std::vector<std::uint32_t> faces;

  explicit CellFaces(const Sides& sides) : first(sides.n_cells + 1, 0) {
    for (const auto* cells : {&sides.owner, &sides.neighbour}) {
      for (const std::uint32_t cell : *cells) ++first[cell + 1];
    }
    for (std::size_t c = 0; c < sides.n_cells; ++c) first[c + 1] += first[c];
    faces.resize(first.back());
    std::vector<std::uint64_t> next(first.begin(), first.end() - 1);
    for (std::size_t f = 0; f < sides.owner.size(); ++f) {
      faces[next[sides.owner[f]]++] = static_cast<std::uint32_t>(f);
      if (f < sides.neighbour.size()) faces[next[sides.neighbour[f]]++] = static_cast<std::uint32_t>(f);
    }
  }
  std::span<const std::uint32_t> operator[](std::size_t cell) const {
    return {faces.data() + first[cell], faces.data() + first[cell + 1]};
  }
};

class CellsOfFaces {
 public:
  CellsOfFaces(const Faces& faces, const Sides& sides, std::string folder)
      : faces_(faces), sides_(sides), faces_of_(sides), folder_(std::move(folder)) {}

  void add_to(MeshBuilder& builder, const std::vector<char>& in_layers) const {
    std::size_t n_polyhedra = 0, first_polyhedron = 0;
    for (std::size_t c = 0; c < sides_.n_cells; ++c) {
      bool is_closed = true;
      const std::optional<FacedCell> cell = cell_at(c, is_closed);
      if (!is_closed) fail(c, "its faces do not all point away from it, or into it as neighbour");
      if (!cell) {
        if (n_polyhedra++ == 0) first_polyhedron = c;
        continue;
      }
      std::array<std::int64_t, 8> nodes{};
      std::copy(cell->nodes.begin(), cell->nodes.end(), nodes.begin());
      builder.add_cell(cell->type, nodes, c, in_layers[c], {folder_, true, 0});
    }
    if (n_polyhedra == 0) return;
    throw InputError(
        fmt::format("{}: cell {} is a polyhedron with {} faces, and {} more of {} cells are polyhedra; expected "
                    "tetrahedra, pyramids, wedges and hexahedra; `foamToVTK -poly-decomp` divides the others",
                    folder_, first_polyhedron, faces_of_[first_polyhedron].size(), n_polyhedra - 1, sides_.n_cells));
  }

 private:
  [[noreturn]] void fail(std::size_t cell, std::string_view what) const {
    throw GeometryError(fmt::format("{}: cell {}: {}", folder_, cell, what));
  }

  std::optional<FacedCell> cell_at(std::size_t c, bool& is_closed) const {
    constexpr std::size_t kMostFaces = 6;
    const auto numbers = faces_of_[c];
    if (numbers.size() < 4) fail(c, fmt::format("expected 4 faces or more, found {}", numbers.size()));
    if (numbers.size() > kMostFaces) return std::nullopt;
    std::array<FaceNodes, kMostFaces> outward;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const auto corners = faces_[numbers[i]];
      if (corners.size() > 4) return std::nullopt;
      outward[i] = {0, 0, 0, mesh::kNoNode};
      std::copy(corners.begin(), corners.end(), outward[i].begin());
      if (sides_.owner[numbers[i]] != c) std::reverse(outward[i].begin(), outward[i].begin() + corners.size());
    }
    return cell_of({outward.data(), numbers.size()}, is_closed);
  }

  const Faces& faces_;
  const Sides& sides_;
  CellFaces faces_of_;
  std::string folder_;
};

/// One patch of the file `boundary`.
struct PatchEntry {
  std::string name;
  std::string type;
  std::vector<std::string> groups;
  std::int64_t n_faces = -1;
  std::int64_t start = -1;
};

/// \pre  the key inGroups was read: N(a b), (a b) or List<word> N(a b), and a semicolon
std::vector<std::string> read_groups(FoamInput& in) {
  std::vector<std::string> groups;
  for (std::string_view token = in.token(); token != ";"; token = in.token()) {
    if (token.empty()) in.fail("expected ';', found the end of the file");
    if (token != "(" && token != ")") groups.emplace_back(FoamInput::unquoted(token));
  }
  return groups;
}

PatchEntry read_patch(FoamInput& in) {
  PatchEntry patch;
  patch.name = FoamInput::unquoted(in.token());
  in.expect_token("{");
  for (std::string_view key = in.token(); key != "}"; key = in.token()) {
    if (key.empty()) in.fail("expected '}', found the end of the file");
    if (key == "inGroups") {
      patch.groups = read_groups(in);
      continue;
    }
    if (key == "type") {
      patch.type = in.token();
    } else if (key == "nFaces") {
      patch.n_faces = in.integer("nFaces");
    } else if (key == "startFace") {
      patch.start = in.integer("startFace");
    } else {
      in.skip_value();
      continue;
    }
    in.expect_token(";");
  }
  return patch;
}

BoundaryType type_of(const PatchEntry& patch) {
  if (patch.type == "wall" || patch.type == "mappedWall") return BoundaryType::Wall;
  if (patch.type == "symmetry" || patch.type == "symmetryPlane") return BoundaryType::Symmetry;
  for (const BoundaryType type : {BoundaryType::Inlet, BoundaryType::Outlet, BoundaryType::FarField}) {
    const std::string_view name = mesh::name_of(type);
    if (patch.name == name || std::find(patch.groups.begin(), patch.groups.end(), name) != patch.groups.end()) {
      return type;
    }
  }
  return BoundaryType::Other;
}

void read_boundary(const FoamFile& file, const Faces& faces, std::size_t n_internal_faces, MeshBuilder& builder) {
  FoamInput in(file.bytes, file.name);
  auto start = static_cast<std::int64_t>(n_internal_faces);
  in.read_items("number of patches", [&](std::size_t) {
    const PatchEntry patch = read_patch(in);
    const auto left = static_cast<std::int64_t>(faces.size()) - start;
    if (patch.n_faces < 0 || patch.n_faces > left || (patch.n_faces > 0 && patch.start != start)) {
      in.fail(fmt::format("patch '{}': expected startFace {} and nFaces from 0 to {}, found {} and {}",
                          io::quoted(patch.name), start, left, patch.start, patch.n_faces));
    }
    const PatchId id = builder.patch(patch.name, type_of(patch));
    for (const std::int64_t end = start + patch.n_faces; start < end; ++start) {
      const auto corners = faces[static_cast<std::size_t>(start)];
      const std::vector<std::int64_t> nodes(corners.begin(), corners.end());
      builder.add_face(id, nodes, in.position());
    }
  });
}

/// Whether each cell is in the zone of layers.
std::vector<char> read_layers(const FoamFile& file, std::size_t n_cells) {
  std::vector<char> in_layers(n_cells, 0);
  if (file.bytes.empty()) return in_layers;
  FoamInput in(file.bytes, file.name);
  in.read_items("number of zones", [&](std::size_t) {
    const bool is_layers = FoamInput::unquoted(in.token()) == kLayersGroup;
    in.expect_token("{");
    for (std::string_view key = in.token(); key != "}"; key = in.token()) {
      if (key.empty()) in.fail("expected '}', found the end of the file");
      if (key != "cellLabels") {
        in.skip_value();
        continue;
      }
      in.pass_token("List<label>");
      in.read_labels("number of cells", n_cells, [&](std::int64_t cell) {
        if (cell < 0 || static_cast<std::uint64_t>(cell) >= n_cells) {
          in.fail(fmt::format("cell {} (counted from 0) in a zone, but there are {} cells", cell, n_cells));
        }
        if (is_layers) in_layers[static_cast<std::size_t>(cell)] = 1;
      });
      in.expect_token(";");
    }
  });
  return in_layers;
}

void read_points(const FoamFile& file, MeshBuilder& builder) {
  FoamInput in(file.bytes, file.name);
  in.read_points([&](std::size_t n) { builder.expect_points(n); },
                 [&](const Vec3& point) { builder.add_point(point, in.position()); });
}

}  // namespace

VolumeFile parse_openfoam(const FoamSource& open, const std::string& folder) {
  MeshBuilder builder(folder);
  read_points(open("points"), builder);
  const Faces faces = read_faces(open("faces"), builder.n_points());
  const Sides sides = read_sides(open, faces.size());
  CellsOfFaces(faces, sides, folder).add_to(builder, read_layers(open("cellZones"), sides.n_cells));
  read_boundary(open("boundary"), faces, sides.neighbour.size(), builder);
  return builder.finish();
}

}  // namespace nearwall::io
