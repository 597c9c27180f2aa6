#include "io/boundary_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

namespace nearwall::io {
namespace {

std::string as_word(std::string_view name, std::string_view forbidden) {
  std::string word(name.empty() ? "patch" : name);
  std::ranges::replace_if(
      word,
      [&](char c) {
        const auto code = static_cast<unsigned char>(c);
        return code <= 0x20 || code == 0x7f || forbidden.find(c) != std::string_view::npos;
      },
      '_');
  return word;
}

}  // namespace

IdVector<PatchId, std::string> unique_names(const IdVector<PatchId, mesh::BoundaryPatch>& patches,
                                            const std::function<std::string(std::string_view)>& fit,
                                            std::span<const std::string_view> reserved) {
  std::set<std::string, std::less<>> taken(reserved.begin(), reserved.end());
  std::vector<bool> is_named(patches.size(), false);
  IdVector<PatchId, std::string> names(patches.size());
  for (const PatchId patch : patches.ids()) {
    names[patch] = fit(patches[patch].name);
    if (names[patch] == patches[patch].name) is_named[patch.index()] = taken.insert(names[patch]).second;
  }
  for (const PatchId patch : patches.ids()) {
    if (is_named[patch.index()]) continue;
    const std::string name = names[patch];
    for (int number = 2; !taken.insert(names[patch]).second; ++number)
      names[patch] = fmt::format("{}_{}", name, number);
  }
  return names;
}

IdVector<PatchId, std::string> patch_words(const IdVector<PatchId, mesh::BoundaryPatch>& patches,
                                           std::string_view forbidden, std::span<const std::string_view> reserved) {
  return unique_names(
      patches, [&](std::string_view name) { return as_word(name, forbidden); }, reserved);
}

mesh::BoundaryFace seen_from_inside(const mesh::BoundaryFace& face) {
  if (mesh::size_of(face) == 3) return {face[0], face[2], face[1], mesh::kNoFourthNode};
  return {face[0], face[3], face[2], face[1]};
}

}  // namespace nearwall::io
