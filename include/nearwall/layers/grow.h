#pragma once

#include <optional>
#include <vector>

#include "nearwall/core/progress.h"
#include "nearwall/mesh/front.h"
#include "nearwall/mesh/limit_reason.h"
#include "nearwall/mesh/lines.h"
#include "nearwall/mesh/side_planes.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/surface/features.h"
#include "nearwall/surface/patch_normals.h"
#include "nearwall/surface/point_normals.h"
#include "nearwall/surface/smoothing.h"

namespace nearwall::layers {

/// What happens to a line that cannot have all its layers: they become thinner, or fewer; Auto: docs/layers.md.
enum class OnConflict { Auto, Compress, Stair };

/// A length at each vertex.
struct VertexLength {
  std::optional<std::size_t> array;  ///< point array of the wall, times the factor; nullopt: the factor everywhere
  double factor = 1;
};

/// What is asked for on one patch. The stack of a vertex is that of the patch, scaled to the vertex's own first height
/// or total thickness; with both of them its growth is lowered, too: docs/theory/asked.md.
struct PatchSchedule {
  bool has_layers = true;       ///< false: nolayer, or a component that the fluid cannot reach
  std::vector<double> heights;  ///< height of each layer from the wall up, > 0; empty if there are no layers
  OnConflict on_conflict = OnConflict::Auto;
  std::optional<int> max_level_step;  ///< levels by which a line may end above a neighbour that moves; nullopt: any
  std::optional<VertexLength> first_height;     ///< of each vertex, > 0; nullopt: what follows from the thickness
  std::optional<VertexLength> total_thickness;  ///< of each vertex, > 0; nullopt: what follows from the first height
  /// Lines stop where their layer is as high as their triangles are wide, isotropic.h; `heights` are as many as they
  /// may have at most, and max_level_step is 1 unless it is given.
  bool is_until_isotropic = false;
};

struct GrowOptions {
  IdVector<PatchId, PatchSchedule> schedules;  ///< (n_patches)
  surface::NormalMethod normals = surface::NormalMethod::MostVisible;
  surface::SmoothingFilter filter = surface::SmoothingFilter::Taubin;
  std::optional<int> smoothing_iterations;  ///< nullopt: 2
  bool several_lines = true;                ///< at convex ridges and corners that need them; false: one for each vertex
  double multi_angle =
      surface::GroupOptions().multi_angle;  ///< turn of a convex ridge from which it gets several lines [rad]
  /// Angle to the worst face round a vertex from which its convex ridges get several lines [rad], (0, pi / 2].
  double steep_angle = surface::GroupOptions().steep_angle;
  double max_turn = 0.785398163397448310;  ///< largest angle between two lines of a fan, 1 to 90 degrees [rad]
  // The levers of docs/theory/layers.md, section 3, and docs/theory/fans.md, section 8, to be compared without.
  bool lean_lines = true;    ///< away from where they would cross
  bool search_lines = true;  ///< for better directions where faces keep less than they are asked for
  bool try_fans = true;      ///< at convex ridges of 60 degrees and more that do not need several lines
  /// Rounds of certify and shrink after which what fails is blocked at once, and after twice as many the whole
  /// component that it lies on: so the number of rounds is bounded on any surface. Seen on real surfaces: 0 to 55.
  int patient_rounds = 100;
};

/// How a wall came out of growing, line by line and face by face.
struct Growth {
  mesh::Front front;
  mesh::Lines lines;
  /// Before smoothing: what the vertex sees; of several groups of faces, the one that is seen worst.
  IdVector<VertexId, surface::PointNormal> normals;
  IdVector<LineId, double> asked_thickness;     ///< normal to the wall [length]; 0 where nothing is asked
  IdVector<LineId, Level> asked_levels;         ///< layers; 0 where nothing is asked
  IdVector<LineId, double> asked_first_height;  ///< normal to the wall [length]; 0 where nothing is asked
  IdVector<LineId, double> reached_thickness;   ///< normal to the wall [length]
  IdVector<LineId, mesh::LimitReason> reason;   ///< None where all was reached; Isotropic: all, and that ends there
  int rounds = 0;                               ///< of certify and shrink
  int smoothing_iterations = 0;
};

/// The wall as `grow` reads it.
struct Wall {
  const mesh::SurfaceMesh& surface;  ///< admitted, normals into the fluid
  const mesh::Topology& topology;
  const surface::Features& features;
  const IdVector<FaceId, char>& is_wetted;  ///< (n_faces) 0: on a component that the fluid cannot reach
  bool fluid_is_inside = false;             ///< the fluid does not reach infinity
  /// Planes at which the wall ends, if it is open: its layers land on them. The rest of the fluid's boundary is part of
  /// the surface then, far field, too, as patches without layers.
  const mesh::SidePlanes* planes = nullptr;

  bool has_planes() const { return planes && !planes->empty(); }
};

/// Component of each face; invalid where the fluid does not reach.
IdVector<FaceId, ComponentId> wetted_components(const Wall& wall);

/// Virtual faces that the fans of ridges that need several lines will have at most, nearly always: for forecasts. What
/// trials add is not known beforehand. Cost: a part of that of normals.
std::size_t forecast_fan_faces(const Wall& wall, const GrowOptions& options);

/// Levels that each vertex is asked for: for forecasts. \returns (n_vertices). \throws InputError as `grow`
IdVector<VertexId, Level> asked_levels(const Wall& wall, const GrowOptions& options);

/// Grows certified layers: directions, heights, limits; then every cell and the whole front are certified and what
/// fails is shrunk, until nothing fails. Ends for every admitted surface. Source: docs/theory/layers.md. Memory:
/// O(n_vertices + n_faces), whatever the number of layers.
/// \throws InputError unless each patch has a schedule, and those with layers 1 to 65534 heights above zero, and
///         lengths of vertices that are finite and above zero; if an angle, a step or a number of rounds is out of
///         range
Growth grow(const Wall& wall, const GrowOptions& options, ProgressSink& progress = silent_progress());

}  // namespace nearwall::layers
