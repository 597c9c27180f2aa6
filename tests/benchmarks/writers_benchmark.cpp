#include <filesystem>
#include <string>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "nearwall/io/mesh_formats.h"
#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/shapes/shapes.h"
#include "nearwall/volume/domain_boundary.h"
#include "nearwall/volume/hybrid_neighbours.h"
#include "tests/support/growing.h"

// Every format of meshes: a sphere of 20 · 4^6 = 81,920 triangles with 24 layers, 1.97 M wedges.

namespace nearwall {
namespace {

using namespace growing_for_tests;
namespace fs = std::filesystem;

constexpr int kLayers = 24;

/// Layers with their boundary, made once.
class GrownSphere {
 public:
  GrownSphere()
      : wall_(shapes::make_shape("sphere", {{"subdivisions", 6}})),
        growth_(layers::grow(wall_.wall(), options_for(wall_.surface(), geometric(0.02, 1.2, kLayers)))),
        layers_(growth_.front, growth_.lines),
        source_(layers_, wall_.surface().face_patch, wall_.surface().points.raw()) {
    IdVector<PatchId, mesh::BoundaryPatch> patches;
    for (const std::string& name : wall_.surface().patch_names) patches.push_back({name, mesh::BoundaryType::Wall});
    const PatchId front = patches.push_back({"front", mesh::BoundaryType::Other});
    const auto faces = volume::layers_boundary(layers_, wall_.certified_wall(), front,
                                               [](mesh::PlaneIndex, const Vec3&) { return PatchId(0); });
    boundary_ = volume::mesh_boundary(faces, std::move(patches));
  }

  /// Neighbours are looked for by every benchmark anew, as by a run.
  void write(const fs::path& path, io::MeshFormat format) const {
    const volume::HybridNeighbours neighbours(layers_, boundary_, nullptr);
    io::write_mesh(path, format, {source_, boundary_, neighbours, "sphere"}, {});
  }
  CellIndex n_cells() const { return layers_.n_cells(); }

 private:
  TestWall wall_;
  layers::Growth growth_;
  mesh::LayerMesh layers_;
  mesh::LayerSource source_;
  mesh::Boundary boundary_;
};

std::uintmax_t size_of(const fs::path& path) {
  if (!fs::is_directory(path)) return fs::file_size(path);
  std::uintmax_t size = 0;
  for (const auto& entry : fs::directory_iterator(path)) size += entry.file_size();
  return size;
}

void WriteMesh(benchmark::State& state) {
  static const GrownSphere sphere;
  const auto format = static_cast<io::MeshFormat>(state.range(0));
  const fs::path folder = fs::temp_directory_path() / ("nearwall-writers-" + std::to_string(::getpid()));
  fs::create_directory(folder);
  const bool is_folder = format == io::MeshFormat::OpenFoam || format == io::MeshFormat::OpenFoamAscii;
  const fs::path path = folder / (is_folder ? "polyMesh" : "sphere." + std::string(io::name_of(format)));
  for (auto _ : state) sphere.write(path, format);
  state.counters["cells/s"] =
      benchmark::Counter(double(state.iterations()) * double(sphere.n_cells()), benchmark::Counter::kIsRate);
  state.counters["bytes/cell"] = double(size_of(path)) / double(sphere.n_cells());
  state.SetLabel(std::string(io::name_of(format)));
  fs::remove_all(folder);
}
BENCHMARK(WriteMesh)
    ->DenseRange(0, static_cast<int>(io::kMeshFormatNames.size()) - 1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->ArgName("format");

}  // namespace
}  // namespace nearwall
