#include "shapes/wing_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "nearwall/geometry/angles.h"
#include "shapes/definition.h"
#include "shapes/sampling.h"

namespace nearwall::shapes {
namespace {

/// Ordinates of the section ONERA D: x / chord, z / chord (AGARD AR-138, B1).
constexpr std::array<SectionPoint, 72> kOneraD = {{
    {0.0000000, 0.0000000}, {0.0000165, 0.0006914}, {0.0000696, 0.0014416}, {0.0001675, 0.0022554},
    {0.0003232, 0.0031382}, {0.0005508, 0.0040959}, {0.0008657, 0.0051343}, {0.0012868, 0.0062598},
    {0.0018364, 0.0074784}, {0.0025441, 0.0087958}, {0.0034428, 0.0102163}, {0.0045704, 0.0117419},
    {0.0059751, 0.0133708}, {0.0077112, 0.0150951}, {0.0098413, 0.0168984}, {0.0124479, 0.0187537},
    {0.0156171, 0.0206220}, {0.0194609, 0.0224545}, {0.0241067, 0.0242004}, {0.0297008, 0.0258245},
    {0.0364261, 0.0273317}, {0.0444852, 0.0287912}, {0.0541248, 0.0303278}, {0.0656303, 0.0320138},
    {0.0793366, 0.0338372}, {0.0956354, 0.0357742}, {0.1149796, 0.0377923}, {0.1378963, 0.0398522},
    {0.1649976, 0.0419089}, {0.1919327, 0.0436214}, {0.2187096, 0.0450507}, {0.2453310, 0.0462358},
    {0.2717978, 0.0471987}, {0.2981113, 0.0479494}, {0.3242726, 0.0484902}, {0.3502830, 0.0488183},
    {0.3761446, 0.0489296}, {0.4018567, 0.0488202}, {0.4274223, 0.0484833}, {0.4528441, 0.0479351},
    {0.4781197, 0.0471661}, {0.5032514, 0.0461903}, {0.5282426, 0.0450209}, {0.5530937, 0.0436741},
    {0.5778043, 0.0421684}, {0.6023757, 0.0405241}, {0.6268104, 0.0387613}, {0.6511093, 0.0368990},
    {0.6752726, 0.0349542}, {0.6993027, 0.0329402}, {0.7231995, 0.0308662}, {0.7469658, 0.0287365},
    {0.7705998, 0.0265505}, {0.7941055, 0.0243027}, {0.8174828, 0.0219842}, {0.8407324, 0.0195838},
    {0.8638564, 0.0170915}, {0.8868235, 0.0145051}, {0.9061905, 0.0122389}, {0.9225336, 0.0102727},
    {0.9363346, 0.0085827}, {0.9479946, 0.0071423}, {0.9578511, 0.0059224}, {0.9661860, 0.0048907},
    {0.9732361, 0.0040180}, {0.9792020, 0.0032796}, {0.9842508, 0.0026547}, {0.9885252, 0.0021257},
    {0.9921438, 0.0016778}, {0.9952080, 0.0012985}, {0.9978030, 0.0009773}, {1.0000000, 0.0007052},
}};

/// Where the section ONERA D is thickest.
constexpr double kOneraDThickest = 0.3761446;

/// Largest turn of the outline from one edge to the next [deg].
constexpr double kMaxTurnDeg = 12;

/// Natural cubic spline through (s, z).
class Spline {
 public:
  Spline(std::vector<double> s, std::vector<double> z) : s_(std::move(s)), z_(std::move(z)), curvature_(s_.size(), 0) {
    const std::size_t n = s_.size();
    // Tridiagonal system for the second derivatives, eliminated forwards and substituted backwards.
    std::vector<double> upper(n, 0), right(n, 0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double h0 = s_[i] - s_[i - 1], h1 = s_[i + 1] - s_[i];
      const double jump = 6 * ((z_[i + 1] - z_[i]) / h1 - (z_[i] - z_[i - 1]) / h0);
      const double pivot = 2 * (h0 + h1) - h0 * upper[i - 1];
      upper[i] = h1 / pivot;
      right[i] = (jump - h0 * right[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 1;) curvature_[i] = right[i] - upper[i] * curvature_[i + 1];
  }

  double operator()(double s) const {
    const auto after = std::upper_bound(s_.begin() + 1, s_.end() - 1, s);
    const auto i = static_cast<std::size_t>(after - s_.begin());
    const double h = s_[i] - s_[i - 1], a = (s_[i] - s) / h, b = 1 - a;
    return a * z_[i - 1] + b * z_[i] +
           ((a * a * a - a) * curvature_[i - 1] + (b * b * b - b) * curvature_[i]) * h * h / 6;
  }

 private:
  std::vector<double> s_, z_, curvature_;
};

}  // namespace

WingSection naca_section(int digits, bool is_blunt) {
  const double camber = digits / 1000 / 100.0, place = digits / 100 % 10 / 10.0, thickness = digits % 100 / 100.0;
  require(thickness > 0,
          "the last two of a wing section's four digits are its thickness in percent and must not be 00");
  require((camber == 0) == (place == 0),
          "the first two of a wing section's four digits are camber and its place: both 0 or neither");
  const double last = is_blunt ? -0.1015 : -0.1036;
  // One side: +1 upper, -1 lower. Thickness is laid off at a right angle to the camber line.
  const auto side = [=](double sign) {
    return [=](double t) {
      const double x = t * t;
      if (t == 1 && !is_blunt) return SectionPoint{1, 0};
      const double half = 5 * thickness * (0.2969 * t + x * (-0.1260 + x * (-0.3516 + x * (0.2843 + x * last))));
      double mean = 0, slope = 0;
      if (camber > 0) {
        const double p = place, length = x < p ? p : 1 - p;
        mean = camber / (length * length) * (x < p ? 2 * p * x - x * x : 1 - 2 * p + 2 * p * x - x * x);
        slope = 2 * camber / (length * length) * (p - x);
      }
      const double angle = std::atan(slope);
      return SectionPoint{x - sign * half * std::sin(angle), mean + sign * half * std::cos(angle)};
    };
  };
  return {side(1), side(-1), is_blunt};
}

WingSection onera_d_section(bool is_blunt) {
  std::vector<double> s, z;
  for (const SectionPoint& p : kOneraD) {
    s.push_back(std::sqrt(p.x));
    z.push_back(p.z);
  }
  const auto spline = std::make_shared<const Spline>(std::move(s), std::move(z));
  const auto half = [=](double t) {
    const double x = t * t;
    if (t == 1 && !is_blunt) return 0.0;
    const double behind = std::max(0.0, (x - kOneraDThickest) / (1 - kOneraDThickest));
    return (*spline)(t) - (is_blunt ? 0 : kOneraD.back().z * behind * behind);
  };
  return {[=](double t) {
            return SectionPoint{t * t, half(t)};
          },
          [=](double t) {
            return SectionPoint{t * t, -half(t)};
          },
          is_blunt};
}

std::vector<double> section_parameters(const WingSection& section, double size) {
  const auto outline = [&](double t) {
    const SectionPoint p = section.upper(t);
    return Vec3(p.x, 0, p.z);
  };
  return graded_parameters(outline, {.size = size, .max_turn = geometry::to_radians(kMaxTurnDeg)});
}

}  // namespace nearwall::shapes
