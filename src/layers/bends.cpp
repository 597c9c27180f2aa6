#include "bends.h"

#include <algorithm>

#include "nearwall/core/parallel.h"

namespace nearwall::layers {

namespace {

/// b: the smaller, the more sudden. With 0.3 a line that ends up leaning by 60 degrees lengthens its steps by at most 6
/// % from one layer to the next where layers grow by 1.2.
constexpr double kSlowness = 0.3;

/// A line is followed from this share of its thickness on, in steps of this ratio.
constexpr double kLowest = 1.0 / 256;
constexpr double kStep = 1.05;

/// … and gets a knot where it has changed its speed by so much of it since the last one.
constexpr double kLeastTurn = 0.05;

double share(double x) { return x < 1 ? (1 + kSlowness) * x / (x + kSlowness) : 1.0; }

/// The line that sharp knots stand for.
class Curve {
 public:
  Curve(const Vec3& foot, const std::vector<Knot>& knots) : foot_(foot), knots_(knots) {}

  Vec3 at(double thickness) const {
    Vec3 chord = foot_, below = foot_;
    for (const Knot& knot : knots_) {
      const Vec3 own = knot.offset / knot.at;
      chord += (own - below) * share(thickness / knot.at);
      below = own;
    }
    return chord * thickness;
  }

 private:
  Vec3 foot_;
  const std::vector<Knot>& knots_;
};

/// \param top  the thickness up to which it is needed
std::vector<Knot> rounded(const Vec3& foot, const std::vector<Knot>& knots, double top) {
  const Curve curve(foot, knots);
  std::vector<Knot> round;
  Knot candidate{kLowest * top, curve.at(kLowest * top)};
  Vec3 speed = candidate.offset / candidate.at;
  for (double t = kStep * candidate.at; t < top; t *= kStep) {
    const Knot next{t, curve.at(t)};
    const Vec3 step = (next.offset - candidate.offset) / (next.at - candidate.at);
    if (squared_norm(step - speed) > kLeastTurn * kLeastTurn * squared_norm(speed)) {
      round.push_back(candidate);
      speed = step;
    }
    candidate = next;
  }
  round.push_back({top, curve.at(top)});
  return round;
}

}  // namespace

void round_bends(const VertexField& field, LinePlan& plan) {
  parallel_for(plan.bends.size(), [&](std::size_t i) {
    const LineId line(i);
    if (!plan.is_bent(line)) return;
    const double top = field.thickness[plan.front.line_vertex[line]];
    plan.bends[line] = rounded(plan.direction[line] * plan.stretch[line], plan.bends[line], top);
  });
}

}  // namespace nearwall::layers
