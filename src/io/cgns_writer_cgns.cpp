#include "nearwall/io/cgns_writer.h"

#include <cgnslib.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/batches.h"
#include "io/cell_sections.h"
#include "io/cgns_names.h"
#include "io/format_limits.h"
#include "io/hdf5_session.h"
#include "io/hdf5_traces.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/pending_file.h"

namespace nearwall::io {
namespace {

using mesh::BoundaryType;
using mesh::CellType;

static_assert(kMostOfCgns <= static_cast<std::uint64_t>(std::numeric_limits<cgsize_t>::max()));
constexpr std::size_t kFacesAtOnce = std::size_t{1} << 16;
constexpr int kDimension = 3;
constexpr const char* kZone = "Zone";

// CGNS numbers the nodes of all four as predicates/cells.h does: the first face counterclockwise seen from the others.
constexpr std::array<CGNS_ENUMT(ElementType_t), mesh::kNCellTypes> kElements = {
    CGNS_ENUMV(TETRA_4), CGNS_ENUMV(PYRA_5), CGNS_ENUMV(PENTA_6), CGNS_ENUMV(HEXA_8)};
constexpr std::array<const char*, mesh::kNCellTypes> kSectionNames = {"Tetrahedra", "Pyramids", "Wedges", "Hexahedra"};

CGNS_ENUMT(BCType_t) condition_of(BoundaryType type) {
  switch (type) {
    case BoundaryType::Wall:
      return CGNS_ENUMV(BCWallViscous);
    case BoundaryType::Symmetry:
      return CGNS_ENUMV(BCSymmetryPlane);
    case BoundaryType::Inlet:
      return CGNS_ENUMV(BCInflow);
    case BoundaryType::Outlet:
      return CGNS_ENUMV(BCOutflow);
    case BoundaryType::FarField:
      return CGNS_ENUMV(BCFarfield);
    case BoundaryType::Other:
      break;
  }
  return CGNS_ENUMV(BCTypeUserDefined);
}

std::string section_name(const CellSection& section) {
  return fmt::format("{}{}", section.in_layers ? "Layer" : "", kSectionNames[static_cast<std::size_t>(section.type)]);
}

/// All that a base or a zone may have beside patches.
std::set<std::string, std::less<>> reserved_names() {
  std::set<std::string, std::less<>> names = {kZone,        "ZoneType",  "GridCoordinates",  "ZoneBC",
                                              kLayersGroup, "DataClass", "DimensionalUnits", "ReferenceState"};
  for (std::size_t type = 0; type < mesh::kNCellTypes; ++type) {
    for (const bool in_layers : {false, true}) {
      names.insert(section_name({in_layers, static_cast<CellType>(type), 0}));
    }
  }
  return names;
}

void ignore(int, char*) {}

/// A file of the CGNS library. Its calls are made in a Hdf5Session: it has one last error, one current node.
class CgnsFile {
 public:
  CgnsFile(const std::filesystem::path& name, const std::filesystem::path& path) : path_(path) {
    const Hdf5Session session;
    cg_error_handler(ignore);  // warnings would go to standard output
    check(cg_set_file_type(CG_FILE_HDF5));
    check(cg_open(name.c_str(), CG_MODE_WRITE, &number_));
  }
  ~CgnsFile() {
    const Hdf5Session session;
    if (number_ != kClosed) cg_close(number_);
  }
  CgnsFile(const CgnsFile&) = delete;
  CgnsFile& operator=(const CgnsFile&) = delete;

  void close() {
    const Hdf5Session session;
    check(cg_close(std::exchange(number_, kClosed)));
  }
  int number() const { return number_; }
  void check(int code) const {
    if (code != CG_OK) throw IoError(fmt::format("{}: cannot be written: CGNS: {}", path_.string(), cg_get_error()));
  }

 private:
  static constexpr int kClosed = -1;
  const std::filesystem::path& path_;
  int number_ = kClosed;
};

class CgnsWriter {
 public:
  CgnsWriter(const std::filesystem::path& path, const WholeMesh& mesh, ProgressSink& progress)
      : pending_(path), mesh_(mesh), progress_(progress), file_(pending_.temporary(), pending_.path()) {}

  void write() {
    open_zone();
    write_points();
    write_cells();
    write_patches();
    file_.close();
    clear_traces(pending_.temporary());
    pending_.commit();
  }

 private:
  void check(int code) const { file_.check(code); }
  int file() const { return file_.number(); }

