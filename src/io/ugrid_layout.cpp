#include "io/ugrid_layout.h"

#include "io/cursor.h"
#include "io/file_bytes.h"

namespace nearwall::io {

using mesh::BoundaryType;

std::filesystem::path mapbc_path(const std::filesystem::path& grid) {
  std::filesystem::path name = is_gzip_name(grid) ? grid.stem() : grid.filename();
  name = name.stem();
  const std::string form = name.extension().string();
  if (same_word(form, ".b8") || same_word(form, ".lb8")) name = name.stem();
  name += ".mapbc";
  return grid.parent_path() / name;
}

int fun3d_code(BoundaryType type, std::optional<int> normal_axis) {
  switch (type) {
    case BoundaryType::Wall:
      return kFun3dViscousWall;
    case BoundaryType::Symmetry:
      return normal_axis ? kFun3dSymmetryX + *normal_axis : kFun3dTangency;
    case BoundaryType::Inlet:
      return kFun3dSubsonicInflow;
    case BoundaryType::Outlet:
      return kFun3dSubsonicOutflow;
    case BoundaryType::FarField:
      return kFun3dFarField;
    case BoundaryType::Other:
      break;
  }
  return kFun3dNone;
}

BoundaryType type_of_fun3d_code(std::int64_t code) {
  switch (code) {
    case 4:  // older files have one digit
    case kFun3dViscousWall:
    case 4010:  // with suction or blowing: by mass flux, by normal velocity, by velocity
    case 4020:
    case 4030:
    case 4100:  // by a wall function
    case 4110:
      return BoundaryType::Wall;
    case 3:
    case kFun3dFarField:
    case 5025:  // by Riemann invariants
    case 5050:  // the free stream as it is
      return BoundaryType::FarField;
    case kFun3dTangency:
    case kFun3dSymmetryX:
    case kFun3dSymmetryX + 1:
    case kFun3dSymmetryX + 2:
      return BoundaryType::Symmetry;
    case kFun3dSubsonicInflow:
    case 7021:  // by a pressure and a temperature
    case 7036:  // by a mass flow
    case 7100:  // a fixed flow
      return BoundaryType::Inlet;
    case 5026:  // extrapolation
    case 5051:  // a back pressure
    case 5052:
    case kFun3dSubsonicOutflow:
    case 7031:  // by a mass flow
      return BoundaryType::Outlet;
    default:
      return BoundaryType::Other;
  }
}

}  // namespace nearwall::io
