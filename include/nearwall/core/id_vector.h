#pragma once

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace nearwall {

/// The ids 0 … n − 1, or those from one to before another.
template <class IdType>
class IdRange {
 public:
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = IdType;
    using difference_type = std::ptrdiff_t;
    using pointer = const IdType*;
    using reference = IdType;

    Iterator() = default;
    explicit Iterator(std::size_t index) : index_(index) {}
    IdType operator*() const { return IdType(index_); }
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++index_;
      return before;
    }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    std::size_t index_ = 0;
  };

  explicit IdRange(std::size_t n) : end_(n) {}
  IdRange(std::size_t begin, std::size_t end) : begin_(begin), end_(end) {}
  Iterator begin() const { return Iterator(begin_); }
  Iterator end() const { return Iterator(end_); }

 private:
  std::size_t begin_ = 0;
  std::size_t end_;
};

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
  IdRange<IdType> ids() const { return IdRange<IdType>(data_.size()); }

  friend bool operator==(const IdVector&, const IdVector&) = default;

 private:
  Storage data_;
};

}  // namespace nearwall
