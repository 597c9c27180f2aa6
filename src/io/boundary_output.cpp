#include "io/boundary_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

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

IdVector<PatchId, std::string> patch_words(const IdVector<PatchId, mesh::BoundaryPatch>& patches,
                                           std::string_view forbidden, std::span<const std::string_view> reserved) {
  std::set<std::string, std::less<>> taken(reserved.begin(), reserved.end());
  IdVector<PatchId, std::string> words(patches.size());
  for (const PatchId patch : patches.ids()) {
    const std::string& name = patches[patch].name;
    if (as_word(name, forbidden) == name && taken.insert(name).second) words[patch] = name;
  }
  for (const PatchId patch : patches.ids()) {
    if (!words[patch].empty()) continue;
    const std::string word = as_word(patches[patch].name, forbidden);
    words[patch] = word;
    for (int number = 2; !taken.insert(words[patch]).second; ++number)
      words[patch] = fmt::format("{}_{}", word, number);
  }
  return words;
}

mesh::BoundaryFace seen_from_inside(const mesh::BoundaryFace& face) {
  if (mesh::size_of(face) == 3) return {face[0], face[2], face[1], mesh::kNoFourthNode};
  return {face[0], face[3], face[2], face[1]};
}

}  // namespace nearwall::io
