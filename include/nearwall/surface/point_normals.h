#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "nearwall/core/vec3.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/surface/features.h"
#include "nearwall/surface/fitted_normals.h"
#include "nearwall/surface/normals.h"

namespace nearwall::surface {

/// How the normal of a vertex comes from what is round it; docs/normals.md, section 2.
enum class NormalMethod {
  MostVisible,
  MostNormal,
  Kallinderis,
  Pirzadeh,
  Iterative,
  Uniform,
  Area,
  InverseArea,
  ProjectedArea,
  Angle,
  InverseRootEdges,
  InverseEdges,
  InverseSquaredEdges,
  Max,
  LittleMax,
  InverseDiameter,
  AngleOverDiameter,
  InverseCircumArea,
  AngleOverCircumArea,
  LinearFit,
  QuadraticFit,
  RenkaCline,
  Shepard,
  Hardy,
  ThinPlate,
  Nielson,
};

/// Names of the methods, in the order of NormalMethod, as in case files and on the command line.
inline constexpr std::array<std::string_view, 26> kNormalMethodNames = {"most-visible",
                                                                        "most-normal",
                                                                        "kallinderis",
                                                                        "pirzadeh",
                                                                        "iterative",
                                                                        "uniform",
                                                                        "area",
                                                                        "inverse-area",
                                                                        "projected-area",
                                                                        "angle",
                                                                        "little-1/2",
                                                                        "little-1",
                                                                        "little-2",
                                                                        "max",
                                                                        "little-max",
                                                                        "inverse-diameter",
                                                                        "angle-over-diameter",
                                                                        "inverse-circumarea",
                                                                        "angle-over-circumarea",
                                                                        "linear-fit",
                                                                        "quadratic-fit",
                                                                        "renka-cline",
                                                                        "shepard",
                                                                        "hardy",
                                                                        "thin-plate",
                                                                        "nielson"};

std::string_view method_name(NormalMethod method);

/// nullopt if there is no method of that name.
std::optional<NormalMethod> normal_method(std::string_view name);

/// The weight of a method that is a weighted mean; nullopt for the others.
std::optional<Weight> weight_of(NormalMethod method);

/// The function of a method that is a local fit; nullopt for the others.
std::optional<Fit> fit_of(NormalMethod method);

struct PointNormal {
  Vec3 direction;            ///< unit vector
  double max_angle = 0;      ///< to the worst adjacent face [rad]; >= pi / 2: blind
  bool is_visible = true;    ///< decided exactly
  bool is_fallback = false;  ///< the method has no answer here; another one's stands in
};

/// Which face normals a weighted mean leaves out because they differ much from the others (Bohdal 2017, algorithm 1).
enum class Unsuitable { Keep, DropAtBoundary, DropEverywhere };

/// Widest corner that a boundary face may have to count in means (Bohdal 2017, section 3).
inline constexpr double kThinAngleInDegrees = 178;

struct NormalOptions {
  NormalMethod method = NormalMethod::MostVisible;
  /// Boundary faces with a corner wider than this are left out of weighted means, and those that come to lie on the
  /// boundary then, but never all faces of a vertex [rad], (0, pi]; pi: none. Fits take their axis from such a mean.
  double thin_angle = geometry::to_radians(kThinAngleInDegrees);
  Unsuitable unsuitable = Unsuitable::Keep;  ///< for weighted means only
};

/// Where the angle-weighted mean of the face normals has a worst cosine above this, the methods that look for an
/// optimum (MostVisible, MostNormal) take that mean (Aubry & Loehner 2008, section 5).
inline constexpr double kVisibilityTrigger = 0.95;

/// One normal for each vertex by the method asked for. Faces without area are passed over. Open surfaces: a boundary
/// vertex has the faces it has. Where the method has no answer `is_fallback` is set, and the direction is another's:
/// the most visible one for MostNormal outside the visibility cone or on a boundary, and for Kallinderis; the
/// Max-weighted one for fits and Nielson; the angle-weighted one where nothing sees all faces; zero without any face.
/// Cost: O(n_faces) but for vertices with very many faces, more for Nielson; on all threads.
/// \throws InputError if an option is out of range
IdVector<VertexId, PointNormal> point_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology,
                                              const Features& features, const NormalOptions& options = {});

/// Gives each vertex whose normal does not see all faces round it the most visible one, if there is one.
void replace_blind_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, const Features& features,
                           IdVector<VertexId, PointNormal>& normals);

}  // namespace nearwall::surface
