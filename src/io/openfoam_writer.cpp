#include "nearwall/io/openfoam_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include "io/batches.h"
#include "io/format_limits.h"
#include "io/number_text.h"
#include "io/openfoam_text.h"
#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"
#include "nearwall/io/pending_file.h"
#include "nearwall/mesh/cell_faces.h"

namespace nearwall::io {
namespace {

using Label = std::int32_t;  // the header says label=32

constexpr CellIndex kNoOwner = ~CellIndex{0};

void append_raw(std::string& out, Label value) { out.append(reinterpret_cast<const char*>(&value), sizeof value); }

/// A label in a list of labels.
void append_label(std::string& out, FoamForm form, std::uint64_t value) {
  if (form == FoamForm::Binary) {
    append_raw(out, static_cast<Label>(value));
  } else {
    append_integers(out, std::span<const std::uint64_t>(&value, 1));
    out += '\n';
  }
}

/// The corners of a face in the list of faces.
void append_face(std::string& out, FoamForm form, const mesh::BoundaryFace& face) {
  const auto n = static_cast<std::size_t>(mesh::size_of(face));
  if (form == FoamForm::Binary) {
    for (std::size_t k = 0; k < n; ++k) append_raw(out, static_cast<Label>(face[k]));
  } else {
    out += n == 3 ? "3(" : "4(";
    append_integers(out, std::span<const NodeIndex>(face.data(), n));
    out += ")\n";
  }
}

/// What stands before and behind the items of a list. OpenFOAM expects no brackets round empty binary ones.
std::string list_begin(FoamForm form, std::uint64_t n) {
  if (form == FoamForm::Ascii) return fmt::format("{}\n(\n", n);
  return n == 0 ? "0\n" : fmt::format("{}\n(", n);
}
std::string list_end(FoamForm form, std::uint64_t n) { return form == FoamForm::Binary && n == 0 ? "" : ")\n"; }

/// A part of a file that grows while other parts of the same file do.
class FilePart {
 public:
  FilePart(PendingFile& file, std::uint64_t begin) : file_(&file), end_(begin) {}
  void append(std::string_view bytes) {
    file_->write_at(end_, bytes);
    end_ += bytes.size();
  }
  std::uint64_t end() const { return end_; }

 private:
  PendingFile* file_;
  std::uint64_t end_;
};

/// What a batch of cells, or some faces of the boundary, add to the files.
struct FaceBytes {
  std::string faces;
  std::vector<std::uint8_t> size;  // of each face
  std::string owner;
  std::string neighbour;
  std::string layer_cells;
  std::uint64_t n_layer_cells = 0;
  std::vector<std::pair<std::size_t, CellIndex>> boundary_owner;  // face of the boundary, its cell

  void add_face(FoamForm form, const mesh::BoundaryFace& face, CellIndex owner_cell) {
    append_face(faces, form, face);
    size.push_back(static_cast<std::uint8_t>(mesh::size_of(face)));
    append_label(owner, form, owner_cell);
  }
};

mesh::BoundaryFace nodes_of(const mesh::CellBatch& cells, std::size_t i, std::size_t face) {
  const mesh::CellFace& local = mesh::cell_faces(cells.type[i])[face];
  mesh::BoundaryFace nodes{0, 0, 0, mesh::kNoFourthNode};
  for (std::size_t k = 0; k < local.size; ++k) nodes[k] = cells.nodes[i][local.corners[k]];
  return nodes;
}

FaceBytes read_faces(const WholeMesh& mesh, FoamForm form, std::size_t batch) {
  mesh::CellBatch cells;
  mesh.cells.read_cells(batch, cells);
  mesh::NeighbourBatch behind;
  mesh.neighbours.read_neighbours(batch, cells, behind);
  FaceBytes bytes;
  std::vector<std::pair<CellIndex, std::size_t>> higher;  // neighbour, face
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const CellIndex cell = cells.first + i;
    higher.clear();
    for (std::size_t f = 0; f < mesh::cell_faces(cells.type[i]).size(); ++f) {
      if (!behind[i][f].is_cell()) {
        bytes.boundary_owner.emplace_back(behind[i][f].boundary_face(), cell);
      } else if (behind[i][f].cell() > cell) {
        higher.emplace_back(behind[i][f].cell(), f);
      }
    }
    std::sort(higher.begin(), higher.end());
    for (const auto& [neighbour, face] : higher) {
      bytes.add_face(form, nodes_of(cells, i, face), cell);
      append_label(bytes.neighbour, form, neighbour);
    }
    if (cells.layer[i] > 0) {
      append_label(bytes.layer_cells, form, cell);
      ++bytes.n_layer_cells;
    }
  }
  return bytes;
}

class FoamWriter {
 public:
  FoamWriter(const std::filesystem::path& folder, const WholeMesh& mesh, FoamForm form)
      : mesh_(mesh),
        form_(form),
        counts_(foam_counts(mesh)),
        points_file_(folder / "points"),
        faces_file_(folder / "faces"),
        owner_file_(folder / "owner"),
        neighbour_file_(folder / "neighbour"),
        boundary_file_(folder / "boundary"),
        cell_zones_file_(folder / "cellZones"),
        face_zones_file_(folder / "faceZones"),
        point_zones_file_(folder / "pointZones"),
        owner_of_(mesh.boundary.faces.size(), kNoOwner) {}

