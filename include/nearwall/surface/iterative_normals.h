#pragma once

#include <optional>
#include <span>

#include "nearwall/core/vec3.h"
#include "nearwall/surface/normals.h"

/// Earlier ways to a normal that sees all faces, to compare with `most_visible_normal`; equation numbers are those of
/// docs/theory/iterative-normals.md. In all of them normals may have
/// any length, zero vectors are passed over, and no memory is allocated for 24 normals or fewer. The same bits on
/// permuted axes and for normals scaled by powers of two.
namespace nearwall::surface {

/// The bisector normal: in the plane that bisects the two faces with the largest angle between their normals, the
/// middle of the directions that see all faces (Kallinderis & Ward 1992, as told by Aubry & Loehner 2008, section 2).
/// It sees all faces, but only for two of them is it always the direction that sees them best.
/// \returns  nullopt if no direction in that plane sees all faces (others may), or if there is no face
/// \throws   InputError if a normal is not finite.    Cost: O(n^2).
std::optional<VisibleNormal> kallinderis_normal(std::span<const Vec3> face_normals);

struct IterationOptions {
  /// Share of the correction that is taken, > 0: of the way to the mean, Eq. (5), or of the weights' change, Eq. (12).
  /// nullopt: at each step a share of what is stable, 0.9 of Eq. (10) and 0.75 of Eq. (13), so that it converges.
  std::optional<double> relaxation = std::nullopt;
  /// Largest excess of the worst angle over the smallest possible one [rad], > 0.
  double tolerance = 1e-4;
  int max_iterations = 300;  ///< >= 0
};

/// Where an iteration has stopped.
struct IterativeNormal {
  Vec3 direction;              ///< unit vector; zero without any normal
  double max_angle = 0;        ///< to the worst of the normals [rad]; pi / 2 or more if it does not see all of them
  int n_iterations = 0;        ///< steps taken
  bool has_converged = false;  ///< proven by a lower bound of the worst angle, Eq. (4)
};

/// Weighted mean whose weights are multiplied with the angles to the faces until the worst angle is smallest (Aubry &
/// Loehner 2008, section 3, put right in docs/theory/iterative-normals.md). With a fixed relaxation it converges on
/// sharp trailing edges only below the limit of Eq. (10) there.
/// \param normals  any number; where no direction sees all, or only in a cone open by less than 1e-7 rad, it does not
/// converge
/// \throws  InputError if a normal is not finite or an option is out of range.    Cost: O(n) for each step.
IterativeNormal iterative_normal(std::span<const Vec3> normals, const IterationOptions& options = {});

/// Weighted mean whose weights are corrected by how far each face's angle is from the mean angle (predictor and
/// corrector of Pirzadeh 1994, as read in docs/theory/iterative-normals.md). Otherwise as `iterative_normal`.
IterativeNormal pirzadeh_normal(std::span<const Vec3> normals, const IterationOptions& options = {});

}  // namespace nearwall::surface
