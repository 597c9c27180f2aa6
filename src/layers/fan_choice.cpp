#include <algorithm>
#include <numeric>

#include "cut_wall.h"
#include "layout.h"
#include "merit.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/measures.h"

namespace nearwall::layers {

namespace {

/// Turn of a convex ridge from which several lines are tried where its faces lack something.
constexpr double kTriedAngle = geometry::to_radians(60);

/// Share of the area round a network of ridges that has to be lacking before fans are tried there, and to be won before
/// they are kept: fans are cells, and late lines where they end.
constexpr double kLeastGain = 0.01;

/// Ridges that have one line each and might have several, in networks that hang together.
class Networks {
 public:
  Networks(const Wall& wall, const IdVector<HalfedgeId, char>& is_cut, const IdVector<HalfedgeId, char>& may_be_cut)
      : wall_(wall), root_(wall.surface.points.size()), is_on_(root_.size(), 0) {
    std::iota(root_.begin(), root_.end(), std::uint32_t{0});
    for (const HalfedgeId h : may_be_cut.ids()) {
      if (!may_be_cut[h] || is_cut[h] || wall.topology.twin(h) < h) continue;
      edges_.push_back(h);
      const VertexId a = wall.topology.origin(h), b = wall.topology.target(h);
      is_on_[a.index()] = is_on_[b.index()] = 1;
      const std::uint32_t of_a = of(a), of_b = of(b);
      root_[std::max(of_a, of_b)] = std::min(of_a, of_b);
    }
  }

  bool empty() const { return edges_.empty(); }

  /// For each network, by its number: the sum of a figure over the area of the faces that it touches.
  template <class Figure>
  std::vector<double> sum(const Figure& figure) const {
    std::vector<double> sums(root_.size(), 0.0);
    for (const FaceId f : wall_.surface.faces.ids()) {
      std::array<std::uint32_t, 3> networks{};
      std::size_t n = 0;
      for (const VertexId v : wall_.surface.faces[f]) {
        if (!is_on_[v.index()]) continue;
        const std::uint32_t network = of(v);
        if (std::find(networks.begin(), networks.begin() + n, network) == networks.begin() + n) networks[n++] = network;
      }
      if (n == 0) continue;
      const auto [a, b, c] = wall_.surface.triangle(f);
      const double value = geometry::triangle_area(a, b, c) * figure(f);
      for (std::size_t i = 0; i < n; ++i) sums[networks[i]] += value;
    }
    return sums;
  }

  /// The cuts with the edges of the networks for which `is_wanted(number)`.
  template <class IsWanted>
  IdVector<HalfedgeId, char> cuts_with(IdVector<HalfedgeId, char> is_cut, const IsWanted& is_wanted) const {
    for (const HalfedgeId h : edges_) {
      if (is_wanted(of(wall_.topology.origin(h)))) is_cut[h] = is_cut[wall_.topology.twin(h)] = 1;
    }
    return is_cut;
  }

 private:
  std::uint32_t of(VertexId v) const {
    std::uint32_t r = v.index();
    while (root_[r] != r) r = root_[r] = root_[root_[r]];
    return r;
  }

  const Wall& wall_;
  mutable std::vector<std::uint32_t> root_;  // union–find; paths are shortened on the way
  std::vector<char> is_on_;                  // (n_vertices)
  std::vector<HalfedgeId> edges_;
};

}  // namespace

Layout best_layout(const Wall& wall, const GrowOptions& options, const VertexField& asked) {
  Layout layout = lay_out(wall, options, asked, find_cuts(wall, options));
  if (!options.several_lines || !options.try_fans) return layout;
  GrowOptions eager = options;
  eager.multi_angle = std::min(options.multi_angle, kTriedAngle);
  const Networks networks(wall, layout.is_cut, find_cuts(wall, eager));
  if (networks.empty()) return layout;

  const auto kept_by = [&](const Layout& l, FaceId f) {
    const auto& corners = wall.surface.faces[f];
    const bool is_bare = std::none_of(corners.begin(), corners.end(), [&](VertexId v) { return asked.asked[v] > 0; });
    return is_bare ? 1.0 : merit(wall, l.plan, l.field, asked.asked, f);
  };
  const auto area = networks.sum([](FaceId) { return 1.0; });
  const auto lacking = networks.sum([&](FaceId f) { return 1 - kept_by(layout, f); });
  const auto is_tried = [&](std::uint32_t network) { return lacking[network] > kLeastGain * area[network]; };
  auto tried = networks.cuts_with(layout.is_cut, is_tried);
  shorten_cuts(wall, options, tried);
  if (tried == layout.is_cut) return layout;

  Layout trial = lay_out(wall, options, asked, tried);
  const auto gain = networks.sum([&](FaceId f) { return kept_by(trial, f) - kept_by(layout, f); });
  auto chosen = networks.cuts_with(layout.is_cut, [&](std::uint32_t network) {
    return is_tried(network) && gain[network] > kLeastGain * area[network];
  });
  shorten_cuts(wall, options, chosen);
  if (chosen == layout.is_cut) return layout;
  return chosen == tried ? std::move(trial) : lay_out(wall, options, asked, std::move(chosen));
}

}  // namespace nearwall::layers
