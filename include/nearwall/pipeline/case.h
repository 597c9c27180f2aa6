#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nearwall/geometry/box.h"
#include "nearwall/layers/grow.h"
#include "nearwall/spacing/schedule.h"
#include "nearwall/spacing/wall_units.h"
#include "nearwall/surface/admission.h"
#include "nearwall/surface/point_normals.h"
#include "nearwall/surface/smoothing.h"

namespace nearwall {

/// What a patch is to the layers.
enum class PatchType { Wall, NoLayer };

using layers::OnConflict;

/// Keys of [layers], which a patch may give, too; what is empty is inherited.
struct LayerSettings {
  std::optional<double> first_height;     ///< [length]
  std::optional<double> y_plus;           ///< instead of first_height, with [flow]
  std::optional<double> growth;           ///< [-]
  std::optional<int> count;               ///< layers
  std::optional<double> total_thickness;  ///< [length]
  std::optional<spacing::Law> law;
  std::vector<double> heights;           ///< [length], law "table"
  std::optional<int> constant_layers;    ///< law "accelerating"
  std::optional<double> acceleration;    ///< law "accelerating"
  std::optional<double> largest_growth;  ///< law "accelerating"
  std::optional<OnConflict> on_conflict;
  std::optional<int> max_level_step;   ///< levels between neighbouring lines that move; 0: "auto"
  std::optional<double> min_coverage;  ///< [percent] of the patch with all layers
  std::string where;                   ///< place of the first key in the case file, for messages

  /// `law`, or what follows without it: a table where heights are given, geometric otherwise.
  spacing::Law law_in_force() const;
};

/// One table [patches.NAME] of the case file.
struct PatchRule {
  std::string pattern;  ///< name of a patch, or with '*' for any run of characters
  std::optional<PatchType> type;
  LayerSettings layers;
  std::string where;  ///< place in the case file, for messages
};

struct SurfaceSettings {
  std::filesystem::path file;  ///< as written; relative to the case file
  double scale = 1;
  surface::FluidSide fluid = surface::FluidSide::Outside;
  std::optional<double> weld;  ///< [length]; nullopt: bitwise equal points only
  surface::Repair repair = surface::Repair::None;
};

struct SmoothingSettings {
  surface::SmoothingFilter filter = surface::SmoothingFilter::Taubin;
  std::optional<int> iterations;  ///< nullopt: follows thickness / edge length
};

struct OutputSettings {
  std::filesystem::path directory = "out";  ///< as written; relative to the case file
  bool report = true;
  bool pictures = true;
};

/// A case as `read_case` gives it: every value checked.
struct Case {
  std::filesystem::path file;  ///< the case file; empty for a case made in code
  std::string name;            ///< of the output files; empty: stem of the surface file
  SurfaceSettings surface;
  std::vector<PatchRule> patches;  ///< in the order of the file; later ones win, exact names over patterns
  double ridge_angle_deg = 40;     ///< turn from which an edge is a ridge [degrees]
  surface::NormalMethod normals = surface::NormalMethod::MostVisible;
  bool is_multi_allowed = true;  ///< normals.multi: several lines at convex ridges and corners that need them
  double multi_angle_deg = 100;  ///< turn of a convex ridge from which it gets several lines [degrees]
  double max_turn_deg = 45;      ///< largest angle between two neighbouring lines of a fan [degrees]
  SmoothingSettings smoothing;
  LayerSettings layers;
  std::optional<spacing::FlowConditions> flow;
  OutputSettings output;

  /// Name of the output files.
  std::string output_name() const;
  /// The surface file and the output directory, resolved against the folder of the case file.
  std::filesystem::path surface_path() const;
  std::filesystem::path output_directory() const;
};

/// Reads a case file.
/// \param overrides  "key=value" each, as of --set; keys dotted, values as in TOML (quotes may be left out)
/// \throws InputError  "FILE:LINE:COLUMN: key: what was found, what is allowed, nearest valid key"; IoError if the file
///                     cannot be read
Case read_case(const std::filesystem::path& file);
Case read_case(const std::filesystem::path& file, std::span<const std::string> overrides);

/// The same from text. \param file  stands in messages, and relative paths are resolved against its folder
Case parse_case(const std::string& text, const std::filesystem::path& file,
                std::span<const std::string> overrides = {});

/// What is in force on one patch: the settings of [layers] and of all rules that match, put together.
struct PatchSettings {
  PatchType type = PatchType::Wall;
  spacing::Schedule schedule;  ///< empty for NoLayer
  OnConflict on_conflict = OnConflict::Auto;
  std::optional<int> max_level_step;  ///< levels between neighbouring lines that move; nullopt: any
  double min_coverage = 0;            ///< [percent]
};

/// \param patch_names  of the surface
/// \returns one entry for each name
/// \throws InputError  if a rule matches no patch (with the nearest name) or a schedule is impossible
std::vector<PatchSettings> resolve_patches(const Case& settings, std::span<const std::string> patch_names);

/// What `nearwall init SURFACE` knows of a surface.
struct SurfaceFacts {
  std::filesystem::path file;
  geometry::Box box;
  double mean_edge = 0;  ///< mean length of an edge [length]
  std::vector<std::string> patch_names;
};

SurfaceFacts surface_facts(const std::filesystem::path& file, const mesh::SurfaceMesh& surface);

/// A commented case file with every key; with heights that suit the surface if one is given.
std::string case_template(const std::optional<SurfaceFacts>& facts);

/// The reference of all keys as Markdown: the tables of docs/case-file.md.
std::string case_reference();

}  // namespace nearwall
