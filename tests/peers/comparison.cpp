#include "tests/peers/comparison.h"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

#include "nearwall/geometry/angles.h"
#include "nearwall/io/surface_reader.h"
#include "nearwall/io/volume_reader.h"
#include "nearwall/io/vtu_writer.h"
#include "nearwall/mesh/volume_source.h"
#include "nearwall/quality/metrics.h"

namespace nearwall::peers {

namespace fs = std::filesystem;

namespace {

constexpr double kGrowth = 1.2;

std::string folder_name(const PeerCase& peer_case) {
  std::string name = peer_case.script;
  for (const auto& [constant, value] : peer_case.constants) name += fmt::format("-{}-{}", constant, value);
  return name;
}

fs::path new_folder(const std::string& name, bool is_kept) {
  const fs::path folder = is_kept ? fs::path(std::getenv("NEARWALL_PEERS")) / name
                                  : fs::temp_directory_path() / fmt::format("nearwall-peers-{}-{}", name, getpid());
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

void expect_done(const Run& run, const std::string& what) {
  if (run.exit_code != 0) throw std::runtime_error(fmt::format("{}: exit code {}", what, run.exit_code));
}

/// Another program's mesh as a file that `nearwall picture` reads.
void write_for_pictures(const fs::path& file, const mesh::VolumeMesh& mesh) {
  const mesh::VolumeSource source(mesh);
  const io::CellArray jacobian{"ScaledJacobian", [](const mesh::CellBatch& cells, std::span<double> values) {
                                 for (std::size_t i = 0; i < cells.size(); ++i) {
                                   values[i] = quality::scaled_jacobian(cells.type[i], cells.corners[i]);
                                 }
                               }};
  io::write_vtu(file, source, std::span(&jacobian, 1), {});
}

}  // namespace

std::uint64_t Meshed::n_not_positive() const {
  std::uint64_t n = 0;
  for (const auto& count : certificate.at("not_positive")) n += count.get<std::uint64_t>();
  return n;
}

std::uint64_t Meshed::n_meeting() const {
  const auto& n = certificate.at("intersections");
  return n.is_null() ? 0 : n.get<std::uint64_t>();
}

Comparison::Comparison(const PeerCase& peer_case)
    : case_(peer_case),
      folder_(new_folder(folder_name(peer_case), std::getenv("NEARWALL_PEERS") != nullptr)),
      is_kept_(std::getenv("NEARWALL_PEERS") != nullptr) {
  const Run run = run_program(folder_, gmsh_command(2, "wall.stl"), "gmsh-wall.txt");
  expect_done(run, "gmsh, surface");
  surface_seconds_ = run.seconds;
  wall_ = io::read_surface(folder_ / "wall.stl");
}

Comparison::~Comparison() {
  std::error_code ignored;
  if (!is_kept_) fs::remove_all(folder_, ignored);
}

std::vector<std::string> Comparison::gmsh_command(int dimension, const std::string& output) const {
  std::vector<std::string> words = {"gmsh", fmt::format("-{}", dimension),
                                    fmt::format("{}/{}.geo", NEARWALL_PEERS_SCRIPTS, case_.script), "-nt", "1"};
  for (const auto& [name, value] : case_.constants) {
    words.insert(words.end(), {"-setnumber", name, fmt::format("{}", value)});
  }
  if (dimension == 3) {
    words.insert(words.end(), {"-setnumber", "layers", fmt::format("{}", case_.layers)});
    words.insert(words.end(), {"-setnumber", "first_height", fmt::format("{}", case_.first_height)});
    words.insert(words.end(), {"-setnumber", "growth", fmt::format("{}", kGrowth), "-format", "vtk", "-bin"});
  } else {
    words.insert(words.end(), {"-format", "stl"});
  }
  words.insert(words.end(), {"-o", output});
  return words;
}

Meshed Comparison::gmsh() {
  Run run = run_program(folder_, gmsh_command(3, "gmsh.vtk"), "gmsh.txt");
  expect_done(run, "gmsh, layers");
  run.seconds -= surface_seconds_;
  return look_at("Gmsh", run, "gmsh.vtk");
}

Meshed Comparison::nearwall(const std::string& name, const std::vector<std::string>& settings) {
  std::ofstream(folder_ / (name + ".toml")) << fmt::format(
      "name = \"{}\"\n[surface]\nfile = \"wall.stl\"\n[layers]\nfirst_height = {}\ngrowth = {}\ncount = {}\n"
      "[output]\ndirectory = \"{}\"\npictures = false\n",
      name, case_.first_height, kGrowth, case_.layers, name);
  std::vector<std::string> words = {NEARWALL_PROGRAM, "run", name + ".toml", "--quiet", "--threads", "1"};
  std::string program = "nearwall";
  for (const std::string& setting : settings) {
    words.insert(words.end(), {"--set", setting});
    program += fmt::format(", `{}`", setting);
  }
  const Run run = run_program(folder_, words, name + ".txt");
  expect_done(run, program);
  return look_at(program, run, fmt::format("{}/{}.vtu", name, name));
}

Meshed Comparison::look_at(const std::string& program, const Run& run, const std::string& file) {
  run_program(folder_, {NEARWALL_PROGRAM, "certify", file, "--wall", "wall.stl", "--json"}, "certificate.json");
  std::ifstream certificate(folder_ / "certificate.json");
  const mesh::VolumeMesh mesh = io::read_volume_mesh(folder_ / file).mesh;
  if (is_kept_ && file.ends_with(".vtk")) write_for_pictures((folder_ / file).replace_extension("vtu"), mesh);
  meshes_.push_back(
      {program, run, nlohmann::json::parse(certificate),
       layer_figures(mesh, wall_, case_.first_height, [&](const Vec3& p) { return is_on_sharp_edge(p); })});
  return meshes_.back();
}

/// Of the wedge, without its two ends, at which a fan may come down to one line.
bool Comparison::is_on_sharp_edge(const Vec3& p) const {
  return case_.script == "wedge" && p.x() == 1 && std::abs(p.y()) < 1;
}

std::string Comparison::table() const {
  std::string rows;
  for (const Meshed& m : meshes_) {
    const LayerFigures& f = m.figures;
    const Run& own = meshes_.front().run;
    const bool has_edge = case_.script == "wedge";
    rows += fmt::format(
        "| {} | {} | {} | {} | {} | {:.3f} | {:.2g} | {:.2f} | {} | {} | {:.0f} | {:.2f} | {:.2f} |\n", case_.name,
        m.program, f.n_cells, m.is_valid() ? "valid" : "**not valid**", m.n_not_positive(), f.smallest_wall_jacobian,
        f.smallest_jacobian, f.first_height_percent, has_edge ? fmt::format("{}", f.fewest_lines) : "",
        has_edge && f.largest_turn > 0 ? fmt::format("{:.0f}", geometry::to_degrees(f.largest_turn)) : "",
        geometry::to_degrees(f.largest_lean), m.run.seconds / own.seconds,
        double(m.run.peak_bytes) / double(own.peak_bytes));
  }
  return rows;
}

std::string version_of(const std::string& program) {
  const fs::path folder = new_folder("version", false);
  const Run run = run_program(folder, {program, "--version"}, "version");
  std::string line;
  for (const char* name : {"version", "version.err"}) {
    std::ifstream file(folder / name);
    if (run.exit_code == 0 && line.empty()) std::getline(file, line);
  }
  fs::remove_all(folder);
  return line;
}

}  // namespace nearwall::peers
