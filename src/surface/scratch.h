#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace nearwall::surface {

/// Values for one call: on the stack for all but extraordinary vertices.
template <class T, std::size_t kSmall = 24>
class Scratch {
 public:
  explicit Scratch(std::size_t n) {
    if (n > small_.size()) large_.resize(n);
    data_ = large_.empty() ? small_.data() : large_.data();
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  void add(const T& value) { data_[n_++] = value; }
  std::span<const T> all() const { return {data_, n_}; }
  std::span<T> all() { return {data_, n_}; }

 private:
  std::array<T, kSmall> small_;
  std::vector<T> large_;
  T* data_ = nullptr;
  std::size_t n_ = 0;
};

}  // namespace nearwall::surface
