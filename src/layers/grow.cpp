#include "nearwall/layers/grow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "layout.h"
#include "line_set.h"
#include "nearwall/certify/certificate.h"
#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"
#include "nearwall/geometry/angles.h"
#include "shrink.h"
#include "vertex_field.h"

namespace nearwall::layers {

namespace {

/// Smallest angle between the lines of a fan that may be asked for: fans of a few hundred lines help nobody.
constexpr double kLeastMaxTurn = geometry::to_radians(1);

std::vector<VertexId> merged(std::vector<VertexId> a, const std::vector<VertexId>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}

/// A virtual face that stands on a vertex.
struct VirtualFace {
  VertexId vertex;
  FrontFaceId face;
  friend auto operator<=>(const VirtualFace&, const VirtualFace&) = default;
};

bool by_vertex(const VirtualFace& a, const VirtualFace& b) { return a.vertex < b.vertex; }

/// Sorted by vertex.
std::vector<VirtualFace> virtual_faces_of_vertices(const mesh::Front& front) {
  std::vector<VirtualFace> all;
  for (std::size_t i = front.n_wall_faces; i < front.faces.size(); ++i) {
    const mesh::FrontFace& face = front.faces[FrontFaceId(i)];
    for (int k = 0; k < face.size(); ++k) {
      all.push_back({front.line_vertex[face.lines[static_cast<std::size_t>(k)]], FrontFaceId(i)});
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// The loop of certify and shrink. Only columns and front triangles whose lines changed are looked at again.
class Settling {
 public:
  Settling(const Wall& wall, const LinePlan& plan, const Stacks& stacks, int patient_rounds, VertexField& field,
           Growth& growth)
      : wall_(wall),
        plan_(plan),
        stacks_(stacks),
        patient_rounds_(patient_rounds),
        field_(field),
        growth_(growth),
        shrinker_(wall, plan, field),
        component_(wetted_components(wall)),
        virtual_faces_(virtual_faces_of_vertices(plan.front)),
        resolution_(resolution(wall, field)),
        front_changed_(plan.front.faces.size(), 1) {}

  void run(ProgressSink& progress) {
    while (auto failed = one_round()) {
      if (failed->empty()) failed = shrinker_.shrink_all();
      ++growth_.rounds;
      if (growth_.rounds > patient_rounds_) shrinker_.lose_patience();
      lower(growth_.rounds > 2 * patient_rounds_ ? with_their_components(*failed) : *failed);
      // The number of rounds is not known beforehand: the bar nears its end without reaching it.
      progress.update(1.0 - 1.0 / (1.0 + growth_.rounds));
    }
    expect_costly(
        [&] {
          return certify::bad_columns(plan_.front, growth_.lines).empty() &&
                 certify::front_intersections(certify::front_surface(plan_.front, growth_.lines)).empty();
        },
        "the certificate of all columns and the whole front to hold where that of what changed does");
  }

 private:
  /// Vertices lowered because a part of the certificate failed; nullopt if all of it holds.
  std::optional<std::vector<VertexId>> one_round() {
    if (is_first_ || !changed_columns_.empty()) {
      const auto bad = certify::bad_columns(plan_.front, growth_.lines, changed_columns_);
      is_first_ = false;
      changed_columns_.clear();
      if (!bad.empty()) return shrinker_.shrink(growth_.lines, bad);
    }
    certify::FrontSurface front = certify::front_surface(plan_.front, growth_.lines);
    if (wall_.has_planes()) {
      auto wrong = certify::turned_sides(plan_.front, growth_.lines, *wall_.planes, front);
      if (wrong.empty()) wrong = certify::close_front(plan_.front, *wall_.planes, front);
      if (!wrong.empty() || !front.is_closed) return shrinker_.shrink(front, with_themselves(wrong));
    }
    const bool all = std::find(front_changed_.begin(), front_changed_.end(), 0) == front_changed_.end();
    const auto intersections =
        certify::front_intersections(front, all ? std::span<const char>() : std::span<const char>(front_changed_));
    std::fill(front_changed_.begin(), front_changed_.end(), 0);
    if (!intersections.empty()) return shrinker_.shrink(front, intersections);
    const auto wrong = certify::covered_twice(plan_.front, front, component_, wall_.fluid_is_inside);
    if (!wrong.empty()) return shrinker_.shrink(front, wrong, component_);
    return std::nullopt;
  }

  static std::vector<std::pair<FrontFaceId, FrontFaceId>> with_themselves(const std::vector<FrontFaceId>& faces) {
    std::vector<std::pair<FrontFaceId, FrontFaceId>> pairs;
    for (const FrontFaceId f : faces) pairs.emplace_back(f, f);
    return pairs;
  }

  /// Blocks the whole of each component that one of the vertices lies on.
  std::vector<VertexId> with_their_components(const std::vector<VertexId>& failed) {
    const auto component_of = [&](VertexId v) {
      return component_[mesh::Topology::face(wall_.topology.fan(v).front())].index();
    };
    std::set<std::uint32_t> components;
    for (const VertexId v : failed) components.insert(component_of(v));
    std::vector<VertexId> blocked;
    for (const VertexId v : field_.thickness.ids()) {
      if (wall_.topology.fan(v).empty() || !components.contains(component_of(v))) continue;
      field_.lower(v, 0, mesh::LimitReason::Quality);
      blocked.push_back(v);
    }
    return blocked;
  }

  void lower(const std::vector<VertexId>& failed) {
    expect(!failed.empty(), "a failed certificate to name a line that can still be lowered");
    const auto thinner = merged(failed, grade(wall_, field_, failed));
    const auto changed = merged(thinner, step_levels(wall_, stacks_, field_, thinner));
    update_lines(plan_, stacks_, changed, resolution_, field_, growth_.lines);
    mark_changed(changed);
  }

  void mark_changed(const std::vector<VertexId>& vertices) {
    const auto mark = [&](FrontFaceId f) {
      changed_columns_.push_back(f);
      front_changed_[f.index()] = 1;
    };
    for (const VertexId v : vertices) {
      for (const HalfedgeId h : wall_.topology.fan(v)) mark(FrontFaceId(mesh::Topology::face(h).index()));
      const auto [begin, end] =
          std::equal_range(virtual_faces_.begin(), virtual_faces_.end(), VirtualFace{v, {}}, by_vertex);
      for (auto face = begin; face != end; ++face) mark(face->face);
    }
    std::sort(changed_columns_.begin(), changed_columns_.end());
    changed_columns_.erase(std::unique(changed_columns_.begin(), changed_columns_.end()), changed_columns_.end());
  }

  const Wall& wall_;
  const LinePlan& plan_;
  const Stacks& stacks_;
  int patient_rounds_;
  VertexField& field_;
  Growth& growth_;
  Shrinker shrinker_;
  IdVector<FaceId, ComponentId> component_;
  std::vector<VirtualFace> virtual_faces_;
  double resolution_;
  bool is_first_ = true;
  std::vector<FrontFaceId> changed_columns_;
  std::vector<char> front_changed_;  // (n_front_faces) since the front was last looked at
};

/// Lengths of vertices that patches ask for: arrays that exist, values above zero wherever the patch is.
void check_lengths(const Wall& wall, const GrowOptions& options) {
  const mesh::SurfaceMesh& surface = wall.surface;
  std::vector<std::vector<VertexLength>> lengths(options.schedules.size());
  for (const PatchId p : options.schedules.ids()) {
    const PatchSchedule& s = options.schedules[p];
    if (!s.has_layers) continue;
    if (s.is_until_isotropic && s.total_thickness) {
      throw InputError(fmt::format("patch \"{}\": layers that stop when they are isotropic take no thickness",
                                   surface.patch_names[p]));
    }
    for (const auto& length : {s.first_height, s.total_thickness}) {
      if (!length) continue;
      if (length->array && (*length->array >= surface.point_arrays.size() ||
                            surface.point_arrays[*length->array].values.size() != surface.points.size())) {
        throw InputError(fmt::format("patch \"{}\": no point array {} with a value for each vertex",
                                     surface.patch_names[p], *length->array));
      }
      lengths[p.index()].push_back(*length);
    }
  }
  for (const FaceId f : surface.faces.ids()) {
    for (const VertexLength& length : lengths[surface.face_patch[f].index()]) {
      for (const VertexId v : surface.faces[f]) {
        const double value = length.factor * (length.array ? surface.point_arrays[*length.array].values[v] : 1.0);
        if (value > 0 && std::isfinite(value)) continue;
        throw InputError(fmt::format("patch \"{}\" asks for a length of {} at vertex {}; expected more than 0",
                                     surface.patch_names[surface.face_patch[f]], value, v.index()));
      }
    }
  }
}

void check_options(const Wall& wall, const GrowOptions& options) {
  if (!(options.multi_angle > 0 && options.multi_angle < geometry::kPi)) {
    throw InputError(fmt::format("multi_angle: expected an angle between 0 and 180 degrees, found {}",
                                 geometry::to_degrees(options.multi_angle)));
  }
  if (!(options.max_turn >= kLeastMaxTurn && options.max_turn <= geometry::kPi / 2)) {
    throw InputError(fmt::format("max_turn: expected an angle from 1 to 90 degrees, found {}",
                                 geometry::to_degrees(options.max_turn)));
  }
  if (options.patient_rounds < 0) {
    throw InputError(fmt::format("patient_rounds: expected 0 or more, found {}", options.patient_rounds));
  }
  if (options.schedules.size() != wall.surface.patch_names.size()) {
    throw InputError(fmt::format("{} schedules for {} patches: give one for each", options.schedules.size(),
                                 wall.surface.patch_names.size()));
  }
  for (const PatchSchedule& s : options.schedules) {
    const bool is_sound = std::all_of(s.heights.begin(), s.heights.end(), [](double h) { return h > 0; });
    if (s.has_layers && (s.heights.empty() || s.heights.size() >= std::numeric_limits<Level>::max() || !is_sound)) {
      throw InputError("a patch with layers needs 1 to 65534 heights, all of them above zero");
    }
    if (s.max_level_step && *s.max_level_step < 1) {
      throw InputError(fmt::format("max_level_step: expected 1 or more, found {}", *s.max_level_step));
    }
  }
  check_lengths(wall, options);
}

void record(const Stacks& stacks, const VertexField& field, Growth& growth) {
  const std::size_t n = growth.front.n_lines();
  growth.asked_thickness.resize(n);
  growth.asked_levels.resize(n);
  growth.asked_first_height.resize(n);
  growth.reached_thickness.resize(n);
  growth.reason.resize(n);
  for (const LineId line : growth.front.line_vertex.ids()) {
    const VertexId v = growth.front.line_vertex[line];
    growth.asked_thickness[line] = field.asked[v];
    growth.asked_levels[line] = field.levels[v];
    growth.asked_first_height[line] = stacks.first_height(field.request(v));
    growth.reached_thickness[line] = field.reached[v];
    const bool is_as_asked = field.reason[v] == mesh::LimitReason::None;
    growth.reason[line] = is_as_asked && field.ends_isotropic[v] ? mesh::LimitReason::Isotropic : field.reason[v];
  }
}

}  // namespace

IdVector<FaceId, ComponentId> wetted_components(const Wall& wall) {
  auto component = mesh::connected_components(wall.topology);
  for (const FaceId f : component.ids()) {
    if (!wall.is_wetted[f]) component[f] = ComponentId();
  }
  return component;
}

IdVector<VertexId, Level> asked_levels(const Wall& wall, const GrowOptions& options) {
  check_options(wall, options);
  return ask(wall, options, Stacks(options.schedules)).levels;
}

Growth grow(const Wall& wall, const GrowOptions& options, ProgressSink& progress) {
  check_options(wall, options);
  const Stacks stacks(options.schedules);
  VertexField field = ask(wall, options, stacks);
  Growth growth;

  progress.begin_stage("lines");
  Layout layout = best_layout(wall, options, field);
  LinePlan plan = std::move(layout.plan);
  field = std::move(layout.field);
  growth.normals = std::move(layout.normals);
  growth.smoothing_iterations = layout.sweeps;
  progress.end_stage();

  progress.begin_stage("layers");
  step_levels(wall, stacks, field, {});
  growth.lines = make_lines(wall, plan, stacks, field);
  Settling(wall, plan, stacks, options.patient_rounds, field, growth).run(progress);
  growth.front = std::move(plan.front);
  record(stacks, field, growth);
  progress.end_stage();
  return growth;
}

}  // namespace nearwall::layers
