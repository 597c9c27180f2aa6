#include "nearwall/pipeline/forecast.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace nearwall {

namespace {

// Bytes, as measured on bodies of 20 thousand to 75 thousand triangles: docs/report.md.
constexpr double kBytesForTriangle = 2600;  ///< surface, topology, trees, lines while they are made
constexpr double kBytesForProgram = 60e6;   ///< libraries, buffers
constexpr double kDiskForTriangle = 100;    ///< surface, front and boundary files
constexpr double kDiskForReport = 2e6;      ///< pictures and pages

/// Bytes of a mesh file: for a wedge, or any cell, and for a point. nearwall_benchmarks --benchmark_filter=WriteMesh
struct MeshBytes {
  double cell, point;
};

/// In the order of io::MeshFormat.
constexpr MeshBytes kDisk[] = {
    {16, 24},   // vtu, packed
    {10, 24},   // vtkhdf, packed
    {26, 24},   // cgns
    {52, 56},   // su2
    {50, 56},   // ugrid
    {26, 24},   // b8.ugrid
    {26, 24},   // lb8.ugrid
    {60, 32},   // msh
    {66, 64},   // msh2
    {72, 24},   // openfoam
    {120, 60},  // openfoam-ascii
};
static_assert(std::size(kDisk) == io::kMeshFormatNames.size());

constexpr double kTetrahedraForTriangle = 2.5;
constexpr int kTetrahedraForPoint = 6;
constexpr double kBytesForTetrahedron = 700;  ///< in TetGen, and the result beside it

std::string sized(double bytes) {
  constexpr double kStep = 1000;
  const char* unit = "B";
  for (const char* next : {"kB", "MB", "GB", "TB"}) {
    if (bytes < kStep) break;
    bytes /= kStep;
    unit = next;
  }
  return bytes < 10 ? fmt::format("{:.1f} {}", bytes, unit) : fmt::format("{:.0f} {}", bytes, unit);
}

/// 1234567 as "1 234 567".
std::string grouped(std::uint64_t n) {
  const std::string digits = std::to_string(n);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ' ';
    text += digits[i];
  }
  return text;
}

}  // namespace

Forecast forecast(const mesh::SurfaceMesh& wall, const std::vector<PatchSettings>& patches,
                  const IdVector<FaceId, char>& is_wetted, std::size_t n_fan_faces,
                  const IdVector<VertexId, Level>& asked_levels) {
  Forecast f;
  IdVector<VertexId, Level> levels(wall.points.size(), 0);
  for (const FaceId face : wall.faces.ids()) {
    const PatchSettings& patch = patches[wall.face_patch[face].index()];
    if (!is_side(patch.type)) {
      for (const VertexId v : wall.faces[face]) f.box.include(wall.points[v]);
    }
    if (patch.type != PatchType::Wall || !is_wetted[face]) continue;
    const Level count = static_cast<Level>(patch.schedule.count);
    f.largest_count = std::max(f.largest_count, count);
    Level highest = 0;
    for (const VertexId v : wall.faces[face]) {
      const Level level = patch.is_until_isotropic && !asked_levels.empty() ? asked_levels[v] : count;
      levels[v] = std::max(levels[v], level);
      highest = std::max(highest, level);
    }
    f.n_cells += highest;
  }
  f.n_points = wall.points.size();
  for (const Level level : levels) f.n_points += level;
  // A line and a column for each virtual face, and a cap with its apex.
  f.n_cells += n_fan_faces * (f.largest_count + std::uint64_t{1});
  f.n_points += n_fan_faces * (f.largest_count + std::uint64_t{1});

  const auto triangles = static_cast<double>(wall.faces.size());
  f.memory_bytes = static_cast<std::uint64_t>(kBytesForProgram + kBytesForTriangle * triangles);
  f.disk_bytes = static_cast<std::uint64_t>(kDiskForReport + kDiskForTriangle * triangles);
  return f;
}

void add_fill(std::size_t n_triangles, double growth, Forecast& f) {
  f.n_tetrahedra = static_cast<std::uint64_t>(kTetrahedraForTriangle * static_cast<double>(n_triangles) / (growth - 1));
  const auto tetrahedra = static_cast<double>(f.n_tetrahedra);
  f.n_points += f.n_tetrahedra / kTetrahedraForPoint;
  f.memory_bytes = std::max(f.memory_bytes, static_cast<std::uint64_t>(kBytesForTetrahedron * tetrahedra));
}

void add_mesh_files(std::span<const io::MeshFormat> formats, Forecast& f) {
  const auto cells = static_cast<double>(f.n_cells + f.n_tetrahedra), points = static_cast<double>(f.n_points);
  for (const io::MeshFormat format : formats) {
    const MeshBytes bytes = kDisk[static_cast<std::size_t>(format)];
    f.disk_bytes += static_cast<std::uint64_t>(bytes.cell * cells + bytes.point * points);
  }
}

std::string describe(const Forecast& f) {
  const auto point = [](const Vec3& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z()); };
  return fmt::format(
      "forecast: up to {} cells in {} layers{}, {} points, {} of memory, {} on disk; box {} to {}, diagonal {:.6g}",
      grouped(f.n_cells), f.largest_count,
      f.n_tetrahedra > 0 ? fmt::format(", about {} tetrahedra", grouped(f.n_tetrahedra)) : "", grouped(f.n_points),
      sized(static_cast<double>(f.memory_bytes)), sized(static_cast<double>(f.disk_bytes)), point(f.box.low),
      point(f.box.high), f.box.diagonal());
}

}  // namespace nearwall
