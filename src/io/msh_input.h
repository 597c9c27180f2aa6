#pragma once

#include <bit>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "io/cursor.h"
#include "io/mesh_builder.h"
#include "io/msh_format.h"
#include "io/node_tags.h"

namespace nearwall::io {

/// Values of a file in Gmsh's format, as text or in binary of either byte order.
class MshInput {
 public:
  /// Reads the section $MeshFormat.
  /// \throws GeometryError, InputError  another version than 2.x and 4.1
  MshInput(std::string_view bytes, const std::string& file);

  bool is_version_4() const { return is_version_4_; }
  bool is_binary() const { return is_binary_; }
  Cursor& cursor() { return cursor_; }

  /// The next `$Name`, without the dollar; empty at the end of the file. Its line is passed.
  std::string_view next_section();
  /// Reads `$EndName`.
  void end_section(std::string_view name);
  /// Goes behind `$EndName`, whatever stands before.
  void pass_section(std::string_view name);

  /// A number with 32 bits: tags of entities and groups, codes, in version 2 all.
  std::int64_t tag(std::string_view what);
  /// A number of version 4, 64 bits: tags of nodes and elements, counts. \throws GeometryError  if it is negative
  std::int64_t number(std::string_view what);
  double real(std::string_view what);
  Vec3 point();
  /// A count of items that take at least so many bytes each, in text and in binary.
  std::size_t count(std::string_view what, std::size_t bytes_in_text, std::size_t bytes_in_binary);

 private:
  void read_format();

  Cursor cursor_;
  bool is_version_4_ = false;
  bool is_binary_ = false;
  std::endian order_ = std::endian::native;
};

/// What elements of an entity belong to.
struct MshGroup {
  PatchId patch;  ///< of faces
  std::int32_t layer = 0;
};

/// Collects what the sections of both versions hold.
class MshContent {
 public:
  explicit MshContent(const std::string& file) : file_(file), builder_(file) {}

  MeshBuilder& builder() { return builder_; }

  /// The section $PhysicalNames.
  void read_names(MshInput& in);
  void add_tag(std::int64_t tag) { tags_.add(tag); }
  /// All nodes are there.
  void end_nodes(const FilePosition& where);
  bool has_nodes() const { return has_nodes_; }

  /// \param physical  number of the physical group, 0: none     \param entity  number of the surface or volume
  MshGroup group(int dimension, std::int64_t physical, std::int64_t entity);
  /// \throws InputError  if the type is none that we know
  MshElement element(std::int64_t code) const;
  /// \param nodes  their tags
  void add_element(const MshElement& element, const MshGroup& group, std::span<const std::int64_t> nodes,
                   const FilePosition& where);

  VolumeFile finish() { return builder_.finish(); }

 private:
  std::string file_;
  MeshBuilder builder_;
  NodeTags tags_;
  bool has_nodes_ = false;
  std::uint64_t n_elements_ = 0;
  std::map<std::pair<int, std::int64_t>, std::string> names_;  // by dimension and number of the physical group
};

void read_msh22_nodes(MshInput& in, MshContent& content);
void read_msh22_elements(MshInput& in, MshContent& content);

/// A surface or volume of version 4, or a part of one.
struct MshEntity {
  std::int64_t physical = 0;  ///< number of its physical group, of several the first; 0: none
  std::int64_t tag = 0;       ///< its own number; that of the whole for a part
};

/// By dimension and tag.
using MshEntities = std::map<std::pair<int, std::int64_t>, MshEntity>;

void read_msh41_entities(MshInput& in, MshEntities& entities);
/// Those of a mesh that is cut into parts, which take the place of the others.
void read_msh41_partitioned_entities(MshInput& in, MshEntities& entities);
void read_msh41_nodes(MshInput& in, MshContent& content);
void read_msh41_elements(MshInput& in, const MshEntities& entities, MshContent& content);

}  // namespace nearwall::io
