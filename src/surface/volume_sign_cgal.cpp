#include <CGAL/Exact_rational.h>

#include "surface/nesting.h"

namespace nearwall::surface {

predicates::Sign exact_volume_sign(const mesh::SurfaceMesh& surface, std::span<const FaceId> faces) {
  using Number = CGAL::Exact_rational;
  Number six_volumes = 0;
  for (const FaceId f : faces) {
    const auto [a, b, c] = surface.triangle(f);
    const Number ax(a.x()), ay(a.y()), az(a.z()), bx(b.x()), by(b.y()), bz(b.z()), cx(c.x()), cy(c.y()), cz(c.z());
    six_volumes += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  return six_volumes > 0   ? predicates::Sign::Positive
         : six_volumes < 0 ? predicates::Sign::Negative
                           : predicates::Sign::Zero;
}

}  // namespace nearwall::surface
