#pragma once

#include <cstdint>

namespace nearwall::studies {

/// Random numbers that are the same on every platform and at any number of threads: each block of a study draws from
/// the stream of its own number. SplitMix64 (Steele, Lea & Flood 2014).
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t stream) : state_(mixed(mixed(seed + kStep) + stream * kStep)) {}

  std::uint64_t next() { return mixed(state_ += kStep); }
  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

 private:
  static constexpr std::uint64_t kStep = 0x9E3779B97F4A7C15;  // 2^64 / golden ratio, odd: visits every state

  static constexpr std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace nearwall::studies
