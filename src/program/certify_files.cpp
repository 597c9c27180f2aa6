#include "program/certify_files.h"

#include <algorithm>
#include <map>
#include <set>

#include "nearwall/io/polydata_writer.h"
#include "nearwall/io/vtu_writer.h"
#include "nearwall/mesh/volume_source.h"

namespace nearwall::program {

namespace {

using certify::kFaceFaultNames;
using certify::MeshCertificate;
using mesh::FaceName;

/// A face and the number of its fault: those of FaceFault first.
using FaultyFace = std::pair<std::int32_t, FaceName>;

constexpr auto kIntersection = static_cast<std::int32_t>(kFaceFaultNames.size());
constexpr std::int32_t kUndecidedIntersection = kIntersection + 1;
constexpr std::int32_t kCoveredTwice = kIntersection + 2;

io::StringArray fault_names() {
  io::StringArray names{"FaultNames", {}};
  for (const std::string_view name : kFaceFaultNames) names.values.emplace_back(name);
  for (const char* name : {"intersection", "undecided-intersection", "covered-twice"}) names.values.emplace_back(name);
  return names;
}

/// Each face once for each of its faults.
std::set<FaultyFace> faulty_faces(const MeshCertificate& c) {
  std::set<FaultyFace> faces;
  for (const certify::NonconformingFace& f : c.faces.nonconforming) {
    faces.emplace(static_cast<std::int32_t>(f.fault), f.face);
  }
  const auto add = [&](std::int32_t fault, const auto& pairs) {
    for (const auto& [i, j] : pairs) {
      faces.emplace(fault, c.faces.boundary[i]);
      faces.emplace(fault, c.faces.boundary[j]);
    }
  };
  if (c.intersections) {
    add(kIntersection, c.intersections->meeting);
    add(kUndecidedIntersection, c.intersections->undecided);
  }
  if (c.covered_twice) {
    for (const FaceName face : *c.covered_twice) faces.emplace(kCoveredTwice, face);
  }
  return faces;
}

}  // namespace

std::size_t write_offending_cells(const std::filesystem::path& path, const mesh::VolumeMesh& mesh,
                                  const MeshCertificate& certificate) {
  const auto& offenders = certificate.cells.offenders;
  if (offenders.empty()) return 0;
  std::vector<CellIndex> cells;
  for (const certify::Offender& o : offenders) cells.push_back(o.cell);
  const mesh::VolumeSource source(mesh, cells);
  const std::vector<io::CellArray> arrays = {
      {"Cell",
       [&](const mesh::CellBatch& batch, std::span<double> out) {
         for (std::size_t i = 0; i < out.size(); ++i) {
           out[i] = static_cast<double>(source.file_cell(batch.first + i));
         }
       }},
      {"Verdict", [&](const mesh::CellBatch& batch, std::span<double> out) {
         for (std::size_t i = 0; i < out.size(); ++i) {
           out[i] = offenders[batch.first + i].verdict == predicates::Positivity::Undecided ? 1 : 0;
         }
       }}};
  io::write_vtu(path, source, arrays, {});
  return cells.size();
}

std::size_t write_offending_faces(const std::filesystem::path& path, const mesh::VolumeMesh& mesh,
                                  const MeshCertificate& certificate) {
  const std::set<FaultyFace> faces = faulty_faces(certificate);
  if (faces.empty()) return 0;
  io::PolyDataFile file;
  std::map<std::uint32_t, std::uint32_t> number;
  const auto own = [&](std::uint32_t node) {
    const auto [at, is_new] = number.try_emplace(node, static_cast<std::uint32_t>(file.points.size()));
    if (is_new) file.points.push_back(mesh.points[node]);
    return at->second;
  };
  std::vector<double> cell;
  std::vector<std::int32_t> fault;
  for (const auto& [kind, face] : faces) {
    const mesh::FaceNodes nodes = nodes_of(mesh, face);
    for (std::size_t k = 2; k < static_cast<std::size_t>(mesh::size_of(nodes)); ++k) {
      file.triangles.push_back({own(nodes[0]), own(nodes[k - 1]), own(nodes[k])});
      cell.push_back(static_cast<double>(mesh.file_cell[face.cell()]));
      fault.push_back(kind);
    }
  }
  file.triangle_data.push_back({"Cell", std::move(cell)});
  file.triangle_data.push_back({"Fault", std::move(fault)});
  file.field_data.push_back(fault_names());
  io::write_polydata(path, file);
  return faces.size();
}

}  // namespace nearwall::program
