#include "nearwall/studies/bohdal.h"

#include <cmath>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/surface/fitted_normals.h"
#include "nearwall/surface/minimum_norm_network.h"
#include "studies/height_field.h"
#include "studies/interpolants.h"
#include "studies/stopwatch.h"
#include "studies/test_functions.h"

namespace nearwall::studies {

namespace {

using Normals = IdVector<VertexId, Vec3>;

constexpr std::size_t kPlaces = 2500;  // where interpolants are judged
const double kWidestCorner = geometry::to_radians(178);
const Vec3 kUp = {0, 0, 1};

Normals weighted_normals(const Graph& graph, const surface::NormalOptions& options) {
  Normals normals;
  for (const auto& n : surface::point_normals(graph.mesh, graph.topology, graph.features, options)) {
    normals.push_back(n.direction);
  }
  return normals;
}

/// Fits over the xy plane, the one that the heights are over; Max's normal where a fit has no answer.
Normals fitted_normals(const Graph& graph, surface::Fit fit, int n_rings, double& fallback_percent) {
  Normals normals = weighted_normals(graph, {.method = surface::NormalMethod::Max, .thin_angle = geometry::kPi});
  surface::Neighbourhood neighbourhood(graph.topology);
  std::vector<Vec3> neighbours;
  std::size_t n_fallbacks = 0;
  for (const VertexId v : graph.mesh.points.ids()) {
    neighbours.clear();
    for (const VertexId w : neighbourhood.of(v, n_rings)) neighbours.push_back(graph.mesh.points[w]);
    const auto fitted = surface::fitted_normal(fit, graph.mesh.points[v], kUp, neighbours);
    if (fitted) {
      normals[v] = *fitted;
    } else {
      ++n_fallbacks;
    }
  }
  fallback_percent = 100.0 * static_cast<double>(n_fallbacks) / static_cast<double>(normals.size());
  return normals;
}

Normals network_normals(const Graph& graph) {
  const Normals axes(graph.mesh.points.size(), kUp);
  return surface::minimum_norm_network_normals(graph.mesh, graph.topology, axes).direction;
}

bool trims_plane(BohdalRemoval removal) {
  return removal == BohdalRemoval::ThinInPlane || removal == BohdalRemoval::ThinAndUnsuitable;
}

surface::NormalOptions options_of(surface::NormalMethod method, BohdalRemoval removal) {
  surface::NormalOptions options{.method = method, .thin_angle = geometry::kPi};
  if (removal == BohdalRemoval::ThinInSpace) options.thin_angle = kWidestCorner;
  if (removal == BohdalRemoval::UnsuitableAtBoundary) options.unsuitable = surface::Unsuitable::DropAtBoundary;
  if (removal == BohdalRemoval::UnsuitableEverywhere || removal == BohdalRemoval::ThinAndUnsuitable) {
    options.unsuitable = surface::Unsuitable::DropEverywhere;
  }
  return options;
}

Normals estimated(const BohdalMethod& method, BohdalRemoval removal, const Graph& graph, double& fallback_percent) {
  if (method.method == surface::NormalMethod::Nielson) return network_normals(graph);
  if (const auto fit = surface::fit_of(method.method)) {
    return fitted_normals(graph, *fit, method.n_rings, fallback_percent);
  }
  return weighted_normals(graph, options_of(method.method, removal));
}

double normals_error_deg(const HeightField& field, const Normals& normals) {
  double sum = 0;
  for (const VertexId v : normals.ids()) {
    const Jet& f = field.truth[v.index()];
    const double error = geometry::to_degrees(geometry::angle_between(normals[v], {-f.dx, -f.dy, 1}));
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(normals.size()));
}

/// Judges interpolants of one height field at the same places.
class Judge {
 public:
  Judge(const HeightField& field, int function, std::uint64_t seed)
      : field_(field),
        splits_(powell_sabin_splits(field.points, field.triangles)),
        places_(random_places(field, kPlaces, seed)) {
    for (const Place& place : places_) truth_.push_back(test_function(function, place.point.x, place.point.y).value);
  }

  struct Errors {
    double clough_tocher, powell_sabin;
  };

