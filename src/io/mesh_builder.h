#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "io/cursor.h"
#include "nearwall/io/volume_reader.h"

namespace nearwall::io {

/// Collects cells, faces and patches that a reader of a mesh format finds, and checks them. For formats of surfaces and
/// of volumes alike: a surface is a mesh without cells.
class MeshBuilder {
 public:
  /// \param file  its name, for messages
  explicit MeshBuilder(std::string file);

  /// How many will be added, where that is known (and was held against the size of the file): saves memory.
  void expect_points(std::size_t n);
  void expect_cells(std::size_t n_cells, std::size_t n_nodes);

  /// \throws GeometryError at `where`  if a coordinate is not finite or there are too many points
  void add_point(const Vec3& point, const FilePosition& where);
  std::size_t n_points() const { return volume_.mesh.points.size(); }

  /// Nodes from 0, in the order of predicates/cells.h. Points may be added later: `finish` checks the numbers.
  /// \param file_cell  number of the cell in the file, for messages, from 0
  /// \param layer      1 at the wall, 0 outside of the layers or not known; 1 where it is known only to be in them
  /// \throws GeometryError at `where`  if a number is negative or too large for any mesh
  void add_cell(mesh::CellType type, std::span<const std::int64_t> nodes, std::uint64_t file_cell, std::int32_t layer,
                const FilePosition& where);

  /// The patch of that name, made with that type unless it is there.
  PatchId patch(std::string_view name, mesh::BoundaryType type = mesh::BoundaryType::Other);
  /// A triangle or quad of the boundary. \throws GeometryError at `where`
  void add_face(PatchId patch, std::span<const std::int64_t> nodes, const FilePosition& where);

  /// Cells of other dimensions that are passed over.
  SkippedCells& skipped() { return volume_.skipped; }

  /// \throws GeometryError  naming the first cell or face that has a node which the file has not
  VolumeFile finish();

 private:
  NodeIndex checked_node(std::int64_t node, const FilePosition& where) const;

  std::string file_;
  VolumeFile volume_;
  std::map<std::string, PatchId, std::less<>> patch_of_name_;
};

}  // namespace nearwall::io
