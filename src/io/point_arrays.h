#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::io {

/// Point arrays of one number for each point, on the way out of a file: which are wanted, which there are.
class PointArrays {
 public:
  PointArrays() = default;
  explicit PointArrays(std::vector<std::string> wanted) : wanted_(std::move(wanted)) {}

  /// Tells of an array of the file. \returns whether its values are wanted: of several with one name those of the first
  bool meet(const std::string& name) {
    if (std::find(met_.begin(), met_.end(), name) != met_.end()) return false;
    met_.push_back(name);
    return std::find(wanted_.begin(), wanted_.end(), name) != wanted_.end();
  }
  /// Tells of an array of the file that is none of these. \param what  it is: "a cell array"
  void meet_other(const std::string& name, const std::string& what) { others_.push_back({name, what}); }
  void take(const std::string& name, std::vector<double> values) {
    taken_.push_back({name, IdVector<VertexId, double>(std::move(values))});
  }

  const std::vector<std::string>& wanted() const { return wanted_; }
  const std::vector<std::string>& met() const { return met_; }
  /// What the file has under a name that no point array has; empty: nothing.
  std::string other(const std::string& name) const {
    const auto found = std::find_if(others_.begin(), others_.end(), [&](const auto& o) { return o.first == name; });
    return found == others_.end() ? "" : found->second;
  }
  /// One that was taken; null if there is none of that name.
  mesh::PointArray* find(const std::string& name) {
    const auto found =
        std::find_if(taken_.begin(), taken_.end(), [&](const auto& array) { return array.name == name; });
    return found == taken_.end() ? nullptr : &*found;
  }

 private:
  std::vector<std::string> wanted_;
  std::vector<std::string> met_;                             // names
  std::vector<std::pair<std::string, std::string>> others_;  // names and what they are
  std::vector<mesh::PointArray> taken_;
};

}  // namespace nearwall::io
