#include "pipeline/patch_schedules.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"
#include "nearwall/layers/isotropic.h"

namespace nearwall::pipeline {

namespace {

using layers::VertexLength;
using spacing::Schedule;
using spacing::ScheduleRequest;

void check_flow(const Case& settings) {
  const auto& flow = settings.flow;
  std::vector<std::string> missing;
  if (!flow || flow->velocity == 0) missing.emplace_back("velocity");
  if (!flow || flow->kinematic_viscosity == 0) missing.emplace_back("kinematic_viscosity");
  if (!flow || flow->reference_length == 0) missing.emplace_back("reference_length");
  if (!missing.empty()) {
    throw InputError(
        fmt::format("y_plus needs [flow] with velocity, kinematic_viscosity and reference_length; missing: {}",
                    fmt::join(missing, ", ")));
  }
}

/// All that is a number.
ScheduleRequest request_of(const Case& settings, const LayerSettings& s) {
  ScheduleRequest request;
  request.law = s.law_in_force();
  request.first_height = s.first_height;
  if (s.y_plus) {
    if (s.first_height || s.first_height_array) {
      throw InputError("first_height and y_plus exclude each other; leave out one");
    }
    check_flow(settings);
    request.first_height = spacing::first_cell_height(*settings.flow, *s.y_plus);
  }
  request.growth = s.growth;
  request.count = s.count;
  request.total_thickness = s.total_thickness;
  request.heights = s.heights;
  const bool has_acceleration = s.constant_layers || s.acceleration || s.largest_growth;
  if (has_acceleration && request.law != spacing::Law::Accelerating) {
    throw InputError(
        fmt::format("constant_layers, acceleration and largest_growth are for the law \"accelerating\", the law "
                    "is \"{}\"",
                    law_name(request.law)));
  }
  request.constant_layers = s.constant_layers.value_or(request.constant_layers);
  request.acceleration = s.acceleration.value_or(request.acceleration);
  request.largest_growth = s.largest_growth.value_or(request.largest_growth);
  return request;
}

void check_until(const LayerSettings& s) {
  if (s.until != Until::Isotropic) return;
  if (s.has_total_thickness()) {
    throw InputError(
        "until = \"isotropic\" and total_thickness exclude each other: the layers are as thick as their triangles make "
        "them; leave out one (count = … bounds their number)");
  }
  if (!s.has_first_height() && s.heights.empty()) {
    throw InputError("until = \"isotropic\" needs first_height (or y_plus with [flow])");
  }
  if (s.law_in_force() == spacing::Law::Tanh) {
    throw InputError(
        "until = \"isotropic\" cannot be had with the law \"tanh\", whose heights depend on the count; take "
        "\"geometric\" or \"accelerating\"");
  }
}

/// The heights of one patch whose vertices have a say.
class VertexSchedule {
 public:
  VertexSchedule(const ScheduleRequest& request, const LayerSettings& layers, const PatchVertices& patch)
      : request_(request), patch_(patch) {
    first_ = length_of(layers.first_height_array, request.first_height);
    total_ = length_of(layers.total_thickness_array, request.total_thickness);
  }

  void set(bool until_isotropic, PatchSettings& to) const {
    if (until_isotropic) {
      to.schedule = isotropic();
      to.is_until_isotropic = true;
    } else if (first_ && total_) {
      to.schedule = between_both();
      to.total_thickness = total_;
    } else {
      to.schedule = scaled();
      to.total_thickness = total_;
    }
    if (first_ && (first_->array || total_)) to.first_height = first_;
    to.largest_thickness = total_ ? largest(*total_) : to.schedule.total_thickness;
  }

 private:
  std::optional<VertexLength> length_of(const std::optional<ArrayLength>& array, std::optional<double> number) const {
    if (!array) return number ? std::optional(VertexLength{std::nullopt, *number}) : std::nullopt;
    const auto place = std::find(patch_.arrays.begin(), patch_.arrays.end(), array->array);
    expect(place != patch_.arrays.end(), "the surface to have the arrays of the case");
    return VertexLength{static_cast<std::size_t>(place - patch_.arrays.begin()), array->factor};
  }

  double value(const VertexLength& length, VertexId v) const {
    return length.array ? patch_.surface.point_arrays[*length.array].values[v] * length.factor : length.factor;
  }

  double largest(const VertexLength& length) const {
    double most = 0;
    for (const VertexId v : patch_.vertices) most = std::max(most, value(length, v));
    return most;
  }

  /// The stack of the largest value: those of all vertices have its form.
  Schedule scaled() const {
    ScheduleRequest request = request_;
    // A table has its own first height, which the vertices scale.
    if (request.law != spacing::Law::Table && first_) request.first_height = largest(*first_);
    if (request.law != spacing::Law::Table && total_) request.total_thickness = largest(*total_);
    return spacing::solve_schedule(request);
  }

  /// The stack of the vertex that has to grow most: those of the others are flatter.
  Schedule between_both() const {
    const auto ratio = [&](VertexId v) { return value(*total_, v) / value(*first_, v); };
    VertexId steepest = patch_.vertices.front();
    for (const VertexId v : patch_.vertices) {
      if (ratio(v) > ratio(steepest)) steepest = v;
    }
    try {
      return request_.law == spacing::Law::Table ? table_for(ratio(steepest)) : grown(steepest);
    } catch (const InputError& e) {
      const Vec3& p = patch_.surface.points[steepest];
      throw InputError(
          fmt::format("at ({:.6g}, {:.6g}, {:.6g}), where first_height is {:.6g} and total_thickness {:.6g}: {}", p.x(),
                      p.y(), p.z(), value(*first_, steepest), value(*total_, steepest), e.what()));
    }
  }