  void open_zone() {
    const Hdf5Session session;
    const std::string base_name = CgnsNames({}).add(mesh_.name.empty() ? "Base" : mesh_.name);
    check(cg_base_write(file(), base_name.c_str(), kDimension, kDimension, &base_));
    check(cg_goto(file(), base_, "end"));
    check(cg_dataclass_write(CGNS_ENUMV(NormalizedByUnknownDimensional)));  // the unit of the case has no name
    const std::array<cgsize_t, 3> size = {static_cast<cgsize_t>(mesh_.cells.n_points()),
                                          static_cast<cgsize_t>(mesh_.cells.n_cells()), 0};
    check(cg_zone_write(file(), base_, kZone, size.data(), CGNS_ENUMV(Unstructured), &zone_));
  }

  void write_points() {
    in_batches(
        mesh_.cells.n_point_batches(),
        [&](std::size_t batch) {
          mesh::PointBatch points;
          mesh_.cells.read_points(batch, points);
          return points;
        },
        [&](std::size_t, mesh::PointBatch& points) { write_coordinates(points); });
    const Hdf5Session session;
    // What is a length to the power of one, a coordinate: mass, length, time, temperature, angle.
    const std::array<float, 5> exponents = {0, 1, 0, 0, 0};
    for (int axis = 1; axis <= kDimension; ++axis) {
      check(cg_goto(file(), base_, "Zone_t", zone_, "GridCoordinates_t", 1, "DataArray_t", axis, "end"));
      check(cg_exponents_write(CGNS_ENUMV(RealSingle), exponents.data()));
    }
  }

  void write_coordinates(const mesh::PointBatch& points) {
    if (points.size() == 0) return;
    const auto first = static_cast<cgsize_t>(points.first + 1);
    const auto last = static_cast<cgsize_t>(points.first + points.size());
    const std::array<const char*, kDimension> names = {"CoordinateX", "CoordinateY", "CoordinateZ"};
    std::vector<double> values(points.size());
    for (int axis = 0; axis < kDimension; ++axis) {
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = points.position[i][axis];
      const Hdf5Session session;
      int number = 0;
      check(cg_coord_partial_write(file(), base_, zone_, CGNS_ENUMV(RealDouble), names[static_cast<std::size_t>(axis)],
                                   &first, &last, values.data(), &number));
    }
    report(points.size());
  }

  void write_cells() {
    const CellSections sections(mesh_.cells);
    CellIndex n_in_layers = 0;
    for (const CellSection& section : sections.sections()) {
      const int number =
          add_section(section_name(section), kElements[static_cast<std::size_t>(section.type)], section.n_cells);
      const auto n_nodes = static_cast<std::size_t>(mesh::size_of(section.type));
      sections.stream(
          section,
          [n_nodes](const mesh::CellBatch& cells, const std::vector<std::uint32_t>& places) {
            std::vector<cgsize_t> nodes;
            nodes.reserve(places.size() * n_nodes);
            for (const std::uint32_t c : places) {
              for (std::size_t k = 0; k < n_nodes; ++k) nodes.push_back(static_cast<cgsize_t>(cells.nodes[c][k] + 1));
            }
            return nodes;
          },
          [&](const std::vector<cgsize_t>& nodes) {
            write_elements(number, nodes, n_nodes);
            report(nodes.size() / n_nodes);
          });
      if (section.in_layers) n_in_layers += section.n_cells;
    }
    if (n_in_layers > 0) write_layers_group(static_cast<cgsize_t>(n_in_layers));
  }

  /// The layers are the first cells.
  void write_layers_group(cgsize_t n) {
    const Hdf5Session session;
    const std::array<cgsize_t, 2> range = {1, n};
    int number = 0;
    check(cg_subreg_ptset_write(file(), base_, zone_, kLayersGroup, kDimension, CGNS_ENUMV(CellCenter),
                                CGNS_ENUMV(PointRange), 2, range.data(), &number));
  }

  /// A section of the next elements; `write_elements` fills it.
  int add_section(const std::string& name, CGNS_ENUMT(ElementType_t) type, std::uint64_t n) {
    const Hdf5Session session;
    int number = 0;
    check(cg_section_partial_write(file(), base_, zone_, name.c_str(), type, n_elements_ + 1,
                                   n_elements_ + static_cast<cgsize_t>(n), 0, &number));
    return number;
  }

