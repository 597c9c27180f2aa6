#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/input_hdf5.h"

namespace nearwall::io {

/// A node of a CGNS file by the standard's mapping to HDF5 (SIDS-to-HDF5): a group whose attribute `label` is the kind
/// of node, with the data in ` data` and the children as groups within.
class CgnsNode {
 public:
  static CgnsNode root(const Hdf5File& file) { return CgnsNode(file, file.root(), ""); }

  const Hdf5File& file() const { return *file_; }
  const std::string& name() const { return name_; }
  const std::string& path() const { return group_.name(); }

  std::vector<CgnsNode> children(const std::string& label) const;
  /// The first of that label.
  std::optional<CgnsNode> child(const std::string& label) const;
  std::optional<CgnsNode> named(const std::string& name) const;

  Hdf5Array data() const { return group_.required_array(" data"); }
  std::string characters() const { return group_.characters(" data"); }
  /// At least that many whole numbers, and not more than a few. \throws GeometryError
  std::vector<std::int64_t> integers(std::size_t least) const;
  std::vector<std::int64_t> named_integers(const std::string& name, std::size_t least) const;
  /// Text of a child; empty if there is none.
  std::string named_characters(const std::string& name) const;

 private:
  CgnsNode(const Hdf5File& file, Hdf5Group group, std::string name)
      : file_(&file), group_(std::move(group)), name_(std::move(name)) {}

  const Hdf5File* file_;
  Hdf5Group group_;
  std::string name_;
};

}  // namespace nearwall::io