  Schedule grown(VertexId steepest) const {
    ScheduleRequest request = request_;
    request.first_height = value(*first_, steepest);
    request.total_thickness = value(*total_, steepest);
    // Too thin for its layers even there: uniform ones, which each vertex makes as thin as it wants them.
    const int least = request.count.value_or(1);
    if (!(*request.total_thickness > least * *request.first_height) && !(request.count && request.growth)) {
      request.total_thickness.reset();
      request.growth = 1;
      request.count = least;
    }
    return spacing::solve_schedule(request);
  }

  Schedule table_for(double ratio) const {
    ScheduleRequest request = request_;
    request.first_height.reset();
    request.total_thickness.reset();
    Schedule table = spacing::solve_schedule(request);
    const double most = table.total_thickness / table.first_height;
    if (ratio > most * (1 + kTypedDigits)) {
      throw InputError(
          fmt::format("heights: the table is {:.6g} times as thick as its first layer, {:.6g} times is asked for; give "
                      "a table that grows more",
                      most, ratio));
    }
    return table;
  }

  /// As many layers as it takes for the last one to be as high as the widest triangles want it.
  Schedule isotropic() const {
    double widest = 0;  // over the first height
    for (const VertexId v : patch_.vertices) {
      widest = std::max(widest, patch_.isotropic_heights[v] / (first_ ? value(*first_, v) : 1.0));
    }
    ScheduleRequest request = request_;
    if (request.law == spacing::Law::Table) {
      const double first = first_ ? request.heights.front() : 1.0;
      request.first_height.reset();
      request.heights.resize(layers::isotropic_level(request.heights, widest * first));
      return spacing::solve_schedule(request);
    }
    request.first_height = largest(*first_);
    const int most = request_.count.value_or(spacing::kMaxCount);
    for (int count = std::min(kFirstTrial, most);; count = std::min(2 * count, most)) {
      request.count = count;
      const std::vector<double> heights = spacing::solve_schedule(request).heights;
      const int level = layers::isotropic_level(heights, widest * *request.first_height);
      if (level == count && count < most) continue;
      if (level == spacing::kMaxCount && !request_.count) {
        throw InputError(fmt::format(
            "until = \"isotropic\": {} layers are not enough to become {:.3g} times as high as the first one; "
            "raise growth or first_height, or bound them by count",
            level, widest));
      }
      request.count = std::min(std::max(level, kLeastCount), most);
      return spacing::solve_schedule(request);
    }
  }

  /// As in a schedule of numbers: figures are typed with a few digits.
  static constexpr double kTypedDigits = 1e-4;
  static constexpr int kFirstTrial = 16;  ///< layers; doubled until they are enough
  static constexpr int kLeastCount = 2;   ///< layers, so that a line may start one late

  const ScheduleRequest& request_;
  const PatchVertices& patch_;
  std::optional<VertexLength> first_, total_;
};

/// Adds the place to what is wrong with a schedule.
template <class Action>
void at_place(const Case& settings, const LayerSettings& layers, const std::string& table, Action&& action) {
  try {
    action();
  } catch (const InputError& e) {
    throw InputError(fmt::format("{}: {}: {}", place_of(settings, layers), table, e.what()));
  }
}

}  // namespace

std::string place_of(const Case& settings, const LayerSettings& layers) {
  return layers.where.empty() ? settings.file.string() : layers.where;
}

bool needs_vertices(const LayerSettings& layers) {
  return layers.first_height_array || layers.total_thickness_array || layers.until == Until::Isotropic;
}

void set_schedule(const Case& settings, const LayerSettings& layers, const std::string& table,
                  const PatchVertices& patch, PatchSettings& to) {
  at_place(settings, layers, table, [&] {
    const ScheduleRequest request = request_of(settings, layers);
    check_until(layers);
    if (!patch.vertices.empty()) {
      VertexSchedule(request, layers, patch).set(layers.until == Until::Isotropic, to);
      return;
    }
    to.schedule = spacing::solve_schedule(request);
    to.largest_thickness = to.schedule.total_thickness;
  });
}

void check_schedule(const Case& settings, const LayerSettings& layers, const std::string& table) {
  at_place(settings, layers, table, [&] {
    ScheduleRequest request = request_of(settings, layers);
    check_until(layers);
    if (!needs_vertices(layers)) {
      spacing::solve_schedule(request);
      return;
    }
    // In place of what the vertices will say: lengths that agree with anything. With both of them nothing can be said.
    const bool has_both = layers.has_first_height() && layers.has_total_thickness();
    if (request.law == spacing::Law::Table) {
      request.first_height.reset();
      request.total_thickness.reset();
    } else if (layers.first_height_array && !has_both) {
      request.first_height = 1;
    } else if (layers.total_thickness_array && !has_both) {
      request.total_thickness = 1;
    }
    if (!has_both) {
      spacing::solve_schedule(request);
    } else if (request.growth && request.count) {
      throw InputError(
          "any three of first_height, growth, count and total_thickness determine the fourth; leave out one");
    }
  });
}

}  // namespace nearwall::pipeline