  /// \param gradients  (n_points)
  Errors errors(const std::vector<Point2>& gradients) const {
    double clough = 0, powell = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const auto& [t, p] = places_[i];
      const HermiteTriangle triangle = hermite(field_.triangles[t], gradients);
      const double of_clough = clough_tocher(triangle, p).value - truth_[i];
      const double of_powell = powell_sabin(triangle, splits_[t], p).value - truth_[i];
      clough += of_clough * of_clough, powell += of_powell * of_powell;
    }
    const auto n = static_cast<double>(places_.size());
    return {std::sqrt(clough / n), std::sqrt(powell / n)};
  }

 private:
  HermiteTriangle hermite(const Triangle2& t, const std::vector<Point2>& gradients) const {
    HermiteTriangle out{};
    for (std::size_t k = 0; k < 3; ++k) {
      out.corner[k] = field_.points[t[k]], out.value[k] = field_.truth[t[k]].value, out.gradient[k] = gradients[t[k]];
    }
    return out;
  }

  const HeightField& field_;
  std::vector<PowellSabinSplit> splits_;
  std::vector<Place> places_;
  std::vector<double> truth_;
};

std::vector<Point2> gradients_of(const Normals& normals) {
  std::vector<Point2> gradients;
  for (const Vec3& n : normals) gradients.push_back({-n.x() / n.z(), -n.y() / n.z()});
  return gradients;
}

std::vector<Point2> true_gradients(const HeightField& field) {
  std::vector<Point2> gradients;
  for (const Jet& f : field.truth) gradients.push_back({f.dx, f.dy});
  return gradients;
}

void check_function(int function) {
  if (function < 1 || function > kTestFunctions) {
    throw InputError(fmt::format("study bohdal: expected a function 1 to {}, found {}", kTestFunctions, function));
  }
}

void check_points(std::size_t n_points) {
  constexpr std::size_t kFewestPoints = 4;
  if (n_points < kFewestPoints) {
    throw InputError(fmt::format("study bohdal: expected at least {} points, found {}", kFewestPoints, n_points));
  }
}

}  // namespace

BohdalErrors bohdal_errors(int function, std::size_t n_points, std::uint64_t seed) {
  check_function(function);
  check_points(n_points);
  const HeightField field = height_field(function, n_points, seed);
  const Graph whole(field, field.triangles);
  const Graph trimmed(field, without_thin_boundary(field.points, field.triangles, kWidestCorner));
  const Judge judge(field, function, seed);

  BohdalErrors errors{.function = function, .n_points = n_points};
  for (std::size_t m = 0; m < kBohdalMethods.size(); ++m) {
    for (std::size_t r = 0; r < kBohdalRemovals.size(); ++r) {
      const auto removal = static_cast<BohdalRemoval>(r);
      const bool is_weight = surface::weight_of(kBohdalMethods[m].method).has_value();
      // Fits and the network know of no options here: only the triangles can be fewer.
      if (!is_weight && removal != BohdalRemoval::None && removal != BohdalRemoval::ThinInPlane) {
        errors.normals_deg[r][m] = std::nan("");
        continue;
      }
      double fallback_percent = 0;
      const Normals normals =
          estimated(kBohdalMethods[m], removal, trims_plane(removal) ? trimmed : whole, fallback_percent);
      errors.normals_deg[r][m] = normals_error_deg(field, normals);
      if (removal != BohdalRemoval::None) continue;
      const auto [clough, powell] = judge.errors(gradients_of(normals));
      errors.clough_tocher[m] = clough, errors.powell_sabin[m] = powell;
      errors.fallback_percent[m] = fallback_percent;
    }
  }
  const auto [clough, powell] = judge.errors(true_gradients(field));
  errors.clough_tocher_of_truth = clough, errors.powell_sabin_of_truth = powell;
  return errors;
}

std::array<double, kBohdalMethods.size()> bohdal_seconds(std::size_t n_points, std::uint64_t seed) {
  constexpr int kRepetitions = 5;
  check_points(n_points);
  const ThreadLimit one_thread(1);
  const HeightField field = height_field(1, n_points, seed);
  const Graph graph(field, field.triangles);
  std::array<double, kBohdalMethods.size()> seconds{};
  for (std::size_t m = 0; m < kBohdalMethods.size(); ++m) {
    std::vector<double> all(kRepetitions);
    double unused = 0;
    for (double& s : all) s = seconds_of([&] { estimated(kBohdalMethods[m], BohdalRemoval::None, graph, unused); });
    seconds[m] = median(all);
  }
  return seconds;
}

}  // namespace nearwall::studies
