#include "pipeline/length_warnings.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "nearwall/pipeline/report.h"

namespace nearwall::pipeline {

namespace {

/// As in a schedule of numbers: figures are typed with a few digits.
constexpr double kTypedDigits = 1e-4;

/// Where something is too large.
struct Excess {
  double percent = 0;  ///< of the area
  VertexId worst;      ///< invalid: nowhere
};

class Lengths {
 public:
  Lengths(const PatchSettings& settings, const PatchVertices& patch, std::span<const FaceId> faces)
      : settings_(settings), patch_(patch), faces_(faces) {}

  std::vector<std::string> warnings() const {
    std::vector<std::string> all;
    if (settings_.is_until_isotropic) {
      warn_of_high_first_layers(all);
      warn_of_too_few_layers(all);
    } else if (settings_.first_height && settings_.total_thickness) {
      warn_of_thin_layers(all);
    }
    return all;
  }

 private:
  double value(const layers::VertexLength& length, VertexId v) const {
    return length.array ? patch_.surface.point_arrays[*length.array].values[v] * length.factor : length.factor;
  }
  double first(VertexId v) const {
    return settings_.first_height ? value(*settings_.first_height, v) : settings_.schedule.first_height;
  }
  double last(VertexId v) const {
    const spacing::Schedule& s = settings_.schedule;
    return s.heights.back() * (first(v) / s.first_height);
  }

  /// Where `ratio` of a vertex is above `most`. A vertex has a third of each triangle.
  template <class Ratio>
  Excess where(double most, Ratio&& ratio) const {
    Excess excess;
    double all = 0, above = 0;
    for (const FaceId f : faces_) {
      const auto [a, b, c] = patch_.surface.triangle(f);
      const double third = norm(cross(b - a, c - a)) / 3;
      for (const VertexId v : patch_.surface.faces[f]) {
        all += third;
        if (!(ratio(v) > most)) continue;
        above += third;
        if (!excess.worst.is_valid() || ratio(v) > ratio(excess.worst)) excess.worst = v;
      }
    }
    constexpr double kPercent = 100;
    excess.percent = all > 0 ? kPercent * above / all : 0;
    return excess;
  }

  std::string at(const Excess& excess) const {
    const Vec3& p = patch_.surface.points[excess.worst];
    return fmt::format("on {} % of the area, most at ({:.6g}, {:.6g}, {:.6g})", percent_in_words(excess.percent), p.x(),
                       p.y(), p.z());
  }

  void warn_of_thin_layers(std::vector<std::string>& all) const {
    const int count = settings_.schedule.count;
    const Excess thin =
        where(1 + kTypedDigits, [&](VertexId v) { return count * first(v) / value(*settings_.total_thickness, v); });
    if (!thin.worst.is_valid()) return;
    const double total = value(*settings_.total_thickness, thin.worst);
    all.push_back(fmt::format(
        "total_thickness is less than {} layers of first_height {}, where first_height is {:.4g} and total_thickness "
        "{:.4g}. There the layers are uniform and first heights lower ({:.4g}), and the report takes these as asked; "
        "raise total_thickness, or lower first_height or count",
        count, at(thin), first(thin.worst), total, total / count));
  }

  /// Half a step of the schedule, as a ratio: no other layer would come closer.
  double half_step() const { return std::sqrt(settings_.schedule.growth) * (1 + kTypedDigits); }

  void warn_of_high_first_layers(std::vector<std::string>& all) const {
    const Excess high = where(half_step(), [&](VertexId v) { return first(v) / patch_.isotropic_heights[v]; });
    if (!high.worst.is_valid()) return;
    all.push_back(
        fmt::format("until = \"isotropic\": the first layer is higher already than layers that are isotropic {}, where "
                    "it is {:.4g} and its triangles ask for {:.4g}; lower first_height, or make the surface coarser",
                    at(high), first(high.worst), patch_.isotropic_heights[high.worst]));
  }

  void warn_of_too_few_layers(std::vector<std::string>& all) const {
    const Excess low = where(half_step(), [&](VertexId v) { return patch_.isotropic_heights[v] / last(v); });
    if (!low.worst.is_valid()) return;
    const bool is_table = settings_.schedule.law == spacing::Law::Table;
    all.push_back(fmt::format(
        "until = \"isotropic\": {} layers end before they are isotropic {}, where the last is {:.4g} high and its "
        "triangles ask for {:.4g}; {}",
        settings_.schedule.count, at(low), last(low.worst), patch_.isotropic_heights[low.worst],
        is_table ? "give more heights" : "raise count, growth or first_height, or leave count out"));
  }

  const PatchSettings& settings_;
  const PatchVertices& patch_;
  std::span<const FaceId> faces_;
};

}  // namespace

std::vector<std::string> length_warnings(const PatchSettings& settings, const PatchVertices& patch,
                                         std::span<const FaceId> faces) {
  return Lengths(settings, patch, faces).warnings();
}

}  // namespace nearwall::pipeline
