#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "nearwall/core/errors.h"
#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::surface {

enum class FluidSide { Outside, Inside };

/// None: nothing is changed. Safe: the repairs that cannot change the shape (turning round faces and components that
/// are inside out, dropping exact duplicates of triangles and triangles with a repeated corner).
enum class Repair { None, Safe };

enum class FaultKind : std::uint8_t {
  NotFinite,
  OutOfRange,
  DegenerateTriangle,
  DuplicateTriangle,
  NonManifoldEdge,
  NonManifoldVertex,
  InconsistentOrientation,
  OpenEdge,
  SelfIntersection,
  InsideOut,
  Empty,
};

/// Short name of a fault, as in the JSON of `check`: "open-edge", "self-intersection", …
std::string_view fault_name(FaultKind kind);

/// All faults of one kind on one patch.
struct Fault {
  FaultKind kind;
  std::size_t count = 0;          ///< of the thing the kind names: edges, vertices, triangles, pairs, components
  std::vector<Vec3> where;        ///< first few places
  std::vector<FaceId> triangles;  ///< all triangles concerned, ids of the input
  std::string patch;              ///< patch of the first of them
  std::string advice;             ///< what to do, one sentence
};

struct AdmissionPolicy {
  FluidSide fluid = FluidSide::Outside;
  Repair repair = Repair::None;
};

/// What part a component plays, from its nesting among the others: even depth bounds a body, odd depth a cavity.
struct Component {
  std::size_t n_faces = 0;
  double volume = 0;      ///< enclosed, signed by the orientation of the file
  int depth = 0;          ///< number of other components round it
  bool is_wetted = true;  ///< false: the fluid cannot reach it; it gets no layers
};

/// A surface with all that was found. It is usable if there is no fault.
struct Admission {
  /// Points and triangles in the order of the input, oriented so that the normals of wetted components point into the
  /// fluid (unwetted ones as in the file). Repaired if so asked.
  mesh::SurfaceMesh surface;
  IdVector<FaceId, FaceId> input_face;           ///< number of each triangle in the file; identity without repairs
  IdVector<FaceId, ComponentId> face_component;  ///< empty if the surface is not manifold
  IdVector<ComponentId, Component> components;  ///< in the order of their first triangle; parts that touch count as one
  std::vector<Fault> faults;
  std::vector<std::string> repairs;  ///< what was repaired, a sentence each
  std::size_t n_open_edges = 0;
  double closing_tolerance = 0;  ///< weld length that would close all open edges, three digits; 0 if there is none
  bool is_usable() const { return faults.empty(); }
};

/// Looks for everything that keeps a surface from being meshed, in the order of FaultKind; nothing is thrown for it.
/// Exact. The surface should be welded (weld.h): points are the same if their number is.
///
/// A triangle with a repeated corner or an exact copy of another is told as such and left out of all further checks.
/// Self-intersection is looked at unless most edges are open or non-manifold; nesting and inside-out only if the
/// surface is finite, manifold, closed, consistently oriented and free of self-intersection. Cost: O(n log n +
/// intersecting pairs)
Admission inspect(mesh::SurfaceMesh surface, const AdmissionPolicy& policy);

/// A surface that was refused. The message tells what, how many, where, and what to do.
class SurfaceRejected : public GeometryError {
 public:
  SurfaceRejected(const std::string& message, Admission admission_in)
      : GeometryError(message), admission(std::move(admission_in)) {}
  Admission admission;
};

/// `inspect`, and \throws SurfaceRejected if there is any fault.
Admission admit(mesh::SurfaceMesh surface, const AdmissionPolicy& policy);

}  // namespace nearwall::surface