  void write(ProgressSink& progress) {
    write_points(progress);
    begin_faces();
    const std::size_t n_before = mesh_.cells.n_point_batches();
    in_batches(
        mesh_.cells.n_cell_batches(), [&](std::size_t batch) { return read_faces(mesh_, form_, batch); },
        [&](std::size_t batch, const FaceBytes& bytes) {
          add_cells(bytes);
          report(n_before + batch, progress);
        });
    expect(n_faces_ == counts_.n_internal_faces, "neighbours to agree with the counts of cells");
    write_boundary();
    end_faces();
    write_zones();
    for (PendingFile* file : {&points_file_, &faces_file_, &owner_file_, &neighbour_file_, &cell_zones_file_,
                              &face_zones_file_, &point_zones_file_, &boundary_file_}) {
      file->commit();
    }
  }

 private:
  static constexpr int kZoneCountWidth = 10;  // digits of the largest label

  void report(std::size_t batch, ProgressSink& progress) const {
    const std::size_t n = mesh_.cells.n_point_batches() + mesh_.cells.n_cell_batches();
    progress.update(static_cast<double>(batch + 1) / static_cast<double>(n));
  }

  void write_points(ProgressSink& progress) {
    points_file_.write(foam_header(form_, "vectorField", "points") + list_begin(form_, counts_.n_points));
    in_batches(
        mesh_.cells.n_point_batches(), [&](std::size_t batch) { return read_points(batch); },
        [&](std::size_t batch, const std::string& bytes) {
          points_file_.write(bytes);
          report(batch, progress);
        });
    points_file_.write(list_end(form_, counts_.n_points));
  }

  std::string read_points(std::size_t batch) const {
    mesh::PointBatch points;
    mesh_.cells.read_points(batch, points);
    std::string bytes;
    for (const Vec3& p : points.position) {
      if (form_ == FoamForm::Ascii) {
        bytes += '(';
        append_coordinates(bytes, p);
        bytes += ")\n";
      } else {
        const double xyz[] = {p.x(), p.y(), p.z()};
        bytes.append(reinterpret_cast<const char*>(xyz), sizeof xyz);
      }
    }
    return bytes;
  }

  /// Heads of the files that list faces.
  void begin_faces() {
    const std::string note = foam_note(counts_);
    owner_file_.write(foam_header(form_, "labelList", "owner", note) + list_begin(form_, counts_.n_faces));
    neighbour_file_.write(foam_header(form_, "labelList", "neighbour", note) +
                          list_begin(form_, counts_.n_internal_faces));
    const bool is_binary = form_ == FoamForm::Binary;
    FilePart faces(faces_file_, 0);
    faces.append(foam_header(form_, is_binary ? "faceCompactList" : "faceList", "faces"));
    if (is_binary) {
      faces.append(list_begin(form_, counts_.n_faces + 1));
      corner_ends_ = faces;
      std::string zero;
      append_raw(zero, 0);
      corner_ends_.append(zero);
      faces = FilePart(faces_file_, faces.end() + sizeof(Label) * (counts_.n_faces + 1));
      faces.append(list_end(form_, counts_.n_faces + 1));
    }
    faces.append(list_begin(form_, is_binary ? counts_.n_corners : counts_.n_faces));
    faces_ = faces;
  }

  void add_faces(const FaceBytes& bytes) {
    faces_.append(bytes.faces);
    owner_file_.write(bytes.owner);
    n_faces_ += bytes.size.size();
    if (form_ != FoamForm::Binary) return;
    std::string ends;
    for (const std::uint8_t size : bytes.size) append_raw(ends, static_cast<Label>(n_corners_ += size));
    corner_ends_.append(ends);
  }

