#pragma once

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/shapes.h"

/// Ways to put a body somewhere else, so that no coordinate is round and no plane lies along the axes.
namespace nearwall::gallery {

/// A rotation drawn uniformly, from a random unit quaternion.
class Rotation {
 public:
  explicit Rotation(unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    double squares = 0;
    for (double& c : q_) {
      c = normal(random);
      squares += c * c;
    }
    for (double& c : q_) c /= std::sqrt(squares);
  }
  Vec3 operator()(const Vec3& p) const {
    const Vec3 u(q_[1], q_[2], q_[3]);
    return u * (2 * dot(u, p)) + p * (q_[0] * q_[0] - dot(u, u)) + cross(u, p) * (2 * q_[0]);
  }

 private:
  std::array<double, 4> q_;
};

/// A rotation, a scale, and a distance from the origin over the scale.
struct Move {
  std::string name;
  unsigned seed = 0;
  double scale = 1;
  double distance = 0;

  mesh::SurfaceMesh operator()(mesh::SurfaceMesh surface) const {
    const Rotation rotate(seed);
    const Vec3 offset = rotate(Vec3(distance, 0, 0));
    return shapes_for_tests::mapped(std::move(surface), [&](const Vec3& p) { return (rotate(p) + offset) * scale; });
  }
};

/// Each scale with n_seeds rotations, and as many far from the origin.
inline std::vector<Move> moves(unsigned n_seeds) {
  std::vector<Move> all;
  for (unsigned seed = 1; seed <= n_seeds; ++seed) {
    const std::string n = std::to_string(seed);
    all.push_back({"turned_" + n, seed, 1, 0});
    all.push_back({"tiny_" + n, seed + 1000, 1e-6, 0});
    all.push_back({"huge_" + n, seed + 2000, 1e6, 0});
    all.push_back({"far_" + n, seed + 3000, 1, 1000});
  }
  return all;
}

}  // namespace nearwall::gallery
