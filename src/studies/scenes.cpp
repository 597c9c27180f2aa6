#include "studies/scenes.h"

#include <fmt/format.h>

#include "nearwall/shapes/shapes.h"

namespace nearwall::studies {

namespace {

/// Adds a body to the surface, moved aside by `offset`.
void append(mesh::SurfaceMesh& all, const mesh::SurfaceMesh& body, const std::string& name, const Vec3& offset) {
  const std::size_t first_point = all.points.size(), first_patch = all.patch_names.size();
  for (const Vec3& p : body.points) all.points.push_back(p + offset);
  for (const auto& face : body.faces) {
    auto moved = face;
    for (VertexId& v : moved) v = VertexId(v.index() + first_point);
    all.faces.push_back(moved);
  }
  for (const PatchId patch : body.face_patch) all.face_patch.push_back(PatchId(patch.index() + first_patch));
  for (const std::string& patch : body.patch_names) all.patch_names.push_back(fmt::format("{}-{}", name, patch));
}

/// One body, and behind it in x copies of another one.
mesh::SurfaceMesh with_copies(const mesh::SurfaceMesh& first, const mesh::SurfaceMesh& other, int n_copies) {
  constexpr double kDistance = 16;  // more than any of the bodies is long
  mesh::SurfaceMesh all;
  append(all, first, "first", Vec3());
  for (int i = 1; i <= n_copies; ++i) append(all, other, fmt::format("copy{}", i), {kDistance * i, 0, 0});
  return all;
}

}  // namespace

Scene flyer_scene() {
  constexpr double kWingSize = 0.03, kStarSize = 0.0303;
  constexpr int kStars = 10;
  const auto wing = shapes::make_shape("wing-body", {{"rounded-tip", 0}}, kWingSize);
  const auto star = shapes::make_shape("star", {{"points", 12}}, kStarSize);
  return {"flyer", "wing-body with sharp tips, 10 twelve-pointed stars", with_copies(wing, star, kStars)};
}

Scene block_scene() {
  constexpr double kAhmedSize = 0.012, kBlockSize = 0.08;
  constexpr int kBlocks = 18;
  const auto ahmed = shapes::make_shape("ahmed", {{"stilts", 1}}, kAhmedSize);
  const auto block = shapes::make_shape("block-on-floor", {}, kBlockSize);
  return {"blocks", "Ahmed body on stilts, 18 blocks on floors", with_copies(ahmed, block, kBlocks)};
}

}  // namespace nearwall::studies