  /// The head of the zone of layers, with room for the count, which is known at last.
  void begin_zone() {
    zone_.append(fmt::format("{}1\n(\n{}\n{{\n    type cellZone;\ncellLabels      List<label>\n",
                             foam_header(form_, "regIOobject", "cellZones"), kLayersGroup));
    zone_count_at_ = zone_.end();
    zone_.append(std::string(kZoneCountWidth, ' ') + (form_ == FoamForm::Binary ? "\n(" : "\n(\n"));
  }

  void add_cells(const FaceBytes& bytes) {
    add_faces(bytes);
    neighbour_file_.write(bytes.neighbour);
    if (bytes.n_layer_cells > 0) {
      if (n_layer_cells_ == 0) begin_zone();
      zone_.append(bytes.layer_cells);
      n_layer_cells_ += bytes.n_layer_cells;
    }
    for (const auto& [face, cell] : bytes.boundary_owner) {
      expect(face < owner_of_.size() && owner_of_[face] == kNoOwner, "each face of the boundary to have one cell");
      owner_of_[face] = cell;
    }
  }

  /// Patch after patch, in the order of the boundary within each.
  void write_boundary() {
    constexpr std::size_t kAtOnce = 65536;
    const mesh::Boundary& boundary = mesh_.boundary;
    IdVector<PatchId, std::uint64_t> n_faces(boundary.patches.size());
    const auto by_patch = mesh::faces_by_patch(boundary);
    for (const PatchId patch : boundary.patches.ids()) {
      const std::vector<std::uint32_t>& faces = by_patch[patch];
      n_faces[patch] = faces.size();
      for (std::size_t begin = 0; begin < faces.size(); begin += kAtOnce) {
        FaceBytes bytes;
        for (std::size_t i = begin; i < std::min(begin + kAtOnce, faces.size()); ++i) {
          expect(owner_of_[faces[i]] != kNoOwner, "each face of the boundary to have a cell");
          bytes.add_face(form_, boundary.faces[faces[i]], owner_of_[faces[i]]);
        }
        add_faces(bytes);
      }
    }
    boundary_file_.write(foam_boundary(form_, boundary.patches, n_faces, counts_.n_internal_faces));
  }

  void end_faces() {
    const bool is_binary = form_ == FoamForm::Binary;
    expect(n_faces_ == counts_.n_faces && (!is_binary || n_corners_ == counts_.n_corners), "all faces to be written");
    faces_.append(list_end(form_, counts_.n_faces));
    owner_file_.write(list_end(form_, counts_.n_faces));
    neighbour_file_.write(list_end(form_, counts_.n_internal_faces));
  }

  // Empty zones are written, too: those of another mesh in the same folder would name faces that are not there.
  void write_zones() {
    const auto write_none = [&](PendingFile& file, std::string_view object) {
      file.write(foam_header(form_, "regIOobject", object) + "0\n(\n)\n");
    };
    write_none(face_zones_file_, "faceZones");
    write_none(point_zones_file_, "pointZones");
    if (n_layer_cells_ == 0) {
      write_none(cell_zones_file_, "cellZones");
    } else {
      zone_.append(")\n;\n}\n)\n");
      cell_zones_file_.write_at(zone_count_at_, fmt::format("{:{}}", n_layer_cells_, kZoneCountWidth));
    }
  }

  const WholeMesh& mesh_;
  FoamForm form_;
  FoamCounts counts_;
  PendingFile points_file_, faces_file_, owner_file_, neighbour_file_, boundary_file_;
  PendingFile cell_zones_file_, face_zones_file_, point_zones_file_;
  FilePart corner_ends_{faces_file_, 0};  // of the faces, in one list of all their corners; binary only
  FilePart faces_{faces_file_, 0};
  FilePart zone_{cell_zones_file_, 0};
  std::uint64_t zone_count_at_ = 0;
  std::uint64_t n_faces_ = 0, n_corners_ = 0, n_layer_cells_ = 0;  // so far
  std::vector<CellIndex> owner_of_;                                // faces of the boundary
};

}  // namespace

void write_openfoam(const std::filesystem::path& folder, const WholeMesh& mesh, FoamForm form, ProgressSink* progress) {
  require_openfoam_limits(folder, mesh, form);
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw IoError(fmt::format("{}: the folder cannot be made: {}", folder.string(), failure.message()));
  FoamWriter(folder, mesh, form).write(progress ? *progress : silent_progress());
}

}  // namespace nearwall::io
