#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/peers/child.h"
#include "tests/peers/layer_figures.h"

namespace nearwall::peers {

/// A body that both programs put layers on.
struct PeerCase {
  std::string name;
  std::string script;                                     ///< for Gmsh, beside this file
  std::vector<std::pair<std::string, double>> constants;  ///< of the script
  int layers = 20;
  double first_height = 1e-4;
};

/// A mesh, what `nearwall certify` says of it, and what it is like.
struct Meshed {
  std::string program;  ///< and its settings
  Run run;
  nlohmann::json certificate;
  LayerFigures figures;

  bool is_valid() const { return certificate.at("valid"); }
  std::uint64_t n_not_positive() const;
  std::uint64_t n_meeting() const;  ///< pairs of boundary faces; 0 also where that could not be told
};

/// One case in a folder of its own: Gmsh's triangulation of the body, Gmsh's layers on it, nearwall's layers on it. The
/// folder is kept if the environment variable NEARWALL_PEERS names one to put it in.
class Comparison {
 public:
  explicit Comparison(const PeerCase& peer_case);
  ~Comparison();
  Comparison(const Comparison&) = delete;
  Comparison& operator=(const Comparison&) = delete;

  /// The time for the triangulation alone is taken off.
  Meshed gmsh();
  /// \param settings  as for `nearwall run --set`; one thread
  Meshed nearwall(const std::string& name, const std::vector<std::string>& settings = {});

  const mesh::SurfaceMesh& wall() const { return wall_; }
  /// Rows of a Markdown table, one for each mesh so far.
  std::string table() const;

 private:
  std::vector<std::string> gmsh_command(int dimension, const std::string& output) const;
  Meshed look_at(const std::string& program, const Run& run, const std::string& file);
  bool is_on_sharp_edge(const Vec3& p) const;

  PeerCase case_;
  std::filesystem::path folder_;
  bool is_kept_;
  double surface_seconds_ = 0;
  mesh::SurfaceMesh wall_;
  std::vector<Meshed> meshes_;
};

/// The first line of what a program prints for --version, on either output; empty if it cannot be run.
std::string version_of(const std::string& program);

}  // namespace nearwall::peers
