#include "nearwall/io/boundary_file.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

#include <fmt/format.h>

#include "io/cursor.h"
#include "io/file_bytes.h"
#include "io/polydata_input.h"
#include "io/vtk_xml_input.h"

namespace nearwall::io {
namespace {

constexpr const char* kNode = "Node";
constexpr const char* kPatch = "Patch";
constexpr const char* kPatchTypes = "PatchTypes";

mesh::BoundaryType type_named(const std::string& name) {
  const auto found = std::find(mesh::kBoundaryTypeNames.begin(), mesh::kBoundaryTypeNames.end(), name);
  if (found == mesh::kBoundaryTypeNames.end()) return mesh::BoundaryType::Other;
  return static_cast<mesh::BoundaryType>(found - mesh::kBoundaryTypeNames.begin());
}

class BoundaryReader {
 public:
  BoundaryReader(std::string_view bytes, std::string file, NodeIndex n_points)
      : in_(bytes, file), file_(std::move(file)), n_points_(n_points) {}

  mesh::Boundary read() {
    if (in_.type() != "PolyData" || in_.pieces().size() != 1) fail("expected one piece of polygons (PolyData)");
    const std::vector<double> node = in_.reals(array("PointData", kNode));
    const std::vector<std::int64_t> corners = in_.integers(array("Polys", "connectivity"));
    const std::vector<std::int64_t> ends = in_.integers(array("Polys", "offsets"));
    const std::vector<std::int64_t> patch = in_.integers(array("CellData", kPatch));
    if (patch.size() != ends.size())
      fail(fmt::format("{} faces, but {} numbers of patches", ends.size(), patch.size()));
    read_patches();
    for (std::size_t f = 0, begin = 0; f < ends.size(); ++f) {
      const auto end = static_cast<std::size_t>(ends[f]);
      if (ends[f] < 0 || end < begin + 3 || end > begin + 4 || end > corners.size()) {
        fail(fmt::format("face {}: expected a triangle or a quad", f));
      }
      mesh::BoundaryFace face{0, 0, 0, mesh::kNoFourthNode};
      for (std::size_t k = begin; k < end; ++k) face[k - begin] = node_at(node, corners[k], f);
      begin = end;
      if (patch[f] < 0 || static_cast<std::uint64_t>(patch[f]) >= boundary_.patches.size()) {
        fail(fmt::format("face {} is of patch {}, but there are {} names", f, patch[f], boundary_.patches.size()));
      }
      boundary_.faces.push_back(face);
      boundary_.patch.push_back(PatchId(static_cast<std::size_t>(patch[f])));
    }
    return std::move(boundary_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    fail_at({file_, true, 0}, fmt::format("{}; this is no boundary of a mesh as nearwall writes it", what));
  }

  const XmlArray* find(std::string_view section, std::string_view name) const {
    for (const XmlArray& array : in_.arrays()) {
      if (array.section == section && array.name() == name) return &array;
    }
    return nullptr;
  }

  const XmlArray& array(std::string_view section, std::string_view name) const {
    const XmlArray* const found = find(section, name);
    if (!found) fail(fmt::format("expected an array {} in {}", name, section));
    return *found;
  }

  void read_patches() {
    const XmlArray* const types = find("FieldData", kPatchTypes);
    const std::vector<std::string> type_names = types ? in_.strings(*types) : std::vector<std::string>();
    for (const std::string& name : in_.strings(array("FieldData", kPatchNames))) {
      const std::size_t i = boundary_.patches.size();
      boundary_.patches.push_back(
          {name, i < type_names.size() ? type_named(type_names[i]) : mesh::BoundaryType::Other});
    }
  }

  NodeIndex node_at(const std::vector<double>& node, std::int64_t corner, std::size_t face) const {
    if (corner < 0 || static_cast<std::uint64_t>(corner) >= node.size()) {
      fail(fmt::format("face {} uses point {}, but there are {}", face, corner, node.size()));
    }
    const double number = node[static_cast<std::size_t>(corner)];
    if (!(number >= 0) || !(number < static_cast<double>(n_points_)) || number != std::floor(number)) {
      fail(fmt::format("face {} is of node {}, but the mesh has {} points: it belongs to another mesh", face, number,
                       n_points_));
    }
    return static_cast<NodeIndex>(number);
  }

  VtkXmlInput in_;
  std::string file_;
  NodeIndex n_points_;
  mesh::Boundary boundary_;
};

}  // namespace

std::filesystem::path boundary_file_of(const std::filesystem::path& mesh) {
  const std::string stem = (is_gzip_name(mesh) ? mesh.stem() : mesh).stem().string();
  return mesh.parent_path() / (stem + "-boundary.vtp");
}

PolyDataFile boundary_polydata(const mesh::Boundary& boundary, const std::function<Vec3(NodeIndex)>& position) {
  PolyDataFile file;
  std::unordered_map<NodeIndex, std::uint32_t> number;
  std::vector<double> node;  // exact up to 2^53
  const auto own = [&](NodeIndex n) {
    const auto [found, is_new] = number.emplace(n, static_cast<std::uint32_t>(file.points.size()));
    if (is_new) {
      file.points.push_back(position(n));
      node.push_back(static_cast<double>(n));
    }
    return found->second;
  };
  std::vector<std::int32_t> patch;
  for (const int size : {3, 4}) {
    for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
      const mesh::BoundaryFace& face = boundary.faces[f];
      if (mesh::size_of(face) != size) continue;
      const std::uint32_t a = own(face[0]), b = own(face[1]), c = own(face[2]);
      if (size == 3) {
        file.triangles.push_back({a, b, c});
      } else {
        file.quads.push_back({a, b, c, own(face[3])});
      }
      patch.push_back(static_cast<std::int32_t>(boundary.patch[f].index()));
    }
  }
  file.point_data.push_back({kNode, std::move(node)});
  file.triangle_data.push_back({kPatch, std::move(patch)});
  StringArray names{std::string(kPatchNames), {}}, types{kPatchTypes, {}};
  for (const mesh::BoundaryPatch& p : boundary.patches) {
    names.values.push_back(p.name);
    types.values.emplace_back(mesh::name_of(p.type));
  }
  file.field_data = {std::move(names), std::move(types)};
  return file;
}

mesh::Boundary read_boundary(const std::filesystem::path& path, NodeIndex n_points) {
  const std::string bytes = read_bytes(path);
  return BoundaryReader(bytes, path.string(), n_points).read();
}

}  // namespace nearwall::io
