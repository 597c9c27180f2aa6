#include "nearwall/surface/iterative_normals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/arctangent.h"
#include "surface/normals_visible.h"
#include "surface/scratch.h"
#include "surface/unit_normals.h"

namespace nearwall::surface {

namespace {

/// Equation numbers are those of docs/theory/iterative-normals.md.

/// A mean of unit vectors shorter than this has lost half of its digits.
constexpr double kCancelled = 0x1p-26;

/// Shares of the limits (10) and (13) that are taken where no relaxation is asked for: of those tried, the ones that
/// needed fewest steps. The theory page has the figures.
constexpr double kShareOfTurn = 0.9;
constexpr double kShareOfCorrection = 0.75;

/// Gain of two normals at 79.8 degrees from their middle: where it is larger, the weights are damped as well.
constexpr double kLargestGain = 4;

/// Unit normals with a weight each, and their angles to a direction.
class WeightedFan {
 public:
  explicit WeightedFan(std::size_t n) : units_(n), weights_(n), chords_(n), angles_(n) {}

  void add(const Vec3& unit) {
    units_.add(unit);
    weights_.add(1.0);
    chords_.add(0.0);
    angles_.add(0.0);
  }
  std::size_t size() const { return units_.all().size(); }
  std::span<const Vec3> units() const { return units_.all(); }
  std::span<double> weights() { return weights_.all(); }
  std::span<const double> weights() const { return weights_.all(); }
  std::span<const double> angles() const { return angles_.all(); }

  /// sin(a) / a for the angle a to normal i.
  double sine_over_angle(std::size_t i) const {
    const double half_chord = std::min(1.0, 0.5 * chords_.all()[i]);
    return half_chord > 0 ? 2.0 * half_chord * std::sqrt(1.0 - half_chord * half_chord) / angles()[i] : 1.0;
  }

  /// Measures the angles to `direction`. \returns the largest one
  double measure(const Vec3& direction) {
    double worst = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      const double chord = norm(units()[i] - direction);
      chords_.all()[i] = chord;
      angles_.all()[i] = geometry::angle_of_chord(chord * chord);
      worst = std::max(worst, angles()[i]);
    }
    return worst;
  }

  /// Scales the weights to the sum 1. \returns whether there is any weight left
  bool normalise() {
    double sum = 0;
    for (const double weight : weights()) sum += weight;
    if (!(sum > 0)) return false;
    for (double& weight : weights()) weight /= sum;
    return true;
  }

 private:
  Scratch<Vec3> units_;
  Scratch<double> weights_, chords_, angles_;
};

struct Mean {
  Vec3 direction;          ///< unit vector
  double size = 0;         ///< length of the mean of the unit normals
  double lower_bound = 0;  ///< no direction has a smaller worst angle [rad], Eq. (4)
};

Mean mean_of(const WeightedFan& fan) {
  Vec3 sum;
  for (std::size_t i = 0; i < fan.size(); ++i) sum += fan.units()[i] * fan.weights()[i];
  double spread = 0;
  for (std::size_t i = 0; i < fan.size(); ++i) spread += fan.weights()[i] * squared_norm(fan.units()[i] - sum);
  const double size = norm(sum);
  return {size > kCancelled ? sum / size : Vec3{}, size, geometry::angle_from(std::sqrt(spread), size)};
}

/// Gain of two normals at the same angle from their middle, Eq. (8), for two that are far apart: the one farthest from
/// `mean` and the one farthest from that.
double gain_of_extremes(std::span<const Vec3> units, const Vec3& mean) {
  const auto farthest_from = [&](const Vec3& from) {
    return *std::max_element(units.begin(), units.end(), [&](const Vec3& a, const Vec3& b) {
      return squared_norm(a - from) < squared_norm(b - from);
    });
  };
  const Vec3 first = farthest_from(mean);
  const double sine = std::min(1.0, 0.5 * norm(farthest_from(first) - first));
  const double cosine = std::sqrt(1.0 - sine * sine);
  return sine > 0 && sine < 1 ? sine / (cosine * geometry::angle_from(sine, cosine)) : 1.0;
}

/// Section 3 of the paper, Eq. (5), with the weights damped as in Eq. (11) if the relaxation is chosen here.
class MultipliedWeights {
 public:
  explicit MultipliedWeights(std::optional<double> relaxation) : relaxation_(relaxation) {}

  bool correct(WeightedFan& fan, const Mean& mean, double worst_angle, double least_gain) {
    const double kappa = relaxation_ ? 0.0 : std::max(gain(fan, mean), least_gain);
    const double damped = std::min(kappa, kLargestGain);
    turn_ = relaxation_ ? *relaxation_ : std::min(1.0, kShareOfTurn * largest_stable_turn(damped));
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const double ratio = fan.angles()[i] / worst_angle;
      fan.weights()[i] *= damped < kappa ? std::pow(ratio, damped / kappa) : ratio;
    }
    return fan.normalise();
  }
  Vec3 next(const Vec3& direction, const Mean& mean) const {
    return unit_vector(mean.direction * turn_ + direction * (1.0 - turn_));
  }

