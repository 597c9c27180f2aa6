#include "studies/test_functions.h"

#include <array>
#include <numbers>

#include "nearwall/core/expect.h"

namespace nearwall::studies {

namespace {

/// exp(-((x - a)² + (y - b)²) * s).
Jet bell(const Jet& x, const Jet& y, double a, double b, double s) { return exp(-s * (square(x - a) + square(y - b))); }

Jet squared_radius(const Jet& x, const Jet& y) { return square(x - 0.5) + square(y - 0.5); }

Jet franke_exponential(const Jet& x, const Jet& y) {
  const Jet u = 9.0 * x, v = 9.0 * y;
  const Jet broad = exp((-1.0 / 49.0) * square(u + 1.0) - 0.1 * square(v + 1.0));
  return 0.75 * broad + 0.75 * bell(u, v, 2, 2, 0.25) + 0.5 * bell(u, v, 7, 3, 0.25) - 0.2 * bell(u, v, 4, 7, 1);
}

Jet franke_cliff(const Jet& x, const Jet& y) { return (-1.0 / 9.0) * (tanh(9.0 * y - 9.0 * x) - 1.0); }

Jet franke_saddle(const Jet& x, const Jet& y) {
  return (cos(5.4 * y) + 1.25) * inverse(6.0 * square(3.0 * x - 1.0) + 6.0);
}

Jet franke_gentle(const Jet& x, const Jet& y) { return (1.0 / 3.0) * exp((-81.0 / 16.0) * squared_radius(x, y)); }

Jet waves(const Jet& x, const Jet& y) { return cos(10.0 * y) + sin(10.0 * (x - y)); }

Jet franke_sphere(const Jet& x, const Jet& y) { return (1.0 / 9.0) * sqrt(-81.0 * squared_radius(x, y) + 64.0) - 0.5; }

Jet ring(const Jet& x, const Jet& y) {
  const Jet radius = 10.0 * sqrt(square(x) + square(y));
  return inverse(sqrt(2.0 * exp(-3.0 * (radius - 6.7)) + 1.0));
}

Jet peak(const Jet& x, const Jet& y) { return 50.0 * bell(x, y, 0.3, 0.3, 200) + bell(x, y, 0.5, 0.5, 50); }

Jet product_of_sines(const Jet& x, const Jet& y) {
  return sin(std::numbers::pi * x) * sin((2.0 * std::numbers::pi) * y);
}

}  // namespace

Jet test_function(int number, double x, double y) {
  constexpr std::array<Jet (*)(const Jet&, const Jet&), kTestFunctions> kFunctions = {
      franke_exponential, franke_cliff, franke_saddle, franke_gentle,   waves,
      franke_sphere,      ring,         peak,          product_of_sines};
  expect(number >= 1 && number <= kTestFunctions, "test functions are numbered 1 to 9");
  return kFunctions[static_cast<std::size_t>(number - 1)]({x, 1, 0}, {y, 0, 1});
}

}  // namespace nearwall::studies
