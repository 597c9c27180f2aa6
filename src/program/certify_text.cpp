#include <algorithm>

#include <fmt/format.h>

#include "program/certify_report.h"
#include "program/table.h"

namespace nearwall::program {

namespace {

using certify::FaceFault;
using certify::MeshCertificate;

std::string place(const Vec3& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z()); }

/// "12 wedges, 3 pyramids": of the types that there are.
std::string by_type(const std::array<std::uint64_t, mesh::kNCellTypes>& counts) {
  static constexpr std::array<std::string_view, mesh::kNCellTypes> kPlural{"tetrahedra", "pyramids", "wedges",
                                                                           "hexahedra"};
  std::string out;
  for (std::size_t t = 0; t < mesh::kNCellTypes; ++t) {
    if (counts[t] == 0) continue;
    const std::string_view name = counts[t] == 1 ? mesh::kCellTypeNames[t] : kPlural[t];
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", grouped(counts[t]), name);
  }
  return out.empty() ? "none" : out;
}

std::string line(std::string_view name, const std::string& text) { return fmt::format("  {:<11} {}\n", name, text); }

/// "this: 3", and what is left open.
std::string counted(std::string_view what, std::uint64_t n, std::string_view open, std::uint64_t n_open) {
  std::string out = n > 0 ? fmt::format("{}: {}", what, grouped(n)) : "";
  if (n_open > 0) out += fmt::format("{}{}: {}", out.empty() ? "" : "; ", open, grouped(n_open));
  return out;
}

std::string boundary_verdict(const MeshCertificate& c) {
  if (!c.intersections) return "has points that are not finite";
  const search::PatchPairs& found = *c.intersections;
  if (found.meeting.empty() && found.undecided.empty()) return "does not meet itself";
  return counted("pairs of faces that meet", found.meeting.size(), "pairs that cannot be told apart",
                 found.undecided.size()) +
         (found.is_complete ? "" : ", and more");
}

std::string covers_verdict(const MeshCertificate& c) {
  if (!c.covered_twice) return "cannot be counted";
  if (c.covered_twice->empty() && c.n_undecided_parts == 0) return "no point twice";
  return counted("parts of the boundary with space covered twice behind them", c.covered_twice->size(),
                 "parts that cannot be looked behind", c.n_undecided_parts);
}

/// One line for each point of the certificate.
std::string verdicts(const CertifyReport& report) {
  const MeshCertificate& c = report.certificate;
  std::string out = line("points", grouped(report.volume.mesh.points.size()));
  out += line("cells", by_type(c.cells.count));
  const std::uint64_t skipped = report.volume.skipped.all();
  if (skipped > 0) out += line("", fmt::format("{} points, lines and faces of the file passed over", grouped(skipped)));
  out += line("positive", c.cells.offenders.empty()
                              ? "every cell, everywhere"
                              : fmt::format("all but {}", grouped(c.n_not_positive() + c.n_undecided())));
  out += line("faces", c.faces.nonconforming.empty()
                           ? fmt::format("conforming; {} on the boundary", grouped(c.faces.boundary.size()))
                           : fmt::format("{} do not conform", grouped(c.faces.nonconforming.size())));
  out += line("boundary", boundary_verdict(c));
  out += line("covers", covers_verdict(c));
  out += line("volume", fmt::format("{:.9g}", c.cells_volume));
  const auto closure = c.closure();
  return out + line("closure", closure ? fmt::format("{:.1e}", *closure) : "none: the boundary does not close");
}

/// What is said of a kind of fault: a heading, the first places, what to do.
std::string fault(const std::string& heading, const std::vector<std::string>& places, std::uint64_t n,
                  const std::string& advice) {
  std::string out = fmt::format("  {}\n", heading);
  for (const std::string& p : places) out += fmt::format("    {}\n", p);
  if (n > places.size()) out += fmt::format("    and {} more\n", grouped(n - places.size()));
  return out + fmt::format("    > {}\n", advice);
}

std::string cell_faults(const CertifyReport& report) {
  const MeshCertificate& c = report.certificate;
  const mesh::VolumeMesh& mesh = report.volume.mesh;
  if (c.cells.offenders.empty()) return "";
  std::vector<std::string> places;
  for (const certify::Offender& o : c.cells.offenders) {
    if (places.size() == report.n_offenders) break;
    const std::string_view why = o.has_repeated_node                              ? "has a node twice"
                                 : o.verdict == predicates::Positivity::Undecided ? "undecided"
                                                                                  : "not positive";
    places.push_back(fmt::format("cell {}, {}, at {}: {}", mesh.file_cell[o.cell],
                                 mesh::kCellTypeNames[static_cast<std::size_t>(mesh.type[o.cell])],
                                 place(centre_of_cell(mesh, o.cell)), why));
  }
  std::string heading;
  if (c.n_not_positive() > 0) {
    heading = fmt::format("not positive everywhere: {}", by_type(c.cells.not_positive));
  }
  if (c.n_undecided() > 0) {
    heading += fmt::format("{}undecided: {}", heading.empty() ? "" : "; ", by_type(c.cells.undecided));
  }
  const bool are_all_mirrored = c.n_not_positive() == c.n_cells() && c.cells_volume < 0;
  return fault(heading, places, c.cells.offenders.size(),
               are_all_mirrored
                   ? "all cells are turned inside out: the order of the nodes, or a mirrored axis"
                   : "look at them in the file that -o CELLS.vtu writes; thinner layers or a finer wall there");
}

std::string_view meaning(FaceFault fault) {
  switch (fault) {
    case FaceFault::ManyCells:
      return "more than two cells have it";
    case FaceFault::SameSide:
      return "two cells lie on the same side of it";
    case FaceFault::RepeatedNode:
      return "has a node twice";
    case FaceFault::OtherOrder:
      return "a quad, whose nodes another cell has in another order";
    case FaceFault::QuadOnTriangles:
      return "a quad, of which another cell has a half as a triangle";
  }
  return "";
}

std::string face_faults(const CertifyReport& report) {
  const auto& faces = report.certificate.faces.nonconforming;
  if (faces.empty()) return "";
  std::vector<std::string> places;
  for (const certify::NonconformingFace& f : faces) {
    if (places.size() == report.n_offenders) break;
    places.push_back(fmt::format("of cell {}, at {}: {}", report.volume.mesh.file_cell[f.face.cell()],
                                 place(centre_of_face(report.volume.mesh, f.face)), meaning(f.fault)));
  }
  return fault(fmt::format("faces that do not conform: {}", grouped(faces.size())), places, faces.size(),
               "each face belongs to one cell, or to two on its two sides; -o FACES.vtp writes these");
}

std::string pair_faults(const CertifyReport& report, const std::string& heading, const std::string& advice,
                        const std::vector<std::pair<std::uint32_t, std::uint32_t>>& found) {
  if (found.empty()) return "";
  const mesh::VolumeMesh& mesh = report.volume.mesh;
  std::vector<std::string> places;
  for (const auto& [i, j] : found) {
    if (places.size() == report.n_offenders) break;
    const mesh::FaceName a = report.certificate.faces.boundary[i], b = report.certificate.faces.boundary[j];
    places.push_back(fmt::format("faces of cells {} and {}, at {}", mesh.file_cell[a.cell()], mesh.file_cell[b.cell()],
                                 place(centre_of_face(mesh, a))));
  }
  return fault(fmt::format("{}: {}", heading, grouped(found.size())), places, found.size(), advice);
}

std::string boundary_faults(const CertifyReport& report) {
  const MeshCertificate& c = report.certificate;
  if (!c.intersections) return "";
  const std::string advice =
      c.n_coincident_points > 0
          ? fmt::format(
                "{} points of the boundary lie where another one lies: if these should be one, merge equal "
                "points in the program that wrote the file",
                grouped(c.n_coincident_points))
          : "cells overlap there: bodies too near to each other, or layers that run into each other";
  return pair_faults(report, "pairs of boundary faces that meet", advice, c.intersections->meeting) +
         pair_faults(report, "pairs of boundary faces that cannot be told apart",
                     "quads that are bent far more than they are apart: finer there, or triangles in their place",
                     c.intersections->undecided);
}

std::string cover_faults(const CertifyReport& report) {
  const auto& faces = report.certificate.covered_twice;
  if (!faces || faces->empty()) return "";
  std::vector<std::string> places;
  for (const mesh::FaceName face : *faces) {
    if (places.size() == report.n_offenders) break;
    places.push_back(fmt::format("behind the face of cell {}, at {}", report.volume.mesh.file_cell[face.cell()],
                                 place(centre_of_face(report.volume.mesh, face))));
  }
  return fault("space that is covered twice", places, faces->size(),
               "one part of the mesh lies within another: layers of two bodies in the same gap, a body swallowed");
}

std::string percent(double p) { return fmt::format("{:.1f}", p); }

std::string wall_text(const WallReport& wall) {
  const std::uint64_t n = wall.surface.faces.size();
  std::string out = fmt::format("layers on {}\n", wall.file);
  out += fmt::format("  {} of {} triangles are faces of the mesh ({} bit for bit)\n",
                     grouped(wall.match.n_exact + wall.match.n_near), grouped(n), grouped(wall.match.n_exact));
  if (wall.match.n_exact + wall.match.n_near == 0) {
    out += "  > is that the surface the mesh was made from, with the same triangles and in the same unit?\n";
  }
  Table table({{"patch", false},
               {"layers", true},
               {"all %", true},
               {"any %", true},
               {"mean", true},
               {"first height", true},
               {"p01", true},
               {"p99", true},
               {"thickness", true},
               {"growth", true},
               {"max", true}});
  for (const PatchId p : wall.patches.ids()) {
    const quality::WallPatchLayers& l = wall.patches[p];
    table.add_row({wall.surface.patch_names[p], fmt::format("{}", l.count), percent(l.all_layers_percent),
                   percent(l.any_percent), fmt::format("{:.1f}", l.mean_layers),
                   fmt::format("{:.4g}", l.first_height.median), fmt::format("{:.4g}", l.first_height.p01),
                   fmt::format("{:.4g}", l.first_height.p99), fmt::format("{:.4g}", l.thickness.median),
                   fmt::format("{:.3f}", l.growth.median), fmt::format("{:.3f}", l.growth.max)});
  }
  out += table.to_text("  ");
  if (wall.asked_first_height) out += fmt::format("  first height asked: {:.4g}\n", *wall.asked_first_height);
  return out;
}

}  // namespace

Vec3 centre_of_cell(const mesh::VolumeMesh& mesh, std::uint64_t cell) {
  Vec3 sum;
  const auto nodes = mesh.nodes_of(cell);
  for (const std::uint32_t node : nodes) sum += mesh.points[node] / static_cast<double>(nodes.size());
  return sum;
}

Vec3 centre_of_face(const mesh::VolumeMesh& mesh, mesh::FaceName face) {
  const mesh::FaceNodes nodes = nodes_of(mesh, face);
  const int n = mesh::size_of(nodes);
  Vec3 sum;
  for (int k = 0; k < n; ++k) sum += mesh.points[nodes[static_cast<std::size_t>(k)]] / n;
  return sum;
}

std::string text_of(const CertifyReport& report) {
  const bool is_valid = report.certificate.is_valid();
  std::string out = fmt::format("{}: {}\n", report.file, is_valid ? "valid" : "not valid");
  out += verdicts(report);
  if (!is_valid) {
    out += "faults\n" + cell_faults(report) + face_faults(report) + boundary_faults(report) + cover_faults(report);
  }
  return report.wall ? out + wall_text(*report.wall) : out;
}

}  // namespace nearwall::program
