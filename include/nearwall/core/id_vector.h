#pragma once

#include <ranges>
#include <utility>
#include <vector>

namespace nearwall {

/// A vector that is indexed by one kind of id only.
template <class IdType, class T>
class IdVector {
 public:
  using value_type = T;
  using Storage = std::vector<T>;
  using reference = typename Storage::reference;
  using const_reference = typename Storage::const_reference;

  IdVector() = default;
  explicit IdVector(std::size_t n, const T& value = T()) : data_(n, value) {}
  explicit IdVector(Storage data) : data_(std::move(data)) {}

  reference operator[](IdType id) { return data_[id.index()]; }
  const_reference operator[](IdType id) const { return data_[id.index()]; }

  std::size_t size() const { return data_.size(); }
  bool empty() const { return data_.empty(); }
  void resize(std::size_t n, const T& value = T()) { data_.resize(n, value); }
  void assign(std::size_t n, const T& value) { data_.assign(n, value); }
  void reserve(std::size_t n) { data_.reserve(n); }
  void clear() { data_.clear(); }
  IdType push_back(T value) {
    data_.push_back(std::move(value));
    return IdType(data_.size() - 1);
  }

  auto begin() { return data_.begin(); }
  auto end() { return data_.end(); }
  auto begin() const { return data_.begin(); }
  auto end() const { return data_.end(); }

  /// The plain vector, for code that walks all entries or hands them to a library.
  Storage& raw() { return data_; }
  const Storage& raw() const { return data_; }

  /// All ids, in order.
  auto ids() const {
    return std::views::iota(std::size_t{0}, data_.size()) |
           std::views::transform([](std::size_t i) { return IdType(i); });
  }

  friend bool operator==(const IdVector&, const IdVector&) = default;

 private:
  Storage data_;
};

}  // namespace nearwall
