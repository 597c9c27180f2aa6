#include "surface/faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace nearwall::surface {
namespace {

struct FaultWords {
  std::string_view name;      ///< in JSON
  std::string_view singular;  ///< in sentences
  std::string_view plural;
  std::string_view advice;
};

constexpr std::size_t kNKinds = 11;
constexpr std::array<FaultWords, kNKinds> kWords = {{
    {"not-finite", "point whose coordinates are not numbers", "points whose coordinates are not numbers",
     "Export the surface again: infinite and undefined coordinates cannot be repaired."},
    {"out-of-range", "point of a size that cannot be computed with", "points of a size that cannot be computed with",
     "Scale the surface: sizes and coordinates from 1e-60 to 1e60 can be computed with."},
    {"degenerate-triangle", "triangle without area", "triangles without area",
     "Collapse or remesh these triangles where the surface was made; repair = \"safe\" drops those with a repeated "
     "corner."},
    {"duplicate-triangle", "triangle that is there more than once", "triangles that are there more than once",
     "Set repair = \"safe\" to drop exact copies; copies that run the other way round must be removed where the "
     "surface "
     "was made."},
    {"non-manifold-edge", "edge with more than two triangles", "edges with more than two triangles",
     "Give walls without thickness a thickness, or unite the bodies that share the edge."},
    {"non-manifold-vertex", "point where parts of the surface touch", "points where parts of the surface touch",
     "Move the parts apart or unite them: the triangles round a point must form one fan."},
    {"inconsistent-orientation", "edge between triangles of opposite orientation",
     "edges between triangles of opposite orientation",
     "Set repair = \"safe\" to turn the triangles the same way round; a one-sided surface (Moebius strip) bounds no "
     "fluid."},
    {"open-edge", "open edge", "open edges",
     "Close the hole or remove the loose sheet where the surface was made; no weld length closes these edges."},
    {"self-intersection", "pair of triangles that intersect or touch", "pairs of triangles that intersect or touch",
     "Unite the overlapping parts, or remesh where the surface folds over itself."},
    {"inside-out", "component turned inside out", "components turned inside out",
     "Set repair = \"safe\" to turn it round: normals point out of bodies, and into the hollows within them."},
    {"empty", "surface without triangles", "surfaces without triangles", "Check that this is the file you meant."},
}};

const FaultWords& words_for(FaultKind kind) { return kWords[static_cast<std::size_t>(kind)]; }

std::string advice_for(FaultKind kind, double closing_tolerance) {
  if (kind != FaultKind::OpenEdge || !(closing_tolerance > 0)) return std::string(words_for(kind).advice);
  return fmt::format("Set weld = {:g}: merging points this near to each other closes all open edges.",
                     closing_tolerance);
}

std::string point_text(const Vec3& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z()); }

/// The first few entries as text, with "…" for the rest.
template <class Range, class Text>
std::string first_few(const Range& range, std::size_t n_shown, Text&& text) {
  std::string line;
  std::size_t n = 0;
  for (const auto& entry : range) {
    if (n == n_shown) return line + ", …";
    line += (n++ > 0 ? ", " : "") + text(entry);
  }
  return line;
}

/// All faults of one kind as one: counts added, places and triangles one after the other.
std::string describe_kind(std::span<const Fault> faults) {
  std::size_t count = 0;
  std::vector<Vec3> where;
  std::vector<FaceId> triangles;
  std::vector<std::string> patches;
  for (const Fault& fault : faults) {
    count += fault.count;
    where.insert(where.end(), fault.where.begin(), fault.where.end());
    triangles.insert(triangles.end(), fault.triangles.begin(), fault.triangles.end());
    if (!fault.patch.empty()) patches.push_back("'" + fault.patch + "'");
  }
  const FaultWords& words = words_for(faults.front().kind);
  std::string line = fmt::format("  {} {}", count, count == 1 ? words.singular : words.plural);
  if (!where.empty()) line += " near " + first_few(where, 2, point_text);
  if (!triangles.empty()) {
    line += triangles.size() == 1 ? ", triangle " : ", triangles ";
    line += first_few(triangles, 4, [](FaceId f) { return std::to_string(f.index()); });
  }
  if (!patches.empty()) {
    line += patches.size() == 1 ? ", patch " : ", patches ";
    line += first_few(patches, 3, [](const std::string& name) { return name; });
  }
  return line + "\n    " + faults.front().advice + "\n";
}

}  // namespace

std::string_view fault_name(FaultKind kind) { return words_for(kind).name; }

void FaultCollector::add(FaultKind kind, const std::optional<Vec3>& where, std::span<const FaceId> triangles) {
  constexpr std::size_t kMaxPlaces = 10;
  const PatchId patch = triangles.empty() ? PatchId() : surface_.face_patch[triangles.front()];
  Fault& fault = by_kind_and_patch_[{kind, patch}];
  fault.kind = kind;
  ++fault.count;
  if (where && is_finite(*where) && fault.where.size() < kMaxPlaces) fault.where.push_back(*where);
  for (const FaceId f : triangles) fault.triangles.push_back(input_face_[f]);
  if (patch.index() < surface_.patch_names.size()) fault.patch = surface_.patch_names[patch];
}

bool FaultCollector::has_any_of(std::initializer_list<FaultKind> kinds) const {
  return std::ranges::any_of(by_kind_and_patch_, [&](const auto& entry) {
    return std::ranges::find(kinds, entry.first.first) != kinds.end();
  });
}

std::vector<Fault> FaultCollector::faults(double closing_tolerance) const {
  std::vector<Fault> faults;
  for (const auto& [key, found] : by_kind_and_patch_) {
    Fault fault = found;
    std::ranges::sort(fault.triangles);
    fault.triangles.erase(std::unique(fault.triangles.begin(), fault.triangles.end()), fault.triangles.end());
    fault.advice = advice_for(fault.kind, closing_tolerance);
    faults.push_back(std::move(fault));
  }
  return faults;
}

std::string describe(const std::vector<Fault>& faults) {
  constexpr int kMaxKinds = 5;
  std::string kinds_text;
  std::string unshown;
  int n_kinds = 0;
  for (std::size_t begin = 0, end = 0; begin < faults.size(); begin = end) {
    while (end < faults.size() && faults[end].kind == faults[begin].kind) ++end;
    if (++n_kinds <= kMaxKinds) {
      kinds_text += describe_kind(std::span(faults).subspan(begin, end - begin));
    } else {
      unshown += fmt::format("{}{}", unshown.empty() ? "" : ", ", words_for(faults[begin].kind).plural);
    }
  }
  std::string message = "the surface cannot be used:\n" + kinds_text;
  if (!unshown.empty()) message += "  moreover " + unshown + "\n";
  message.pop_back();
  return message;
}

}  // namespace nearwall::surface
