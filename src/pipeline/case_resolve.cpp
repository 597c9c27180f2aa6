#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "nearwall/core/errors.h"
#include "nearwall/io/surface_reader.h"
#include "nearwall/layers/isotropic.h"
#include "pipeline/case_document.h"
#include "pipeline/case_patches.h"
#include "pipeline/length_warnings.h"
#include "pipeline/patch_schedules.h"

namespace nearwall {

namespace {

using namespace pipeline;

void set_rest(const LayerSettings& layers, PatchSettings& patch) {
  patch.min_coverage = layers.min_coverage.value_or(0);
  patch.on_conflict = layers.on_conflict.value_or(OnConflict::Auto);
  if (layers.max_level_step.value_or(0) > 0) patch.max_level_step = layers.max_level_step;
}

std::string title(const std::string& name) { return fmt::format("layers of patch \"{}\"", name); }

/// Vertices of groups of patches, each once, in increasing order.
/// \param group  (n_patches) of each patch; invalid: of none
IdVector<PatchId, std::vector<VertexId>> vertices_of(const mesh::SurfaceMesh& surface,
                                                     const IdVector<PatchId, PatchId>& group) {
  IdVector<PatchId, std::vector<VertexId>> vertices(group.size());
  for (const FaceId f : surface.faces.ids()) {
    const PatchId patch = group[surface.face_patch[f]];
    if (!patch.is_valid()) continue;
    for (const VertexId v : surface.faces[f]) vertices[patch].push_back(v);
  }
  for (auto& of_group : vertices) {
    std::sort(of_group.begin(), of_group.end());
    of_group.erase(std::unique(of_group.begin(), of_group.end()), of_group.end());
  }
  return vertices;
}

/// Triangles of groups of patches, as above.
IdVector<PatchId, std::vector<FaceId>> faces_of(const mesh::SurfaceMesh& surface,
                                                const IdVector<PatchId, PatchId>& group) {
  IdVector<PatchId, std::vector<FaceId>> faces(group.size());
  for (const FaceId f : surface.faces.ids()) {
    const PatchId patch = group[surface.face_patch[f]];
    if (patch.is_valid()) faces[patch].push_back(f);
  }
  return faces;
}

/// Of the patches whose heights depend on their vertices the first one with the same settings; invalid for the others.
/// Patches alike share one stack, so that there is no step between them.
IdVector<PatchId, PatchId> groups_of(const std::vector<PatchLayers>& patches) {
  IdVector<PatchId, PatchId> group(patches.size());
  for (const PatchId p : group.ids()) {
    const PatchLayers& patch = patches[p.index()];
    if (!has_layers(patch.type) || !needs_vertices(patch.layers)) continue;
    const auto alike = std::find_if(patches.begin(), patches.end(), [&](const PatchLayers& other) {
      return has_layers(other.type) && other.layers == patch.layers;
    });
    group[p] = PatchId(static_cast<std::size_t>(alike - patches.begin()));
  }
  return group;
}

/// A length that a patch takes from an array.
struct Taken {
  std::string_view key;
  const ArrayLength& length;
};

std::vector<Taken> taken_by(const LayerSettings& layers) {
  std::vector<Taken> all;
  if (layers.first_height_array) all.push_back({"first_height", *layers.first_height_array});
  if (layers.total_thickness_array) all.push_back({"total_thickness", *layers.total_thickness_array});
  return all;
}

[[noreturn]] void reject_value(const Case& settings, const LayerSettings& layers, const std::string& patch,
                               const Taken& taken, const mesh::SurfaceMesh& surface, VertexId v, double value) {
  const Vec3& p = surface.points[v];
  throw InputError(fmt::format(
      "{}: {}: {}: expected a number above 0 at every point of the patch, found {} in array \"{}\" at point {} "
      "(counted "
      "from 0) at ({:.6g}, {:.6g}, {:.6g}) of the file; set it there, or give the patch a number of its own",
      place_of(settings, layers), title(patch), taken.key, value, taken.length.array, v.index(), p.x(), p.y(), p.z()));
}

/// The keys that take a length from an array, each with its place: "case.toml:4:1: layers.first_height".
std::vector<std::string> users_of(const Case& settings, const std::string& array) {
  std::vector<std::string> users;
  const auto add = [&](const LayerSettings& layers, const std::string& table) {
    for (const Taken& taken : taken_by(layers)) {
      if (taken.length.array == array)
        users.push_back(fmt::format("{}: {}.{}", place_of(settings, layers), table, taken.key));
    }
  };
  add(settings.layers, "layers");
  for (const PatchRule& rule : settings.patches) add(rule.layers, fmt::format("patches.{}", quoted_key(rule.pattern)));
  return users;
}

}  // namespace

mesh::SurfaceMesh pipeline::read_with_lengths(const Case& settings) try {
  return io::read_surface(settings.surface_path(), point_arrays(settings));
} catch (const io::PointArrayMissing& missing) {
  throw InputError(fmt::format("{}: {}", fmt::join(users_of(settings, missing.array), "; "), missing.what()));
}

std::vector<std::string> point_arrays(const Case& settings) {
  std::vector<std::string> names;
  const auto add = [&](const LayerSettings& layers) {
    for (const Taken& taken : taken_by(layers)) {
      if (std::find(names.begin(), names.end(), taken.length.array) == names.end()) names.push_back(taken.length.array);
    }
  };
  add(settings.layers);
  for (const PatchRule& rule : settings.patches) add(rule.layers);
  return names;
}

void check_point_arrays(const Case& settings, const mesh::SurfaceMesh& surface) {
  const auto names = point_arrays(settings);
  if (names.empty()) return;
  const auto patches = settings_of_patches(settings, surface.patch_names.raw());
  IdVector<PatchId, PatchId> itself(patches.size());
  for (const PatchId patch : itself.ids()) {
    const PatchLayers& p = patches[patch.index()];
    if (has_layers(p.type) && !taken_by(p.layers).empty()) itself[patch] = patch;
  }
  const auto vertices = vertices_of(surface, itself);
  for (const PatchId patch : vertices.ids()) {
    const LayerSettings& layers = patches[patch.index()].layers;
    for (const Taken& taken : taken_by(layers)) {
      const auto place = std::find(names.begin(), names.end(), taken.length.array) - names.begin();
      const auto& values = surface.point_arrays[static_cast<std::size_t>(place)].values;
      for (const VertexId v : vertices[patch]) {
        const double length = values[v] * settings.surface.scale * taken.length.factor;
        if (length > 0 && std::isfinite(length)) continue;
        reject_value(settings, layers, surface.patch_names[patch], taken, surface, v, values[v]);
      }
    }
  }
}

std::vector<PatchSettings> resolve_patches(const Case& settings, const mesh::SurfaceMesh& surface,
                                           const mesh::Topology& topology) {
  const auto of_patches = settings_of_patches(settings, surface.patch_names.raw());
  const auto arrays = point_arrays(settings);
  const auto group = groups_of(of_patches);
  const auto vertices = vertices_of(surface, group);
  const auto faces = faces_of(surface, group);
  const bool any_isotropic = std::any_of(of_patches.begin(), of_patches.end(), [](const PatchLayers& p) {
    return has_layers(p.type) && p.layers.until == Until::Isotropic;
  });
  const auto isotropic_heights =
      any_isotropic ? layers::isotropic_heights(surface, topology) : IdVector<VertexId, double>();
  std::vector<PatchSettings> patches;
  for (const PatchId p : surface.patch_names.ids()) {
    const PatchLayers& from = of_patches[p.index()];
    if (group[p].is_valid() && group[p] != p) {
      patches.push_back(patches[group[p].index()]);
      patches.back().warnings.clear();
      continue;
    }
    PatchSettings& patch = patches.emplace_back();
    // A repair may have dropped all triangles of a patch: then there is nobody to ask.
    const bool is_empty = group[p].is_valid() && vertices[p].empty();
    patch.type = is_empty ? PatchType::NoLayer : from.type;
    if (!has_layers(patch.type)) continue;
    const std::string name = title(surface.patch_names[p]);
    const PatchVertices of_group = {surface, arrays, isotropic_heights, vertices[p]};
    set_schedule(settings, from.layers, name, of_group, patch);
    set_rest(from.layers, patch);
    patch.warnings = length_warnings(patch, of_group, faces[p]);
    const bool has_others = std::count(group.begin(), group.end(), p) > 1;
    for (std::string& warning : patch.warnings) {
      warning = fmt::format("{}: {}{}: {}", place_of(settings, from.layers), name, has_others ? " and those alike" : "",
                            warning);
    }
  }
  return patches;
}

std::vector<PatchSettings> resolve_patches(const Case& settings, std::span<const std::string> patch_names) {
  // Heights that depend on no vertex need no surface either.
  mesh::SurfaceMesh surface;
  for (const std::string& name : patch_names) surface.patch_names.push_back(name);
  const auto of_patches = settings_of_patches(settings, patch_names);
  for (std::size_t p = 0; p < patch_names.size(); ++p) {
    if (has_layers(of_patches[p].type) && needs_vertices(of_patches[p].layers)) {
      throw InputError(fmt::format("{}: {}: the heights follow from the surface, which is not there",
                                   settings.file.string(), title(patch_names[p])));
    }
  }
  return resolve_patches(settings, surface, mesh::Topology(surface));
}

}  // namespace nearwall
