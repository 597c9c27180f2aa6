#include "nearwall/studies/ubach.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/arctangent.h"
#include "studies/random.h"

namespace nearwall::studies {

namespace {

constexpr std::size_t kBlock = 4096;  // samples from one random stream
constexpr int kFewestFaces = 3, kMostFaces = 64;
constexpr double kMostCurvature = 1e50;  // products of four lengths stay finite

/// A random surface z(x, y) through the origin, where its normal is the z axis; equation (22).
class Cubic {
 public:
  Cubic(double max_curvature, RandomStream& random) {
    for (double& c : coefficient_) c = random.uniform(-max_curvature, max_curvature);
  }

  Vec3 point(double x, double y) const {
    const auto& [a, b, c, d, e, f, g] = coefficient_;
    return {x, y, (a * x + b * y) * x + c * y * y + ((d * x + e * y) * x + f * y * y) * x + g * y * y * y};
  }

 private:
  std::array<double, 7> coefficient_;
};

/// Polar angles in ascending order with no gap of more than a half turn, the gap over 0 included.
void draw_angles(std::vector<double>& angles, RandomStream& random) {
  constexpr double kTurn = 2 * std::numbers::pi;
  while (true) {
    for (double& angle : angles) angle = random.uniform(0, kTurn);
    std::sort(angles.begin(), angles.end());
    double widest = angles.front() + kTurn - angles.back();
    for (std::size_t i = 1; i < angles.size(); ++i) widest = std::max(widest, angles[i] - angles[i - 1]);
    if (widest <= std::numbers::pi) return;
  }
}

/// Sums over the samples of a block, for each weight.
struct Sums {
  std::array<double, kUbachWeights.size()> squares{}, fourth_powers{};

  Sums& operator+=(const Sums& other) {
    for (std::size_t i = 0; i < squares.size(); ++i) {
      squares[i] += other.squares[i];
      fourth_powers[i] += other.fourth_powers[i];
    }
    return *this;
  }
};

Sums sums_of_block(double max_curvature, int n_faces, std::size_t n_samples, RandomStream random) {
  Sums sums;
  std::vector<double> angles(static_cast<std::size_t>(n_faces));
  std::vector<Vec3> ring(angles.size());
  for (std::size_t sample = 0; sample < n_samples; ++sample) {
    const Cubic surface(max_curvature, random);
    draw_angles(angles, random);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double r = 1.0 - random.uniform();
      ring[i] = surface.point(r * std::cos(angles[i]), r * std::sin(angles[i]));
    }
    for (std::size_t w = 0; w < kUbachWeights.size(); ++w) {
      const Vec3 n = surface::weighted_normal(kUbachWeights[w], Vec3(), ring);
      // Not the arc cosine: it loses all digits at 1e-5 degrees.
      const double error = geometry::to_degrees(geometry::angle_from(std::hypot(n.x(), n.y()), n.z()));
      sums.squares[w] += error * error;
      sums.fourth_powers[w] += error * error * error * error;
    }
  }
  return sums;
}

/// Number of the cell among all, so that each has random streams of its own.
std::uint64_t cell_number(double max_curvature, int n_faces) {
  const auto at = std::find(kUbachCurvatures.begin(), kUbachCurvatures.end(), max_curvature);
  return static_cast<std::uint64_t>(at - kUbachCurvatures.begin()) * kMostFaces + static_cast<std::uint64_t>(n_faces);
}

void check(double max_curvature, int n_faces, const UbachOptions& options) {
  if (options.samples == 0) throw InputError("study ubach: expected at least 1 sample, found 0");
  if (n_faces < kFewestFaces || n_faces > kMostFaces) {
    throw InputError(fmt::format("study ubach: expected {} to {} triangles round the point, found {}", kFewestFaces,
                                 kMostFaces, n_faces));
  }
  if (!(max_curvature > 0 && max_curvature <= kMostCurvature)) {
    throw InputError(fmt::format("study ubach: expected a curvature of more than 0 and at most {:g}, found {:g}",
                                 kMostCurvature, max_curvature));
  }
}

}  // namespace

UbachCell ubach_cell(double max_curvature, int n_faces, const UbachOptions& options) {
  check(max_curvature, n_faces, options);
  const std::uint64_t first_stream = cell_number(max_curvature, n_faces) << 32;
  std::vector<Sums> blocks((options.samples + kBlock - 1) / kBlock);
  parallel_blocks(options.samples, kBlock, [&](std::size_t begin, std::size_t end) {
    const std::size_t block = begin / kBlock;
    blocks[block] =
        sums_of_block(max_curvature, n_faces, end - begin, RandomStream(options.seed, first_stream + block));
  });
  Sums sums;
  for (const Sums& block : blocks) sums += block;

  UbachCell cell{.max_curvature = max_curvature, .n_faces = n_faces};
  const auto n = static_cast<double>(options.samples);
  for (std::size_t w = 0; w < kUbachWeights.size(); ++w) {
    const double mean = sums.squares[w] / n;
    const double variance = std::max(0.0, sums.fourth_powers[w] / n - mean * mean);
    cell.rmse_deg[w] = std::sqrt(mean);
    // d(sqrt(m)) = dm / (2 sqrt(m)).
    cell.standard_error_deg[w] = mean > 0 ? std::sqrt(variance / n / mean) / 2 : 0;
  }
  return cell;
}

}  // namespace nearwall::studies
