#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "nearwall/io/volume_reader.h"

namespace nearwall::io {

/// Collects what a reader finds of an unstructured grid, checks it and turns it into a volume mesh, in place: memory
/// is that of the mesh. For each piece: its points, types, ends and nodes, each in any number of runs, then end_piece.
class VolumeBuilder {
 public:
  /// \param file  its name, for messages
  explicit VolumeBuilder(std::string file) : file_(std::move(file)) { volume_.mesh.first_node.push_back(0); }

  /// \throws GeometryError, InputError  naming the point or cell by its number in the file, from 0
  void add_coordinates(std::span<const double> run);   ///< x y z of point after point
  void add_types(std::span<const std::int64_t> run);   ///< VTK's numbers
  void add_ends(std::span<const std::int64_t> run);    ///< where each cell's nodes end, counted from the piece's first
  void add_nodes(std::span<const std::int64_t> run);   ///< all points of the piece are there already
  void add_layers(std::span<const std::int64_t> run);  ///< of each cell of the piece; no layers at all: not known
  void end_piece();

  /// How many will be added, where that is known: saves memory.
  void expect_points(std::size_t more);
  void expect_cells(std::size_t more);
  void expect_nodes(std::size_t more);

  /// Numbers of the piece so far.
  std::size_t n_points() const { return volume_.mesh.points.size() - first_point_; }
  std::size_t n_types() const { return codes_.size(); }
  std::size_t n_ends() const { return volume_.mesh.first_node.size() - 1 - first_cell_; }
  std::size_t n_nodes() const { return volume_.mesh.nodes.size() - first_node_; }

  VolumeFile finish(std::vector<std::string> patch_names);

 private:
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void refuse(std::size_t cell, unsigned code) const;
  std::size_t cell_of_node(std::size_t node) const;
  void check_cells() const;

  std::string file_;
  VolumeFile volume_;
  // Of the piece that is being read. Its cells' ends stand in first_node, all its cells' nodes in nodes; end_piece
  // moves together what is kept.
  std::vector<std::uint8_t> codes_;
  std::vector<std::int32_t> layers_;
  std::size_t first_point_ = 0;
  std::size_t first_cell_ = 0;  // in the mesh
  std::uint64_t first_node_ = 0;
  std::uint64_t cells_before_ = 0;  // in the file
  std::size_t n_coordinates_ = 0;
};

}  // namespace nearwall::io
