#include "nearwall/core/vec3.h"

#include <cmath>

namespace nearwall {

Vec3 normalized(const Vec3& a) {
  const double largest = max_norm(a);
  if (!(largest > 0)) return {};
  // Scaling by a power of two first keeps |a|² in range and is exact, so the result is the same at any scale.
  int exponent = 0;
  std::frexp(largest, &exponent);
  const Vec3 scaled(std::ldexp(a.x(), -exponent), std::ldexp(a.y(), -exponent), std::ldexp(a.z(), -exponent));
  return scaled / norm(scaled);
}

}  // namespace nearwall
