#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>

#include "io/cgns_boundary_hdf5.h"
#include "io/cgns_tree_hdf5.h"
#include "io/volume_formats.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/whole_mesh.h"

namespace nearwall::io {
namespace {

/// CGNS's numbers of element types, as far as they are told apart.
constexpr std::int64_t kNode = 2, kBar = 3, kTriangle = 5, kQuad = 7, kMixed = 20, kPolygons = 22, kPolyhedra = 23;

/// An element of a file, by CGNS's number of its type. Its nodes stand as in predicates/cells.h.
struct ElementKind {
  std::int64_t code;
  std::size_t n_nodes;
  int dimension;
  mesh::CellType cell = mesh::CellType::Tetrahedron;
};
constexpr std::array<ElementKind, 8> kKinds = {{{kNode, 1, 0},
                                                {kBar, 2, 1},
                                                {kTriangle, 3, 2},
                                                {kQuad, 4, 2},
                                                {10, 4, 3, mesh::CellType::Tetrahedron},
                                                {12, 5, 3, mesh::CellType::Pyramid},
                                                {14, 6, 3, mesh::CellType::Wedge},
                                                {17, 8, 3, mesh::CellType::Hexahedron}}};

const ElementKind& kind_of(const CgnsNode& section, std::int64_t code) {
  const auto found = std::find_if(kKinds.begin(), kKinds.end(), [&](const ElementKind& k) { return k.code == code; });
  if (found != kKinds.end()) return *found;
  const char* const advice = code == kPolygons || code == kPolyhedra ? "polyhedra: cut the mesh into tetrahedra"
                                                                     : "not linear: save the mesh with linear elements";
  throw InputError(fmt::format("{}: cell section {} has elements of CGNS's type {}, which are {}",
                               section.file().name(), section.path(), code, advice));
}

/// Reads the zones of a base one after the other.
class ZoneReader {
 public:
  ZoneReader(const Hdf5File& file, const CgnsFamilies& families)
      : file_(file), families_(families), builder_(file.name()) {
    for (const mesh::BoundaryPatch& patch : families.patches()) builder_.patch(patch.name, patch.type);
  }

  void read(const CgnsNode& zone) {
    require_unstructured(zone);
    first_point_ = static_cast<std::int64_t>(builder_.n_points());
    read_points(zone);
    CgnsFaces faces;
    const CgnsElements layers = layers_of(zone);
    for (const CgnsNode& section : zone.children("Elements_t")) read_section(section, layers, faces);
    faces.add_to(builder_, zone, families_, n_points());
    first_element_ += n_elements_;
    n_elements_ = 0;
  }
  VolumeFile finish() { return builder_.finish(); }

 private:
  std::int64_t n_points() const { return static_cast<std::int64_t>(builder_.n_points()) - first_point_; }
  FilePosition where() const { return {file_.name(), true, 0}; }

  void require_unstructured(const CgnsNode& zone) const {
    const std::optional<CgnsNode> type = zone.child("ZoneType_t");
    if (type && type->characters() == "Unstructured") return;
    throw InputError(fmt::format("{}: {} is structured, expected unstructured zones: save the mesh as unstructured",
                                 file_.name(), zone.path()));
  }

  void read_points(const CgnsNode& zone) {
    const std::optional<CgnsNode> grid = zone.child("GridCoordinates_t");
    if (!grid) file_.fail(fmt::format("{} has no coordinates", zone.path()));
    std::vector<Hdf5Array> axes;
    for (const char* name : {"CoordinateX", "CoordinateY", "CoordinateZ"}) {
      const std::optional<CgnsNode> axis = grid->named(name);
      if (!axis) {
        throw InputError(
            fmt::format("{}: {} has no {}: expected a mesh in space, x, y and z", file_.name(), grid->path(), name));
      }
      axes.push_back(axis->data());
      if (axes.back().size() != axes[0].size()) file_.fail(fmt::format("{}: sizes differ", grid->path()));
    }
    constexpr std::uint64_t kRun = std::uint64_t{1} << 16;
    std::array<std::vector<double>, 3> run;
    for (std::uint64_t first = 0; first < axes[0].size(); first += kRun) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        run[axis].resize(static_cast<std::size_t>(std::min(kRun, axes[0].size() - first)));
        axes[axis].read(first, std::span<double>(run[axis]));
      }
      for (std::size_t i = 0; i < run[0].size(); ++i) {
        const Vec3 p(run[0][i], run[1][i], run[2][i]);
        if (!is_finite(p)) {
          file_.fail(fmt::format("{}: point {}: expected finite coordinates, found a NaN or an infinity", grid->path(),
                                 first + i + 1));
        }
        builder_.add_point(p, where());
      }
    }
  }

