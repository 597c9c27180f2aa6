#include "pipeline/volume_stage.h"

#include <algorithm>
#include <map>
#include <memory>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/mesh/mesh_source.h"
#include "nearwall/search/wall_tree.h"
#include "nearwall/volume/hybrid_mesh.h"
#include "pipeline/stage_clock.h"

namespace nearwall::pipeline {

namespace {

/// Cells and the domain may differ by rounding only; more than this would be a defect.
constexpr double kLargestClosure = 1e-9;

/// The faces of a plane that were taken out, for asking which is nearest.
struct OldSide {
  mesh::SurfaceMesh surface;
  std::unique_ptr<search::WallTree> tree;
};

/// Edges between old faces of different patches on each plane.
volume::PlaneBorders borders_on_planes(const Prepared& prepared) {
  const mesh::SurfaceMesh& closed = prepared.admission.surface;
  volume::PlaneBorders borders;
  for (const auto& faces : prepared.wall.side_faces) {
    borders.emplace_back();
    std::map<std::pair<VertexId, VertexId>, PatchId> patch_at;
    for (const FaceId f : faces) {
      const auto& v = closed.faces[f];
      for (std::size_t k = 0; k < 3; ++k) {
        const auto ends = std::minmax({v[k], v[(k + 1) % 3]});
        const auto [found, is_new] = patch_at.emplace(ends, closed.face_patch[f]);
        if (is_new || found->second == closed.face_patch[f]) continue;
        borders.back().push_back({closed.points[ends.first], closed.points[ends.second]});
      }
    }
  }
  return borders;
}

void require_certified(const volume::DomainCertificate& c) {
  if (c.is_valid() && c.closure() <= kLargestClosure) return;
  throw InternalError(
      fmt::format("the volume could not be certified: {} of {} faces on planes are turned over, closure "
                  "{:.3g}; nothing was written",
                  c.n_bad_side_faces, c.n_side_faces, c.closure()));
}

}  // namespace

volume::PatchOnPlane patches_on_planes(const Prepared& prepared) {
  const auto sides = std::make_shared<std::map<mesh::PlaneIndex, OldSide>>();
  const mesh::SurfaceMesh& closed = prepared.admission.surface;
  for (mesh::PlaneIndex p = 0; p < prepared.wall.side_faces.size(); ++p) {
    const auto& faces = prepared.wall.side_faces[p];
    const bool is_one_patch = std::all_of(faces.begin(), faces.end(),
                                          [&](FaceId f) { return closed.face_patch[f] == prepared.wall.patch[p]; });
    if (is_one_patch) continue;
    OldSide& side = (*sides)[p];
    side.surface.points = closed.points;
    for (const FaceId f : faces) {
      side.surface.faces.push_back(closed.faces[f]);
      side.surface.face_patch.push_back(closed.face_patch[f]);
    }
    side.tree = std::make_unique<search::WallTree>(side.surface);
  }
  return [sides, &prepared](mesh::PlaneIndex plane, const Vec3& middle) {
    const auto found = sides->find(plane);
    if (found == sides->end()) return prepared.wall.patch[plane];
    return found->second.surface.face_patch[found->second.tree->nearest(middle).face];
  };
}

std::variant<Volume, VolumeFailure> fill_volume(const Prepared& prepared, const certify::CertifiedWall& wall,
                                                const mesh::LayerMesh& layers, const mesh::MeshSource& source,
                                                double layers_volume, ProgressSink& progress) {
  const VolumeSettings& settings = prepared.settings.volume;
  Volume result;
  try {
    const volume::PlaneBorders borders = borders_on_planes(prepared);
    result.rest =
        staged(progress, "sides", [&] { return volume::rest_boundary(layers, wall, settings.growth, borders); });
  } catch (const InputError& error) {
    progress.end_stage();
    return VolumeFailure{fmt::format("the sides of the domain cannot be meshed: {}", error.what()), {}, {}};
  }
  try {
    volume::FillOptions options;
    options.growth = settings.growth;
    result.fill = staged(progress, "tetrahedra",
                         [&] { return volume::fill_with_tetgen(result.rest.surface, options, progress); });
  } catch (const volume::FillFailed& failed) {
    progress.end_stage();
    return VolumeFailure{failed.what(), std::move(result.rest), failed.triangles};
  } catch (const BackendError& failed) {
    progress.end_stage();
    return VolumeFailure{failed.what(), std::move(result.rest), {}};
  } catch (const InputError& failed) {
    progress.end_stage();
    return VolumeFailure{failed.what(), std::move(result.rest), {}};
  }
  progress.begin_stage("domain");
  const volume::HybridMesh hybrid(source, result.rest, result.fill);
  result.boundary = volume::domain_boundary(layers, wall, result.rest, hybrid, patches_on_planes(prepared));
  progress.update(0.4);
  result.certificate = volume::certify_domain(result.boundary, wall.planes, layers_volume, result.fill);
  require_certified(result.certificate);
  progress.update(0.6);
  result.quality = volume::fill_quality(layers, result.rest, result.fill);
  progress.end_stage();
  return result;
}

io::PolyDataFile fill_faults_file(const VolumeFailure& failure) {
  const volume::FillBoundary& surface = failure.rest.surface;
  io::PolyDataFile file;
  std::map<std::uint32_t, std::uint32_t> number;
  std::vector<std::int32_t> is_front;
  for (const std::uint32_t t : failure.triangles) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t p = surface.triangles[t][k];
      const auto [found, is_new] = number.emplace(p, static_cast<std::uint32_t>(file.points.size()));
      if (is_new) file.points.push_back(surface.points[p]);
      corners[k] = found->second;
    }
    file.triangles.push_back(corners);
    is_front.push_back(t < failure.rest.n_front ? 1 : 0);
  }
  file.triangle_data.push_back({"IsFront", std::move(is_front)});
  return file;
}

}  // namespace nearwall::pipeline
