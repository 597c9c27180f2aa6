#include "tests/io/surface_by_library.h"

#include <array>
#include <stdexcept>
#include <vector>

#include <cgnslib.h>

namespace nearwall::io {

namespace {

void check(int code) {
  if (code != CG_OK) throw std::runtime_error(cg_get_error());
}

}  // namespace

void write_surface_by_library(const std::filesystem::path& path, const mesh::SurfaceMesh& surface) {
  int file = 0, base = 0, zone = 0;
  check(cg_set_file_type(CG_FILE_HDF5));
  check(cg_open(path.c_str(), CG_MODE_WRITE, &file));
  check(cg_base_write(file, "Base", 2, 3, &base));
  const std::array<cgsize_t, 3> size = {static_cast<cgsize_t>(surface.points.size()),
                                        static_cast<cgsize_t>(surface.faces.size()), 0};
  check(cg_zone_write(file, base, "Zone", size.data(), CGNS_ENUMV(Unstructured), &zone));
  for (const int axis : {0, 1, 2}) {
    std::vector<double> values;
    for (const Vec3& p : surface.points) values.push_back(p[axis]);
    constexpr std::array kNames = {"CoordinateX", "CoordinateY", "CoordinateZ"};
    int coordinate = 0;
    check(cg_coord_write(file, base, zone, CGNS_ENUMV(RealDouble), kNames[static_cast<std::size_t>(axis)],
                         values.data(), &coordinate));
  }
  cgsize_t end = 0;
  for (const PatchId patch : surface.patch_names.ids()) {
    std::vector<cgsize_t> nodes;
    for (const FaceId f : surface.faces.ids()) {
      if (surface.face_patch[f] != patch) continue;
      for (const VertexId v : surface.faces[f]) nodes.push_back(static_cast<cgsize_t>(v.index()) + 1);
    }
    const std::string& name = surface.patch_names[patch];
    std::array<cgsize_t, 2> range = {end + 1, end + static_cast<cgsize_t>(nodes.size() / 3)};
    end = range[1];
    int section = 0, condition = 0;
    check(cg_section_write(file, base, zone, ("Triangles of " + name).c_str(), CGNS_ENUMV(TRI_3), range[0], range[1], 0,
                           nodes.data(), &section));
    check(cg_boco_write(file, base, zone, name.c_str(), CGNS_ENUMV(BCWall), CGNS_ENUMV(PointRange), 2, range.data(),
                        &condition));
    check(cg_boco_gridlocation_write(file, base, zone, condition, CGNS_ENUMV(CellCenter)));
  }
  check(cg_close(file));
}

}  // namespace nearwall::io
