#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "io/file_bytes.h"
#include "io/mesh_builder.h"
#include "io/ugrid_layout.h"
#include "io/volume_formats.h"

namespace nearwall::io {
namespace {

using mesh::CellType;

std::string name_of_number(std::int64_t number) { return fmt::format("patch{}", number); }

/// The numbers of a file, as text or binary.
class UgridNumbers {
 public:
  /// \param order  of the bytes; none: text
  UgridNumbers(std::string_view bytes, const std::string& file, std::optional<std::endian> order)
      : cursor_(bytes, file), order_(order) {
    if (order_) cursor_.enter_binary();
  }

  std::int64_t integer(std::string_view what) {
    return order_ ? std::int64_t{cursor_.value<std::int32_t>(*order_, what)} : cursor_.integer(what);
  }
  double real(std::string_view what) { return order_ ? cursor_.value<double>(*order_, what) : cursor_.number(what); }
  /// Least bytes of the file that so many numbers take.
  std::uint64_t least_bytes(std::uint64_t n_integers, std::uint64_t n_reals) const {
    constexpr std::uint64_t kTextBytes = 2;  // a digit and a blank
    if (!order_) return kTextBytes * (n_integers + n_reals);
    return sizeof(std::int32_t) * n_integers + sizeof(double) * n_reals;
  }
  std::string_view hint() const {
    return order_ ? "the file is cut off, or of the other byte order (.b8.ugrid: big endian, .lb8.ugrid: little)"
                  : "the file is cut off";
  }
  Cursor& cursor() { return cursor_; }

 private:
  Cursor cursor_;
  std::optional<std::endian> order_;
};

class UgridReader {
 public:
  UgridReader(std::string_view bytes, const std::string& file, std::optional<std::endian> order)
      : numbers_(bytes, file, order), builder_(file) {}

  VolumeFile read() {
    read_header();
    read_points();
    read_faces();
    for (std::size_t type = 0; type < mesh::kNCellTypes; ++type) read_cells(static_cast<CellType>(type));
    return builder_.finish();
  }

 private:
  std::uint64_t n_cells(CellType type) const { return count_[3 + static_cast<std::size_t>(type)]; }

  void read_header() {
    constexpr std::array<std::string_view, kUgridHeader> kNames = {
        "the number of points (as text; binary files end in .b8.ugrid or .lb8.ugrid)",
        "the number of triangles",
        "the number of quads",
        "the number of tetrahedra",
        "the number of pyramids",
        "the number of wedges",
        "the number of hexahedra"};
    constexpr std::int64_t kMost = std::int64_t{1} << 40;  // so that the sums below do not overflow
    for (std::size_t i = 0; i < kUgridHeader; ++i) {
      const std::int64_t n = numbers_.integer(kNames[i]);
      if (n < 0 || n > kMost) fail(fmt::format("expected {}, found {}; {}", kNames[i], n, numbers_.hint()));
      count_[i] = static_cast<std::uint64_t>(n);
    }
    std::uint64_t n_integers = 4 * count_[1] + 5 * count_[2];
    for (std::size_t type = 0; type < mesh::kNCellTypes; ++type) {
      n_integers += count_[3 + type] * static_cast<std::uint64_t>(mesh::kCellSize[type]);
    }
    const std::uint64_t least = numbers_.least_bytes(n_integers, 3 * count_[0]);
    const std::size_t left = numbers_.cursor().left();
    if (least > left + 1) {  // text may end without a line end
      fail(fmt::format("the header claims a mesh of {} bytes or more, {} follow; {}", least, left, numbers_.hint()));
    }
  }

  [[noreturn]] void fail(const std::string& what) { numbers_.cursor().fail(what); }

  void read_points() {
    builder_.expect_points(count_[0]);
    for (std::uint64_t i = 0; i < count_[0]; ++i) {
      Vec3 p;
      for (int axis = 0; axis < 3; ++axis) p[axis] = numbers_.real("a coordinate");
      builder_.add_point(p, numbers_.cursor().position());
    }
  }

  std::int64_t read_node() { return numbers_.integer("the number of a point") - 1; }

