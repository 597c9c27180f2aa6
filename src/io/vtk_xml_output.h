#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/packed_array.h"

namespace nearwall::io {

/// Collects the tags of a VTK XML file and the places of its arrays, which follow the tags in the order of their tags.
class VtkXmlOutput {
 public:
  /// \param type  "UnstructuredGrid" or "PolyData"
  explicit VtkXmlOutput(std::string_view type);

  void open(std::string_view tag);  ///< e.g. open("Piece NumberOfPoints=\"3\"") writes <Piece NumberOfPoints="3">
  void close(std::string_view name);
  void add(PackedArray& array);
  /// Strings, as the character codes that VTK reads.
  void add_strings(std::string_view name, const std::vector<std::string>& strings);

  /// Tags, arrays and the end of the file.
  void write_to(const ByteSink& write);

 private:
  std::string tags_;
  std::string type_;
  std::vector<PackedArray*> arrays_;
  std::uint64_t offset_ = 0;
};

}  // namespace nearwall::io
