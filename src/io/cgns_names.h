#pragma once

#include <set>
#include <string>
#include <string_view>

namespace nearwall::io {

/// Longest name of a node of a CGNS file [bytes].
inline constexpr std::size_t kMostInCgnsName = 32;

/// Where a name had to be changed, the name of the text (Descriptor_t) that keeps it whole.
inline constexpr const char* kFullNameText = "FullName";

/// Makes names that a CGNS file takes and that differ from each other.
class CgnsNames {
 public:
  explicit CgnsNames(std::set<std::string, std::less<>> reserved) : used_(std::move(reserved)) {}

  /// The name itself if it can be; else without the characters that mean something in paths, cut to 32 bytes, with a
  /// number at its end if another has that name.
  std::string add(std::string_view full);

 private:
  std::set<std::string, std::less<>> used_;
};

}  // namespace nearwall::io