  /// The numbers of patches follow behind all faces: the faces wait for them.
  void read_faces() {
    const std::uint64_t n_faces = count_[1] + count_[2];
    std::vector<std::array<std::int64_t, 4>> faces(n_faces);
    for (std::uint64_t f = 0; f < n_faces; ++f) {
      for (std::size_t k = 0; k < size_of_face(f); ++k) faces[f][k] = read_node();
    }
    const FilePosition where = numbers_.cursor().position();
    std::vector<std::int64_t> numbers(n_faces);
    for (std::int64_t& number : numbers) number = numbers_.integer("the number of a patch");
    for (const std::int64_t number : std::set<std::int64_t>(numbers.begin(), numbers.end())) {
      patch_of_number_[number] = builder_.patch(name_of_number(number));
    }
    for (std::uint64_t f = 0; f < n_faces; ++f) {
      builder_.add_face(patch_of_number_.at(numbers[f]), std::span(faces[f]).first(size_of_face(f)), where);
    }
  }

  std::size_t size_of_face(std::uint64_t f) const { return f < count_[1] ? 3 : 4; }

  void read_cells(CellType type) {
    const auto& place = kUgridNodes[static_cast<std::size_t>(type)];
    const auto size = static_cast<std::size_t>(mesh::size_of(type));
    for (std::uint64_t c = 0; c < n_cells(type); ++c) {
      std::array<std::int64_t, 8> nodes{};
      for (std::size_t k = 0; k < size; ++k) nodes[place[k]] = read_node();
      builder_.add_cell(type, nodes, n_cells_read_++, 0, numbers_.cursor().position());
    }
  }

  UgridNumbers numbers_;
  MeshBuilder builder_;
  std::array<std::uint64_t, kUgridHeader> count_{};
  std::map<std::int64_t, PatchId> patch_of_number_;
  std::uint64_t n_cells_read_ = 0;
};

/// A line of a .mapbc.
struct MappedPatch {
  std::int64_t code = 0;
  std::string name;  ///< may be empty
};

/// By the default name that patches of that number have.
std::map<std::string, MappedPatch> parse_mapbc(std::string_view bytes, const std::string& file) {
  constexpr std::size_t kBytesOfLine = 4;  // "1 3\n"
  Cursor cursor(bytes, file);
  const std::size_t n = cursor.count("the number of patches", kBytesOfLine);
  std::map<std::string, MappedPatch> patches;
  for (std::size_t i = 0; i < n; ++i) {
    if (!cursor.next_line()) cursor.fail(fmt::format("expected patch {} of {}, found the end of the file", i + 1, n));
    const std::int64_t number = cursor.to_integer(cursor.word_of_line(), "the number of a patch");
    MappedPatch& patch = patches[name_of_number(number)];
    patch.code = cursor.to_integer(cursor.word_of_line(), "the number of a boundary condition");
    patch.name = cursor.word_of_line();  // what follows FUN3D does not read, either
  }
  return patches;
}

}  // namespace

VolumeFile parse_ugrid(std::string_view bytes, const std::string& file) { return UgridReader(bytes, file, {}).read(); }

VolumeFile parse_ugrid_big(std::string_view bytes, const std::string& file) {
  return UgridReader(bytes, file, std::endian::big).read();
}

VolumeFile parse_ugrid_little(std::string_view bytes, const std::string& file) {
  return UgridReader(bytes, file, std::endian::little).read();
}

void name_patches(VolumeFile& volume, std::string_view mapbc, const std::string& file) {
  const auto mapped = parse_mapbc(mapbc, file);
  std::set<std::string> taken;
  for (mesh::BoundaryPatch& patch : volume.boundary.patches) {
    if (!mapped.contains(patch.name)) taken.insert(patch.name);
  }
  volume.patch_names.clear();
  for (mesh::BoundaryPatch& patch : volume.boundary.patches) {
    if (const auto found = mapped.find(patch.name); found != mapped.end()) {
      const MappedPatch& line = found->second;
      patch.type = type_of_fun3d_code(line.code);
      std::string name = line.name.empty() ? patch.name : line.name;
      while (!taken.insert(name).second) name = fmt::format("{}_{}", name, patch.name);
      patch.name = name;
    }
    volume.patch_names.push_back(patch.name);
  }
}

void read_names_beside(VolumeFile& volume, const std::filesystem::path& grid) {
  const std::filesystem::path map = mapbc_path(grid);
  if (std::filesystem::exists(map)) name_patches(volume, read_bytes(map), map.string());
}

}  // namespace nearwall::io