  /// Numbers of the elements that are layers, where a region of our name says so.
  CgnsElements layers_of(const CgnsNode& zone) const {
    for (const CgnsNode& region : zone.children("ZoneSubRegion_t")) {
      if (region.name() == kLayersGroup) return CgnsElements(region);
    }
    return {};
  }

  void read_section(const CgnsNode& section, const CgnsElements& layers, CgnsFaces& faces) {
    const std::vector<std::int64_t> type = section.integers(2), range = section.named_integers("ElementRange", 2);
    if (range[0] < 1 || range[1] < range[0] || range[1] > kMostElements) {
      file_.fail(fmt::format("{} claims the elements {} to {}", section.path(), range[0], range[1]));
    }
    const std::optional<CgnsNode> connectivity = section.named("ElementConnectivity");
    if (!connectivity) file_.fail(fmt::format("{} has no nodes", section.path()));
    if (type[0] != kMixed) kind_of(section, type[0]);  // before anything is read
    const Hdf5Array nodes = connectivity->data();
    const std::size_t face_section = faces.add_section(section.name());
    std::int64_t element = range[0];
    const ElementKind* kind = nullptr;
    std::array<std::int64_t, 8> corners{};
    std::size_t n_known = 0;
    nodes.for_each_run<std::int64_t>(0, nodes.size(), [&](std::span<const std::int64_t> run) {
      for (const std::int64_t value : run) {
        if (!kind && type[0] == kMixed) {
          kind = &kind_of(section, value);
          continue;
        }
        if (!kind) kind = &kind_of(section, type[0]);
        if (value < 1 || value > n_points()) {
          file_.fail(fmt::format("{}: element {} uses point {}, but the zone has {} points", section.path(), element,
                                 value, n_points()));
        }
        corners[n_known++] = first_point_ + value - 1;
        if (n_known < kind->n_nodes) continue;
        if (element > range[1]) file_.fail(fmt::format("{} has more elements than it claims", section.path()));
        add_element(*kind, corners, element++, layers, face_section, faces);
        n_known = 0;
        kind = nullptr;
      }
    });
    if (element != range[1] + 1 || n_known != 0) {
      file_.fail(fmt::format("{} claims {} elements, but has {}", section.path(), range[1] - range[0] + 1,
                             element - range[0]));
    }
    n_elements_ = std::max(n_elements_, static_cast<std::uint64_t>(range[1]));
  }

  void add_element(const ElementKind& kind, const std::array<std::int64_t, 8>& corners, std::int64_t element,
                   const CgnsElements& layers, std::size_t section, CgnsFaces& faces) {
    const std::span<const std::int64_t> nodes(corners.data(), kind.n_nodes);
    if (kind.dimension == 3) {
      const std::uint64_t number = first_element_ + static_cast<std::uint64_t>(element) - 1;
      builder_.add_cell(kind.cell, nodes, number, layers.contains(element) ? 1 : 0, where());
    } else if (kind.dimension == 2) {
      faces.add(element, nodes, section);
    } else {
      ++(kind.dimension == 1 ? builder_.skipped().lines : builder_.skipped().points);
    }
  }

  static constexpr std::int64_t kMostElements = std::int64_t{1} << 48;
  const Hdf5File& file_;
  const CgnsFamilies& families_;
  MeshBuilder builder_;
  std::int64_t first_point_ = 0;     // of the zone
  std::uint64_t first_element_ = 0;  // elements of the zones before
  std::uint64_t n_elements_ = 0;     // largest number of the zone
};

void refuse_old_form(const std::filesystem::path& path) {
  std::array<char, 32> head{};
  std::ifstream(path, std::ios::binary).read(head.data(), head.size());
  if (std::string_view(head.data(), head.size()).find("ADF Database") == std::string_view::npos) return;
  throw InputError(fmt::format("{}: is CGNS in its old form, ADF: turn it into HDF5 first, by adf2hdf", path.string()));
}

}  // namespace

VolumeFile read_cgns(const std::filesystem::path& path) {
  refuse_old_form(path);
  const Hdf5File file(path);
  const std::vector<CgnsNode> bases = CgnsNode::root(file).children("CGNSBase_t");
  if (bases.empty()) file.fail("expected CGNS, found no base");
  if (bases.size() > 1) {
    throw InputError(
        fmt::format("{}: holds {} bases, expected one: save them one by one", path.string(), bases.size()));
  }
  const CgnsFamilies families(bases[0]);
  ZoneReader reader(file, families);
  for (const CgnsNode& zone : bases[0].children("Zone_t")) reader.read(zone);
  return reader.finish();
}

}  // namespace nearwall::io