  void write_elements(int section, const std::vector<cgsize_t>& nodes, std::size_t n_each) {
    const auto n = static_cast<cgsize_t>(nodes.size() / n_each);
    const Hdf5Session session;
    check(cg_elements_partial_write(file(), base_, zone_, section, n_elements_ + 1, n_elements_ + n, nodes.data()));
    n_elements_ += n;
  }

  void write_patches() {
    CgnsNames names(reserved_names());
    const auto faces = mesh::faces_by_patch(mesh_.boundary);
    for (const PatchId patch : mesh_.boundary.patches.ids()) {
      const std::string name = names.add(mesh_.boundary.patches[patch].name);
      write_family(mesh_.boundary.patches[patch], name);
      if (faces[patch].empty()) continue;
      const cgsize_t first = n_elements_ + 1;
      write_faces(faces[patch], name, names);
      write_condition(name, {first, n_elements_});
    }
  }

  /// Triangles and quads are sections of their own: of the patch's name where it has only one kind.
  void write_faces(const std::vector<std::uint32_t>& faces, const std::string& name, CgnsNames& names) {
    std::array<std::vector<std::uint32_t>, 2> by_kind;
    for (const std::uint32_t f : faces) by_kind[mesh::size_of(mesh_.boundary.faces[f]) == 3 ? 0 : 1].push_back(f);
    const bool is_mixed = !by_kind[0].empty() && !by_kind[1].empty();
    for (const std::size_t kind : {0, 1}) {
      if (by_kind[kind].empty()) continue;
      const char* const ending = kind == 0 ? "triangles" : "quads";
      const int section = add_section(is_mixed ? names.add(fmt::format("{} {}", ending, name)) : name,
                                      kind == 0 ? CGNS_ENUMV(TRI_3) : CGNS_ENUMV(QUAD_4), by_kind[kind].size());
      write_faces_of_kind(by_kind[kind], 3 + kind, section);
    }
  }

  void write_faces_of_kind(const std::vector<std::uint32_t>& faces, std::size_t n_each, int section) {
    std::vector<cgsize_t> nodes;
    for (std::size_t begin = 0; begin < faces.size(); begin += kFacesAtOnce) {
      nodes.clear();
      for (std::size_t i = begin; i < std::min(faces.size(), begin + kFacesAtOnce); ++i) {
        const mesh::BoundaryFace& face = mesh_.boundary.faces[faces[i]];
        for (std::size_t k = 0; k < n_each; ++k) nodes.push_back(static_cast<cgsize_t>(face[k] + 1));
      }
      write_elements(section, nodes, n_each);
    }
  }

  void write_family(const mesh::BoundaryPatch& patch, const std::string& name) {
    const Hdf5Session session;
    int family = 0, condition = 0;
    check(cg_family_write(file(), base_, name.c_str(), &family));
    check(cg_fambc_write(file(), base_, family, "FamBC", condition_of(patch.type), &condition));
    if (name == patch.name || patch.name.empty()) return;  // the library writes no empty text
    check(cg_goto(file(), base_, "Family_t", family, "end"));
    check(cg_descriptor_write(kFullNameText, patch.name.c_str()));
  }

  /// Its type is that of its family: VTK's reader passes over most conditions that give it themselves.
  void write_condition(const std::string& name, std::array<cgsize_t, 2> elements) {
    const Hdf5Session session;
    int condition = 0;
    check(cg_boco_write(file(), base_, zone_, name.c_str(), CGNS_ENUMV(FamilySpecified), CGNS_ENUMV(PointRange), 2,
                        elements.data(), &condition));
    check(cg_boco_gridlocation_write(file(), base_, zone_, condition, CGNS_ENUMV(FaceCenter)));
    check(cg_goto(file(), base_, "Zone_t", zone_, "ZoneBC_t", 1, "BC_t", condition, "end"));
    check(cg_famname_write(name.c_str()));
  }

  void report(std::size_t n) {
    n_done_ += n;
    progress_.update(static_cast<double>(n_done_) /
                     static_cast<double>(mesh_.cells.n_points() + mesh_.cells.n_cells()));
  }

  PendingFile pending_;
  const WholeMesh& mesh_;
  ProgressSink& progress_;
  CgnsFile file_;
  int base_ = 0, zone_ = 0;
  cgsize_t n_elements_ = 0;  // so far
  std::uint64_t n_done_ = 0;
};

}  // namespace

void write_cgns(const std::filesystem::path& path, const WholeMesh& mesh, ProgressSink* progress) {
  require_cgns_limits(path, mesh);
  CgnsWriter(path, mesh, progress ? *progress : silent_progress()).write();
}

}  // namespace nearwall::io