 private:
  /// Eq. (7), with the angles last measured.
  static double gain(const WeightedFan& fan, const Mean& mean) {
    double sum = 0;
    for (std::size_t i = 0; i < fan.size(); ++i) sum += fan.weights()[i] * fan.sine_over_angle(i);
    return sum / mean.size;
  }
  /// Eq. (10).
  static double largest_stable_turn(double gain) { return 2.0 / (1.0 + 0.5 * gain); }

  std::optional<double> relaxation_;
  double turn_ = 1;
};

/// Pirzadeh's predictor and corrector, Eq. (12): the direction is the mean.
class CorrectedWeights {
 public:
  explicit CorrectedWeights(std::optional<double> relaxation) : relaxation_(relaxation) {}

  bool correct(WeightedFan& fan, const Mean& mean, double, double least_gain) {
    double mean_angle = 0;
    for (std::size_t i = 0; i < fan.size(); ++i) mean_angle += fan.weights()[i] * fan.angles()[i];
    if (!(mean_angle > 0)) return false;
    const double relaxation = relaxation_ ? *relaxation_ : chosen(fan, mean, mean_angle, least_gain);
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const double correction = relaxation * (fan.angles()[i] - mean_angle) / mean_angle;
      fan.weights()[i] = std::max(0.0, fan.weights()[i] + correction);
    }
    return fan.normalise();
  }
  Vec3 next(const Vec3&, const Mean& mean) const { return mean.direction; }

 private:
  /// A share of the limit (13), over the faces whose weights can change.
  static double chosen(const WeightedFan& fan, const Mean& mean, double mean_angle, double least_gain) {
    double sum = 0, n_changing = 0;
    for (std::size_t i = 0; i < fan.size(); ++i) {
      if (!(fan.weights()[i] > 0) && !(fan.angles()[i] > mean_angle)) continue;
      sum += fan.sine_over_angle(i);
      n_changing += 1;
    }
    return 2.0 * kShareOfCorrection / std::max(sum / mean.size, n_changing * least_gain);
  }

  std::optional<double> relaxation_;
};

void check(const char* name, const IterationOptions& options) {
  const double relaxation = options.relaxation.value_or(1.0);
  if (!(relaxation > 0) || !std::isfinite(relaxation)) {
    throw InputError(fmt::format("{}: expected a relaxation above 0, found {}", name, relaxation));
  }
  if (!(options.tolerance > 0)) {
    throw InputError(fmt::format("{}: expected a tolerance above 0, found {}", name, options.tolerance));
  }
  if (options.max_iterations < 0) {
    throw InputError(fmt::format("{}: expected 0 iterations or more, found {}", name, options.max_iterations));
  }
}

template <class Correction>
IterativeNormal iterate(const char* name, std::span<const Vec3> normals, const IterationOptions& options,
                        Correction correction) {
  check(name, options);
  WeightedFan fan(normals.size());
  for_each_unit_normal(name, normals, [&](const Vec3&, const Vec3& unit) { fan.add(unit); });
  if (!fan.normalise()) return {{}, geometry::kPi / 2, 0, false};
  Mean mean = mean_of(fan);
  const double least_gain = gain_of_extremes(fan.units(), mean.direction);
  // Normals that cancel have no mean to start from: any direction is as good, and none sees them all.
  IterativeNormal normal{mean.size > kCancelled ? mean.direction : fan.units()[0]};
  for (;;) {
    normal.max_angle = fan.measure(normal.direction);
    normal.has_converged = normal.max_angle - mean.lower_bound <= options.tolerance;
    if (normal.has_converged || normal.n_iterations == options.max_iterations || !(mean.size > kCancelled)) break;
    if (!correction.correct(fan, mean, normal.max_angle, least_gain)) break;
    mean = mean_of(fan);
    if (!(mean.size > kCancelled)) break;
    normal.direction = correction.next(normal.direction, mean);
    ++normal.n_iterations;
  }
  const double squared_chord = squared_chord_to_worst(normal.direction, fan.units());
  normal.max_angle = judged(normal.direction, fan.units(), squared_chord).max_angle;
  return normal;
}

}  // namespace

IterativeNormal iterative_normal(std::span<const Vec3> normals, const IterationOptions& options) {
  return iterate("iterative_normal", normals, options, MultipliedWeights(options.relaxation));
}

IterativeNormal pirzadeh_normal(std::span<const Vec3> normals, const IterationOptions& options) {
  return iterate("pirzadeh_normal", normals, options, CorrectedWeights(options.relaxation));
}

}  // namespace nearwall::surface
