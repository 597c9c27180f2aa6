#include "nearwall/mesh/boundary.h"

namespace nearwall::mesh {

IdVector<PatchId, std::vector<std::uint32_t>> faces_by_patch(const Boundary& boundary) {
  IdVector<PatchId, std::vector<std::uint32_t>> faces(boundary.patches.size());
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    faces[boundary.patch[f]].push_back(static_cast<std::uint32_t>(f));
  }
  return faces;
}

}  // namespace nearwall::mesh
