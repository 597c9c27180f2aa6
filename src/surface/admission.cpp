#include "nearwall/surface/admission.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "nearwall/core/expect.h"
#include "nearwall/predicates/volume.h"
#include "nearwall/surface/weld.h"
#include "surface/checks.h"
#include "surface/closing.h"
#include "surface/edge_groups.h"
#include "surface/face_groups.h"
#include "surface/faults.h"
#include "surface/nesting.h"

namespace nearwall::surface {
namespace {

void turn_round(mesh::SurfaceMesh& surface, FaceId f) { std::swap(surface.faces[f][1], surface.faces[f][2]); }

std::string count_text(std::size_t n, std::string_view singular, std::string_view plural) {
  return fmt::format("{} {}", n, n == 1 ? singular : plural);
}

/// Repair: exact copies and triangles with a repeated corner go. Neither takes anything away from the surface.
void drop_superfluous(Admission& result) {
  const Copies copies = find_copies(result.surface);
  mesh::SurfaceMesh kept = result.surface;
  kept.faces.clear();
  kept.face_patch.clear();
  IdVector<FaceId, FaceId> input_face;
  std::size_t n_copies = 0, n_repeated = 0;
  for (const FaceId f : result.surface.faces.ids()) {
    const bool is_repeated = has_repeated_corner(result.surface.faces[f]);
    const bool is_copy = copies.kind[f] == Copy::Same;
    n_repeated += is_repeated ? 1 : 0;
    n_copies += is_copy ? 1 : 0;
    if (is_repeated || is_copy) continue;
    kept.faces.push_back(result.surface.faces[f]);
    kept.face_patch.push_back(result.surface.face_patch[f]);
    input_face.push_back(f);
  }
  if (n_repeated + n_copies == 0) return;
  drop_unused_points(kept);
  result.surface = std::move(kept);
  result.input_face = std::move(input_face);
  if (n_repeated > 0) {
    const std::string what =
        count_text(n_repeated, "triangle with a repeated corner", "triangles with a repeated corner");
    result.repairs.push_back(fmt::format("Dropped {}.", what));
  }
  if (n_copies > 0) {
    const std::string what = count_text(n_copies, "exact copy of a triangle", "exact copies of triangles");
    result.repairs.push_back(fmt::format("Dropped {}.", what));
  }
}

/// Repair: triangles are turned round so that neighbours agree.
/// \returns  whether there was any to turn
bool make_neighbours_agree(Admission& result, const EdgeGroups& edges) {
  const std::vector<char> turns = find_turns(result.surface, edges);
  std::size_t n_turned = 0;
  for (const FaceId f : result.surface.faces.ids()) {
    if (!turns[f.index()]) continue;
    turn_round(result.surface, f);
    ++n_turned;
  }
  if (n_turned == 0) return false;
  const std::string what =
      count_text(n_turned, "triangle to agree with its neighbours", "triangles to agree with their neighbours");
  result.repairs.push_back(fmt::format("Turned round {}.", what));
  return true;
}

void find_parts(Admission& result) {
  std::size_t n_components = 0;
  result.face_component = find_components(result.surface, n_components);
  result.components.assign(n_components, Component());
  for (const ComponentId c : result.face_component) ++result.components[c].n_faces;
}

IdVector<ComponentId, std::vector<FaceId>> faces_by_component(const Admission& result, const LeftOut& left_out) {
  IdVector<ComponentId, std::vector<FaceId>> faces(result.components.size());
  for (const FaceId f : result.face_component.ids()) {
    if (!left_out.of_topology[f.index()]) faces[result.face_component[f]].push_back(f);
  }
  return faces;
}

/// Depth, volume and part of each component; those that the fluid touches and that are inside out are turned round, or
/// are faults.
void check_nesting(Admission& result, const AdmissionPolicy& policy, const LeftOut& left_out, FaultCollector& faults) {
  find_nesting(result.surface, result.face_component, left_out.of_geometry, result.components);
  const int deepest_wetted = policy.fluid == FluidSide::Outside ? 0 : 1;
  const auto faces = faces_by_component(result, left_out);
  std::size_t n_turned = 0;
  for (const ComponentId c : result.components.ids()) {
    Component& component = result.components[c];
    const auto triangle = [&](std::size_t i) { return result.surface.triangle(faces[c][i]); };
    const auto [sign, volume] = predicates::enclosed_volume(faces[c].size(), triangle);
    component.volume = volume;
    component.is_wetted = component.depth <= deepest_wetted;
    const auto expected = component.depth % 2 == 0 ? predicates::Sign::Positive : predicates::Sign::Negative;
    // Only what was refused already encloses nothing: copies back to back, triangles without area.
    if (!component.is_wetted || sign == expected || sign == predicates::Sign::Zero) continue;
    if (policy.repair == Repair::Safe) {
      for (const FaceId f : faces[c]) turn_round(result.surface, f);
      ++n_turned;
    } else {
      const auto [p, q, r] = result.surface.triangle(faces[c].front());
      faults.add(FaultKind::InsideOut, (p + q + r) / 3, faces[c]);
    }
  }
  if (n_turned == 0) return;
  const std::string what = count_text(n_turned, "component that was inside out", "components that were inside out");
  result.repairs.push_back(fmt::format("Turned round {}.", what));
}

/// Walls agree with the region they enclose. For a fluid inside they are turned to face it.
void point_into_fluid(Admission& result, FluidSide fluid) {
  if (fluid == FluidSide::Outside) return;
  for (const FaceId f : result.surface.faces.ids()) {
    if (result.components[result.face_component[f]].is_wetted) turn_round(result.surface, f);
  }
}

/// A heap of loose triangles is no surface: to list all their intersections would tell nobody anything.
bool is_mostly_sound(const EdgeGroups& edges, const EdgeCounts& counts) {
  return 2 * (counts.open.size() + counts.n_crowded) <= edges.size();
}

}  // namespace

Admission inspect(mesh::SurfaceMesh surface, const AdmissionPolicy& policy) {
  Admission result;
  result.surface = std::move(surface);
  expect(result.surface.face_patch.size() == result.surface.faces.size(), "every face has a patch");
  for (std::size_t i = 0; i < result.surface.faces.size(); ++i) result.input_face.push_back(FaceId(i));
  if (policy.repair == Repair::Safe) drop_superfluous(result);

  FaultCollector faults(result.surface, result.input_face);
  if (result.surface.faces.empty()) faults.add(FaultKind::Empty, std::nullopt, {});
  const LeftOut left_out = check_triangles(result.surface, faults);
  EdgeGroups edges(result.surface, left_out.of_topology);
  if (policy.repair == Repair::Safe && make_neighbours_agree(result, edges)) {
    edges = EdgeGroups(result.surface, left_out.of_topology);
  }
  const EdgeCounts counts = check_edges(result.surface, edges, faults);
  result.n_open_edges = counts.open.size();
  result.closing_tolerance = closing_tolerance(result.surface, counts.open);
  check_vertices(result.surface, edges, left_out, faults);
  if (is_mostly_sound(edges, counts)) check_intersections(result.surface, left_out, faults);

  find_parts(result);
  using enum FaultKind;
  const bool is_manifold = !faults.has_any_of({NonManifoldEdge, NonManifoldVertex});
  const bool bounds_regions =
      is_manifold && !faults.has_any_of({NotFinite, OutOfRange, InconsistentOrientation, OpenEdge, SelfIntersection});
  if (bounds_regions) check_nesting(result, policy, left_out, faults);
  if (!is_manifold) result.face_component.clear();

  result.faults = faults.faults(result.closing_tolerance);
  if (result.is_usable()) point_into_fluid(result, policy.fluid);
  return result;
}

Admission admit(mesh::SurfaceMesh surface, const AdmissionPolicy& policy) {
  Admission admission = inspect(std::move(surface), policy);
  if (admission.is_usable()) return admission;
  const std::string message = describe(admission.faults);
  throw SurfaceRejected(message, std::move(admission));
}

}  // namespace nearwall::surface
