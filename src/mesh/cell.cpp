#include "nearwall/mesh/cell.h"

#include "nearwall/core/expect.h"
#include "nearwall/geometry/measures.h"

namespace nearwall::mesh {

double cell_volume(CellType type, std::span<const Vec3> p) {
  expect(p.size() >= static_cast<std::size_t>(size_of(type)), "a cell with all its corners");
  switch (type) {
    case CellType::Tetrahedron:
      return geometry::tetrahedron_volume(p.first<4>());
    case CellType::Pyramid:
      return geometry::pyramid_volume(p.first<5>());
    case CellType::Wedge:
      return geometry::wedge_volume(p.first<6>());
    case CellType::Hexahedron:
      break;
  }
  return geometry::hexahedron_volume(p.first<8>());
}

}  // namespace nearwall::mesh
