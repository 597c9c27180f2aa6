#pragma once

#include <optional>
#include <span>

#include "nearwall/core/vec3.h"
#include "nearwall/surface/normals.h"

/// Earlier ways to a normal that sees all faces, to compare with `most_visible_normal`; equation numbers are those of
/// docs/theory/iterative-normals.md. In all of them normals may have any length, zero vectors are passed over, and no
/// memory is allocated for 24 normals or fewer. The same bits on permuted axes and for normals scaled by powers of two.
namespace nearwall::surface {

/// The bisector normal: in the plane that bisects the two faces with the largest angle between their normals, the
/// middle of the directions that see all faces (Kallinderis & Ward 1992, as told by Aubry & Loehner 2008, section 2).
/// It sees all faces, but only for two of them is it always the direction that sees them best.
/// \returns  nullopt if no direction in that plane sees all faces (others may), or if there is no face
/// \throws   InputError if a normal is not finite.    Cost: O(n^2).
std::optional<VisibleNormal> kallinderis_normal(std::span<const Vec3> face_normals);

struct IterationOptions {
  /// Share of the correction that is taken, > 0: of the way to the mean, Eq. (5), or of the weights' change, Eq. (12).
  /// The weights are then multiplied as Eq. (5) has it. nullopt: at each step a share of what is stable, 0.9 of Eq.
  /// (10) with the weights damped by Eq. (11) where the gain is above 4, and 0.75 of Eq. (13). That is stable near the
  /// end, but may be slow: of fans of 12 normals in a cap of 86 degrees 25 % (`iterative_normal`) and 14 %
  /// (`pirzadeh_normal`) are not done after 300 steps.
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
/// Loehner 2008, section 3, put right in docs/theory/iterative-normals.md). With a relaxation given it converges on
/// sharp trailing edges only below the limit of Eq. (10) there, and from some 88 degrees on for none that was tried.
/// \param normals  any number. Where no direction sees all of them `max_angle` ends at a right angle or more, which may
///                 be the smallest possible and then counts as converged. Where they are seen only in a cone open by
///                 less than 1e-7 rad their mean may cancel, and it ends there, too, unconverged
/// \throws  InputError if a normal is not finite or an option is out of range.    Cost: O(n) for each step.
IterativeNormal iterative_normal(std::span<const Vec3> normals, const IterationOptions& options = {});

/// Weighted mean whose weights are corrected by how far each face's angle is from the mean angle (predictor and
/// corrector of Pirzadeh 1994, as read in docs/theory/iterative-normals.md). Otherwise as `iterative_normal`.
IterativeNormal pirzadeh_normal(std::span<const Vec3> normals, const IterationOptions& options = {});

}  // namespace nearwall::surface
