#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "io/batches.h"
#include "io/msh_format.h"
#include "io/msh_output.h"

namespace nearwall::io {
namespace {

template <class T>
void append(std::string& out, T value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

void append_count(std::string& out, std::uint64_t n) { append(out, n); }
void append_tag(std::string& out, int tag) { append(out, static_cast<std::int32_t>(tag)); }

void append_point(std::string& out, const Vec3& p) {
  for (int axis = 0; axis < 3; ++axis) append(out, p[axis]);
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Box {
  Vec3 low{kInfinity, kInfinity, kInfinity};
  Vec3 high = -low;
  void add(const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
};

/// Node numbers are 64-bit in version 4.1: nothing overflows.
class Msh41Writer {
 public:
  explicit Msh41Writer(MshOutput& out) : out_(out) {}

  void write() {
    std::string header = "$MeshFormat\n4.1 1 8\n";
    append_tag(header, 1);  // tells readers the byte order
    out_.write(header + "\n$EndMeshFormat\n");
    out_.write(out_.physical_names());
    write_entities();
    write_nodes();
    write_elements();
    out_.commit();
  }

 private:
  Box box_of_points() const {
    const mesh::MeshSource& mesh = out_.mesh().cells;
    Box all;
    in_batches(
        mesh.n_point_batches(),
        [&](std::size_t batch) {
          mesh::PointBatch points;
          mesh.read_points(batch, points);
          Box box;
          for (const Vec3& p : points.position) box.add(p);
          return box;
        },
        [&](std::size_t, const Box& box) {
          all.add(box.low);
          all.add(box.high);
        });
    return mesh.n_points() > 0 ? all : Box{Vec3(), Vec3()};
  }

  /// Surfaces and volumes without curves and points, each with the box of the whole mesh: a bound, and programs that
  /// need a close one take it from the nodes.
  void write_entities() {
    const auto& patches = out_.mesh().boundary.patches;
    const std::vector<bool> volumes = out_.volumes_in_layers();
    const Box box = box_of_points();
    std::string bytes = "$Entities\n";
    for (const std::size_t n : {std::size_t{0}, std::size_t{0}, patches.size(), volumes.size()}) append_count(bytes, n);
    const auto add = [&](int entity, int physical) {
      append_tag(bytes, entity);
      append_point(bytes, box.low);
      append_point(bytes, box.high);
      append_count(bytes, 1);
      append_tag(bytes, physical);
      append_count(bytes, 0);  // entities that bound it
    };
    for (const PatchId patch : patches.ids()) add(MshOutput::surface(patch), MshOutput::surface(patch));
    for (const bool in_layers : volumes) add(MshOutput::volume(in_layers), out_.physical_volume(in_layers));
    out_.write(bytes + "\n$EndEntities\n");
  }

  /// One block: all numbers, then all coordinates. Every node is on the first volume.
  void write_nodes() {
    const mesh::MeshSource& mesh = out_.mesh().cells;
    std::string bytes = "$Nodes\n";
    for (const std::uint64_t n : {std::uint64_t{1}, mesh.n_points(), std::uint64_t{1}, mesh.n_points()}) {
      append_count(bytes, n);
    }
    append_tag(bytes, 3);
    append_tag(bytes, MshOutput::volume(out_.volumes_in_layers().front()));
    append_tag(bytes, 0);  // without parameters
    append_count(bytes, mesh.n_points());
    out_.write(bytes);
    write_numbers(mesh.n_points());
    in_batches(
        mesh.n_point_batches(),
        [&](std::size_t batch) {
          mesh::PointBatch points;
          mesh.read_points(batch, points);
          std::string coordinates;
          coordinates.reserve(points.size() * 3 * sizeof(double));
          for (const Vec3& p : points.position) append_point(coordinates, p);
          return coordinates;
        },
        [&](std::size_t, const std::string& coordinates) { out_.write(coordinates); });
    out_.write("\n$EndNodes\n");
    out_.report(mesh.n_points());
  }

  /// 1 to n.
  void write_numbers(std::uint64_t n) {
    constexpr std::uint64_t kAtOnce = 1 << 16;
    for (std::uint64_t first = 0; first < n; first += kAtOnce) {
      std::string bytes;
      for (std::uint64_t i = first; i < std::min(n, first + kAtOnce); ++i) append_count(bytes, i + 1);
      out_.write(bytes);
    }
  }

  void write_elements() {
    const auto& sections = out_.sections().sections();
    std::string bytes = "$Elements\n";
    append_count(bytes, out_.face_blocks().size() + sections.size());
    for (const std::uint64_t n : {out_.n_elements(), std::uint64_t{1}, out_.n_elements()}) append_count(bytes, n);
    out_.write(bytes);
    std::uint64_t next = 1;
    for (const MshFaceBlock& block : out_.face_blocks()) write_faces(block, next);
    for (const CellSection& section : sections) write_cells(section);
    out_.write("\n$EndElements\n");
  }

  static std::string block_header(int dimension, int entity, int code, std::uint64_t n) {
    std::string bytes;
    for (const int value : {dimension, entity, code}) append_tag(bytes, value);
    append_count(bytes, n);
    return bytes;
  }

  void write_faces(const MshFaceBlock& block, std::uint64_t& next) {
    std::string bytes = block_header(2, MshOutput::surface(block.patch), block.code, block.faces.size());
    for (const std::uint32_t f : block.faces) {
      const mesh::BoundaryFace& face = out_.mesh().boundary.faces[f];
      append_count(bytes, next++);
      for (std::size_t k = 0; k < static_cast<std::size_t>(mesh::size_of(face)); ++k) append_count(bytes, face[k] + 1);
    }
    out_.write(bytes);
    out_.report(block.faces.size());
  }

  void write_cells(const CellSection& section) {
    const auto n_nodes = static_cast<std::size_t>(mesh::size_of(section.type));
    out_.write(block_header(3, MshOutput::volume(section.in_layers), msh_code(section.type), section.n_cells));
    out_.sections().stream(
        section,
        [&](const mesh::CellBatch& cells, const std::vector<std::uint32_t>& places) {
          std::string bytes;
          bytes.reserve(places.size() * (n_nodes + 1) * sizeof(std::uint64_t));
          for (const std::uint32_t c : places) {
            append_count(bytes, out_.element_of(cells.first + c));
            for (std::size_t k = 0; k < n_nodes; ++k) append_count(bytes, cells.nodes[c][k] + 1);
          }
          return bytes;
        },
        [&](const std::string& bytes) { out_.write(bytes); });
    out_.report(section.n_cells);
  }

  MshOutput& out_;
};

}  // namespace

void write_msh41(const std::filesystem::path& path, const WholeMesh& mesh, ProgressSink& progress) {
  MshOutput out(path, mesh, progress);
  Msh41Writer(out).write();
}

}  // namespace nearwall::io
