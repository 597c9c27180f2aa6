#include "io/node_tags.h"

#include <algorithm>

namespace nearwall::io {
namespace {

/// Entries of a table for each point: beyond, sorting takes less memory.
constexpr std::uint64_t kSparsest = 4;

}  // namespace

std::optional<std::int64_t> NodeTags::prepare() {
  is_consecutive_ = are_consecutive();
  if (tags_.empty()) return {};
  const auto [low, high] = std::ranges::minmax_element(tags_);
  first_ = *low;
  if (is_consecutive_) return {};
  return static_cast<std::uint64_t>(*high - *low) / kSparsest < tags_.size() ? make_table() : sort();
}

bool NodeTags::are_consecutive() const {
  for (std::size_t i = 1; i < tags_.size(); ++i) {
    if (tags_[i] - 1 != tags_[i - 1]) return false;
  }
  return true;
}

std::optional<std::int64_t> NodeTags::make_table() {
  table_.assign(static_cast<std::size_t>(*std::ranges::max_element(tags_) - first_) + 1, 0);
  for (std::size_t i = 0; i < tags_.size(); ++i) {
    std::uint32_t& entry = table_[static_cast<std::size_t>(tags_[i] - first_)];
    if (entry != 0) return tags_[i];
    entry = static_cast<std::uint32_t>(i) + 1;
  }
  return {};
}

std::optional<std::int64_t> NodeTags::sort() {
  sorted_.reserve(tags_.size());
  for (std::size_t i = 0; i < tags_.size(); ++i) sorted_.emplace_back(tags_[i], static_cast<std::uint32_t>(i));
  std::ranges::sort(sorted_);
  for (std::size_t i = 1; i < sorted_.size(); ++i) {
    if (sorted_[i].first == sorted_[i - 1].first) return sorted_[i].first;
  }
  return {};
}

std::int64_t NodeTags::find(std::int64_t tag) const {
  if (tag < first_) return -1;
  const auto place = static_cast<std::uint64_t>(tag - first_);
  if (is_consecutive_) return place < tags_.size() ? static_cast<std::int64_t>(place) : -1;
  if (!table_.empty()) return place < table_.size() ? static_cast<std::int64_t>(table_[place]) - 1 : -1;
  const auto found = std::ranges::lower_bound(sorted_, std::pair<std::int64_t, std::uint32_t>{tag, 0});
  return found != sorted_.end() && found->first == tag ? static_cast<std::int64_t>(found->second) : -1;
}

}  // namespace nearwall::io
