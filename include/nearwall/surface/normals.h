#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "nearwall/core/vec3.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/surface/features.h"

namespace nearwall::surface {

/// Direction that sees its worst face best.
struct VisibleNormal {
  Vec3 direction;        ///< unit vector
  double max_angle = 0;  ///< angle to the worst of the given normals [rad], < pi / 2
};

/// The most visible normal: the direction whose largest angle to the given normals is smallest, by the direct method of
/// pairs and triples (Aubry & Loehner 2008, section 4, put right in docs/theory/normals.md). It is the centre of the
/// smallest cap that holds all normals.
/// \param face_normals  any number, of any length; duplicates and zero vectors are passed over
/// \returns  nullopt if no direction sees all faces (decided exactly), or if there is no face
/// \throws   InputError if a normal is not finite
/// Worst angle optimal to 1e-8 rad, for cones open by as little as 1e-6 rad. In cones thinner than about 1e-15 rad no
/// unit vector of doubles may see all faces: the direction is then the best rounded one.
/// The same bits on permuted axes and for normals scaled by powers of two. Cost: O(n) in practice, no memory for n
/// <= 24.
std::optional<VisibleNormal> most_visible_normal(std::span<const Vec3> face_normals);

/// Weight of a face at its vertex in a weighted normal; the names of Ubach 2013 and Bohdal 2017.
enum class Weight { Angle };

/// Weighted mean of the normals of the faces round `apex`, normalised.
/// \param ring    neighbours counterclockwise seen from outside
/// \param closed  whether the last neighbour and the first span a face, too
/// \returns       unit vector; zero if the weighted normals cancel or no face has an area
Vec3 weighted_normal(Weight weight, const Vec3& apex, std::span<const Vec3> ring, bool closed = true);

enum class NormalMethod { MostVisible, Angle };

/// Names of the methods, in the order of NormalMethod, as in case files and on the command line.
inline constexpr std::array<std::string_view, 2> kNormalMethodNames = {"most-visible", "angle"};

/// Names of methods that this version knows and does not do.
inline constexpr std::array<std::string_view, 24> kLaterNormalMethods = {"most-normal",
                                                                         "kallinderis",
                                                                         "pirzadeh",
                                                                         "iterative",
                                                                         "thin-plate",
                                                                         "hardy",
                                                                         "shepard",
                                                                         "linear-fit",
                                                                         "quadratic-fit",
                                                                         "renka-cline",
                                                                         "nielson",
                                                                         "uniform",
                                                                         "area",
                                                                         "inverse-area",
                                                                         "projected-area",
                                                                         "little-1",
                                                                         "little-1/2",
                                                                         "little-2",
                                                                         "max",
                                                                         "little-max",
                                                                         "inverse-diameter",
                                                                         "angle-over-diameter",
                                                                         "inverse-circumarea",
                                                                         "angle-over-circumarea"};

std::string_view method_name(NormalMethod method);

/// nullopt if this version has no method of that name.
std::optional<NormalMethod> normal_method(std::string_view name);

struct PointNormal {
  Vec3 direction;          ///< unit vector; where nothing sees all faces, the angle-weighted normal
  double max_angle = 0;    ///< to the worst adjacent face [rad]; >= pi / 2: blind
  bool is_visible = true;  ///< decided exactly
};

/// One normal for each vertex. MostVisible takes the angle-weighted mean where its worst cosine is above
/// `kVisibilityTrigger` and the direct method elsewhere (Aubry & Loehner 2008, section 5). Faces without area are
/// passed over. Open surfaces: a boundary vertex has the faces it has. Cost: O(n_faces) but for vertices with very many
/// faces; on all threads.
IdVector<VertexId, PointNormal> point_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology,
                                              const Features& features, NormalMethod method);

inline constexpr double kVisibilityTrigger = 0.95;

}  // namespace nearwall::surface
