#pragma once

#include <span>
#include <string>
#include <string_view>

namespace nearwall {

/// The candidate that a mistyped word most likely stands for: fewest insertions, deletions, replacements and swaps of
/// neighbouring letters; case does not count. The first of several equally near ones.
/// \returns  empty if none is near: more than two letters, and more than a third of them, would have to change
std::string nearest(std::string_view word, std::span<const std::string> candidates);

}  // namespace nearwall
