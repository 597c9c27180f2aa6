#include "nearwall/pipeline/faults_file.h"

namespace nearwall::pipeline {

io::PolyDataFile faults_file(const mesh::SurfaceMesh& surface, const std::vector<surface::Fault>& faults) {
  std::vector<FaceId> triangles;
  std::vector<std::int32_t> kinds;
  io::StringArray names{"FaultNames", {}};
  for (const surface::Fault& fault : faults) {
    triangles.insert(triangles.end(), fault.triangles.begin(), fault.triangles.end());
    kinds.insert(kinds.end(), fault.triangles.size(), static_cast<std::int32_t>(names.values.size()));
    names.values.emplace_back(surface::fault_name(fault.kind));
  }
  io::PolyDataFile file = io::polydata_of(surface, triangles);
  file.triangle_data.push_back({"Fault", std::move(kinds)});
  file.field_data.push_back(std::move(names));
  return file;
}

}  // namespace nearwall::pipeline
