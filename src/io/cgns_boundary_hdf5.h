#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/cgns_tree_hdf5.h"
#include "io/mesh_builder.h"

namespace nearwall::io {

/// Numbers of elements or of points that a node names, as a range or a list, by any of the standard's ways.
class CgnsElements {
 public:
  CgnsElements() = default;
  /// \param node  with a child PointRange, PointList, ElementRange or ElementList
  explicit CgnsElements(const CgnsNode& node);

  bool contains(std::int64_t number) const;

 private:
  std::int64_t first_ = 1, last_ = 0;
  std::vector<std::int64_t> list_;  // ascending
};

/// The families of a base that stand for patches: those with a boundary condition.
class CgnsFamilies {
 public:
  explicit CgnsFamilies(const CgnsNode& base);
  std::vector<mesh::BoundaryPatch> patches() const;
  /// Null if there is none of that name.
  const mesh::BoundaryPatch* patch(const std::string& family) const;

 private:
  std::vector<std::string> order_;
  std::map<std::string, mesh::BoundaryPatch> patch_of_family_;
};

/// Triangles and quads of a zone, with the sections that they stand in.
class CgnsFaces {
 public:
  std::size_t add_section(const std::string& name);
  /// \param nodes  numbers in the builder
  void add(std::int64_t element, std::span<const std::int64_t> nodes, std::size_t section);
  /// Adds them to the boundary, in the patches that the boundary conditions of the zone say; those of none in one with
  /// the name of their section.
  void add_to(MeshBuilder& builder, const CgnsNode& zone, const CgnsFamilies& families, std::int64_t n_points);

 private:
  struct Face {
    std::int64_t element = 0;
    std::array<std::int64_t, 4> nodes{};
    std::uint8_t size = 3;
    std::uint32_t section = 0;
  };
  std::vector<std::string> sections_;
  std::vector<Face> faces_;
};

}  // namespace nearwall::io
