#include "io/cgns_boundary_hdf5.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "io/cgns_names.h"

namespace nearwall::io {
namespace {

using mesh::BoundaryType;

BoundaryType type_of(std::string_view condition) {
  if (condition.starts_with("BCWall")) return BoundaryType::Wall;
  if (condition.starts_with("BCSymmetry")) return BoundaryType::Symmetry;
  if (condition.starts_with("BCInflow") || condition.starts_with("BCTunnelInflow")) return BoundaryType::Inlet;
  if (condition.starts_with("BCOutflow") || condition.starts_with("BCTunnelOutflow")) return BoundaryType::Outlet;
  if (condition == "BCFarfield") return BoundaryType::FarField;
  return BoundaryType::Other;
}

/// The name that a patch had before it had to be cut, else that of the node.
std::string full_name(const CgnsNode& node) {
  const std::string full = node.named_characters(kFullNameText);
  return full.empty() ? node.name() : full;
}

/// A boundary condition of a zone.
struct Condition {
  mesh::BoundaryPatch patch;
  CgnsElements members;
  bool is_of_points = false;
};

Condition read_condition(const CgnsNode& node, const CgnsFamilies& families) {
  const std::string kind = node.characters(), location = node.named_characters("GridLocation");
  const std::optional<CgnsNode> family_name = node.child("FamilyName_t");
  const mesh::BoundaryPatch* const family = family_name ? families.patch(family_name->characters()) : nullptr;
  Condition condition;
  condition.members = CgnsElements(node);
  const bool names_elements = node.named("ElementRange") || node.named("ElementList");
  condition.is_of_points = !names_elements && (location.empty() || location == "Vertex");
  if (kind != "FamilySpecified") {
    condition.patch = {full_name(node), type_of(kind)};
  } else if (family) {
    condition.patch = *family;
  } else {
    condition.patch = {family_name ? family_name->characters() : node.name(), BoundaryType::Other};
  }
  return condition;
}

std::vector<Condition> conditions_of(const CgnsNode& zone, const CgnsFamilies& families) {
  std::vector<Condition> conditions;
  for (const CgnsNode& all : zone.children("ZoneBC_t")) {
    for (const CgnsNode& node : all.children("BC_t")) conditions.push_back(read_condition(node, families));
  }
  return conditions;
}

}  // namespace

CgnsElements::CgnsElements(const CgnsNode& node) {
  for (const char* name : {"PointRange", "ElementRange"}) {
    if (!node.named(name)) continue;
    const std::vector<std::int64_t> range = node.named_integers(name, 2);
    if (range.size() != 2) node.file().fail(fmt::format("{}/{}: expected 2 numbers", node.path(), name));
    first_ = range[0], last_ = range[1];
    return;
  }
  for (const char* name : {"PointList", "ElementList"}) {
    const std::optional<CgnsNode> list = node.named(name);
    if (!list) continue;
    list_ = list->data().all<std::int64_t>();
    std::sort(list_.begin(), list_.end());
    return;
  }
}

bool CgnsElements::contains(std::int64_t number) const {
  return (number >= first_ && number <= last_) || std::binary_search(list_.begin(), list_.end(), number);
}

CgnsFamilies::CgnsFamilies(const CgnsNode& base) {
  for (const CgnsNode& family : base.children("Family_t")) {
    const std::optional<CgnsNode> condition = family.child("FamilyBC_t");
    if (!condition) continue;
    order_.push_back(family.name());
    patch_of_family_[family.name()] = {full_name(family), type_of(condition->characters())};
  }
}

std::vector<mesh::BoundaryPatch> CgnsFamilies::patches() const {
  std::vector<mesh::BoundaryPatch> patches;
  for (const std::string& family : order_) patches.push_back(patch_of_family_.at(family));
  return patches;
}

const mesh::BoundaryPatch* CgnsFamilies::patch(const std::string& family) const {
  const auto found = patch_of_family_.find(family);
  return found == patch_of_family_.end() ? nullptr : &found->second;
}

std::size_t CgnsFaces::add_section(const std::string& name) {
  sections_.push_back(name);
  return sections_.size() - 1;
}

void CgnsFaces::add(std::int64_t element, std::span<const std::int64_t> nodes, std::size_t section) {
  Face face{element, {}, static_cast<std::uint8_t>(nodes.size()), static_cast<std::uint32_t>(section)};
  std::copy(nodes.begin(), nodes.end(), face.nodes.begin());
  faces_.push_back(face);
}

void CgnsFaces::add_to(MeshBuilder& builder, const CgnsNode& zone, const CgnsFamilies& families,
                       std::int64_t n_points) {
  const std::vector<Condition> conditions = conditions_of(zone, families);
  const auto first_point = static_cast<std::int64_t>(builder.n_points()) - n_points;
  const auto has = [&](const Condition& condition, const Face& face) {
    if (!condition.is_of_points) return condition.members.contains(face.element);
    return std::all_of(face.nodes.begin(), face.nodes.begin() + face.size,
                       [&](std::int64_t node) { return condition.members.contains(node - first_point + 1); });
  };
  for (const Face& face : faces_) {
    const auto found =
        std::find_if(conditions.begin(), conditions.end(), [&](const Condition& c) { return has(c, face); });
    const PatchId patch = found == conditions.end() ? builder.patch(sections_[face.section])
                                                    : builder.patch(found->patch.name, found->patch.type);
    builder.add_face(patch, {face.nodes.data(), face.size}, {zone.file().name(), true, 0});
  }
}

}  // namespace nearwall::io
