#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "nearwall/surface/admission.h"

namespace nearwall::surface {

/// Gathers what is found wrong with a surface, by kind and patch. Triangles are told in the numbers of the input.
class FaultCollector {
 public:
  /// Both must outlive the collector.
  FaultCollector(const mesh::SurfaceMesh& surface, const IdVector<FaceId, FaceId>& input_face)
      : surface_(surface), input_face_(input_face) {}

  /// One more fault of a kind.
  /// \param where      a place near it, if it has any; places that are not finite are passed over
  /// \param triangles  all that are concerned; the patch is that of the first
  void add(FaultKind kind, const std::optional<Vec3>& where, std::span<const FaceId> triangles);

  bool has_any_of(std::initializer_list<FaultKind> kinds) const;

  /// All faults, by kind, then by patch, with advice.
  std::vector<Fault> faults(double closing_tolerance) const;

 private:
  const mesh::SurfaceMesh& surface_;
  const IdVector<FaceId, FaceId>& input_face_;
  std::map<std::pair<FaultKind, PatchId>, Fault> by_kind_and_patch_;
};

/// What a user reads about a refused surface: two lines for each kind of fault, the gravest few kinds.
std::string describe(const std::vector<Fault>& faults);

}  // namespace nearwall::surface
