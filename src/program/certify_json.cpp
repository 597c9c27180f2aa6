#include "program/certify_report.h"

#include <algorithm>
#include <cmath>

namespace nearwall::program {

namespace {

using certify::MeshCertificate;
using nlohmann::json;

json by_type(const std::array<std::uint64_t, mesh::kNCellTypes>& counts) {
  json out;
  for (std::size_t t = 0; t < mesh::kNCellTypes; ++t) out[std::string(mesh::kCellTypeNames[t])] = counts[t];
  return out;
}

/// Places that are not finite have no number in JSON.
json json_of(const Vec3& p) {
  if (!is_finite(p)) return json();
  return {p.x(), p.y(), p.z()};
}

template <class T>
json or_null(const std::optional<T>& value) {
  return value ? json(*value) : json();
}

json offenders(const CertifyReport& report) {
  const mesh::VolumeMesh& mesh = report.volume.mesh;
  json list = json::array();
  for (const certify::Offender& o : report.certificate.cells.offenders) {
    if (list.size() == report.n_offenders) break;
    const bool is_undecided = o.verdict == predicates::Positivity::Undecided;
    list.push_back({{"cell", mesh.file_cell[o.cell]},
                    {"type", mesh::kCellTypeNames[static_cast<std::size_t>(mesh.type[o.cell])]},
                    {"centre", json_of(centre_of_cell(mesh, o.cell))},
                    {"verdict", is_undecided ? "undecided" : "not-positive"},
                    {"has_repeated_node", o.has_repeated_node}});
  }
  return list;
}

json faces_at_fault(const CertifyReport& report) {
  const mesh::VolumeMesh& mesh = report.volume.mesh;
  json list = json::array();
  for (const certify::NonconformingFace& f : report.certificate.faces.nonconforming) {
    if (list.size() == report.n_offenders) break;
    list.push_back({{"cell", mesh.file_cell[f.face.cell()]},
                    {"fault", certify::kFaceFaultNames[static_cast<std::size_t>(f.fault)]},
                    {"centre", json_of(centre_of_face(mesh, f.face))}});
  }
  return list;
}

json pairs(const CertifyReport& report, std::vector<std::pair<std::uint32_t, std::uint32_t>> const& found) {
  const mesh::VolumeMesh& mesh = report.volume.mesh;
  json list = json::array();
  for (const auto& [i, j] : found) {
    if (list.size() == report.n_offenders) break;
    const mesh::FaceName a = report.certificate.faces.boundary[i], b = report.certificate.faces.boundary[j];
    list.push_back({{"cells", {mesh.file_cell[a.cell()], mesh.file_cell[b.cell()]}},
                    {"centre", json_of(centre_of_face(mesh, a))}});
  }
  return list;
}

json covers(const CertifyReport& report) {
  const mesh::VolumeMesh& mesh = report.volume.mesh;
  json list = json::array();
  for (const mesh::FaceName face : report.certificate.covered_twice.value_or(std::vector<mesh::FaceName>())) {
    if (list.size() == report.n_offenders) break;
    list.push_back({{"cell", mesh.file_cell[face.cell()]}, {"centre", json_of(centre_of_face(mesh, face))}});
  }
  return list;
}

json json_of(const WallReport& wall, const quality::WallPatchLayers& p) {
  return {{"area", p.area},
          {"matched_percent", p.matched_percent},
          {"full_percent", json()},
          {"all_layers_percent", p.all_layers_percent},
          {"any_percent", p.any_percent},
          {"mean_layers", p.mean_layers},
          {"count", {{"asked", or_null(wall.asked_count)}, {"all", p.count}}},
          {"first_height",
           {{"asked", or_null(wall.asked_first_height)},
            {"median", p.first_height.median},
            {"p01", p.first_height.p01},
            {"p99", p.first_height.p99}}},
          {"thickness", {{"asked", json()}, {"median", p.thickness.median}, {"p01", p.thickness.p01}}},
          {"growth", {{"p01", p.growth.p01}, {"median", p.growth.median}, {"max", p.growth.max}}}};
}

json json_of(const WallReport& wall) {
  json patches = json::object();
  for (const PatchId p : wall.patches.ids()) patches[wall.surface.patch_names[p]] = json_of(wall, wall.patches[p]);
  const std::uint64_t n = wall.surface.faces.size();
  return {{"file", wall.file},
          {"triangles", n},
          {"matched",
           {{"exactly", wall.match.n_exact},
            {"nearly", wall.match.n_near},
            {"not", n - wall.match.n_exact - wall.match.n_near}}},
          {"patches", patches}};
}

}  // namespace

json json_of(const CertifyReport& report) {
  const MeshCertificate& c = report.certificate;
  json out = {{"file", report.file},
              {"valid", c.is_valid()},
              {"points", report.volume.mesh.points.size()},
              {"cells", by_type(c.cells.count)},
              {"not_positive", by_type(c.cells.not_positive)},
              {"undecided", by_type(c.cells.undecided)},
              {"skipped_cells", report.volume.skipped.all()},
              {"boundary_faces", c.faces.boundary.size()},
              {"nonconforming_faces", c.faces.nonconforming.size()},
              {"intersections", c.intersections ? json(c.intersections->meeting.size()) : json()},
              {"undecided_intersections", c.intersections ? json(c.intersections->undecided.size()) : json()},
              {"intersections_complete", c.intersections && c.intersections->is_complete},
              {"coincident_points", c.n_coincident_points},
              {"covers_twice", c.covered_twice ? json(c.covered_twice->size()) : json()},
              {"undecided_covers", c.n_undecided_parts},
              {"closure", or_null(c.closure())},
              {"volume", {{"cells", c.cells_volume}, {"domain", c.closes() ? json(c.enclosed_volume) : json()}}},
              {"offenders", offenders(report)},
              {"nonconforming", faces_at_fault(report)},
              {"covered_twice", covers(report)}};
  const search::PatchPairs none;
  const search::PatchPairs& found = c.intersections ? *c.intersections : none;
  out["intersecting"] = pairs(report, found.meeting);
  out["undecided_pairs"] = pairs(report, found.undecided);
  out["wall"] = report.wall ? json_of(*report.wall) : json();
  return out;
}

}  // namespace nearwall::program
