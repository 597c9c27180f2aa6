#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <limits>

namespace nearwall {

/// An index that knows what it indexes: a VertexId cannot be used where a FaceId is expected. 0-based.
template <class Tag>
class Id {
 public:
  using Index = std::uint32_t;

  constexpr Id() = default;
  constexpr explicit Id(std::size_t index) : index_(static_cast<Index>(index)) {}

  constexpr Index index() const { return index_; }
  constexpr bool is_valid() const { return index_ != kInvalid; }
  friend constexpr auto operator<=>(Id, Id) = default;

 private:
  static constexpr Index kInvalid = std::numeric_limits<Index>::max();
  Index index_ = kInvalid;
};

using VertexId = Id<struct VertexTag>;        ///< vertex of the base surface
using FaceId = Id<struct FaceTag>;            ///< triangle of the base surface
using HalfedgeId = Id<struct HalfedgeTag>;    ///< side k of face f: 3 f + k, from corner k to corner k + 1
using PatchId = Id<struct PatchTag>;          ///< named set of faces
using ComponentId = Id<struct ComponentTag>;  ///< connected component (shell) of a surface
using LineId = Id<struct LineTag>;            ///< extrusion line; a vertex owns one or several
using FrontFaceId = Id<struct FrontFaceTag>;  ///< face of the front: wall triangle or virtual face

/// Level of a node on its line: 0 at the wall.
using Level = std::uint16_t;

/// Nodes and cells outnumber 32 bits on large surfaces: plain 64-bit numbers.
using NodeIndex = std::uint64_t;
using CellIndex = std::uint64_t;

}  // namespace nearwall

template <class Tag>
struct std::hash<nearwall::Id<Tag>> {
  std::size_t operator()(nearwall::Id<Tag> id) const noexcept { return id.index(); }
};
