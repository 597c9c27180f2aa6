#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nearwall/core/vec3.h"
#include "nearwall/geometry/box.h"
#include "nearwall/io/mesh_formats.h"
#include "nearwall/layers/grow.h"
#include "nearwall/spacing/schedule.h"
#include "nearwall/spacing/wall_units.h"
#include "nearwall/surface/admission.h"
#include "nearwall/surface/point_normals.h"
#include "nearwall/surface/smoothing.h"

namespace nearwall {

/// What a patch is to the layers and to the volume.
enum class PatchType { Wall, NoLayer, Symmetry, Inlet, Outlet, FarField };

/// Only walls have them.
constexpr bool has_layers(PatchType type) { return type == PatchType::Wall; }

/// Whether a patch may be a plane in which the layers of its neighbours stay.
constexpr bool is_side(PatchType type) { return type != PatchType::Wall && type != PatchType::NoLayer; }

/// As in the case file: "wall", "nolayer", …
std::string_view type_name(PatchType type);

using layers::OnConflict;

/// Where the lines of a patch end: at the last layer of the count, or where layers are as high as their triangles are
/// wide.
enum class Until { Count, Isotropic };

/// A length at each point, from an array of the surface file.
struct ArrayLength {
  std::string array;  ///< its name
  double factor = 1;  ///< by which its values are multiplied; they are scaled as the surface is
  friend bool operator==(const ArrayLength&, const ArrayLength&) = default;
};

/// Keys of [layers], which a patch may give, too; what is empty is inherited.
struct LayerSettings {
  std::optional<double> first_height;                ///< [length]
  std::optional<ArrayLength> first_height_array;     ///< instead of first_height
  std::optional<double> y_plus;                      ///< instead of first_height, with [flow]
  std::optional<double> growth;                      ///< [-]
  std::optional<int> count;                          ///< layers
  std::optional<double> total_thickness;             ///< [length]
  std::optional<ArrayLength> total_thickness_array;  ///< instead of total_thickness
  std::optional<Until> until;
  std::optional<spacing::Law> law;
  std::vector<double> heights;           ///< [length], law "table"
  std::optional<int> constant_layers;    ///< law "accelerating"
  std::optional<double> acceleration;    ///< law "accelerating"
  std::optional<double> largest_growth;  ///< law "accelerating"
  std::optional<OnConflict> on_conflict;
  std::optional<int> max_level_step;   ///< levels between neighbouring lines that move; 0: "auto"
  std::optional<double> min_coverage;  ///< [percent] of the patch with all layers
  std::string where;                   ///< place of the first key in the case file, for messages

  bool has_first_height() const { return first_height || first_height_array || y_plus; }
  bool has_total_thickness() const { return total_thickness || total_thickness_array; }
  /// `law`, or what follows without it: a table where heights are given, geometric otherwise.
  spacing::Law law_in_force() const;
  friend bool operator==(const LayerSettings&, const LayerSettings&) = default;
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
  std::optional<int> iterations;  ///< nullopt: 2
};

/// What makes the cells between the layers and the outer boundary.
enum class Fill { None, TetGen };

enum class FarFieldShape {
  Sphere,
  Box,
  Given,  ///< a patch of the surface file
};

/// The outer boundary where the fluid lies outside of the surface. What is empty follows from the surface.
struct FarFieldSettings {
  FarFieldShape shape = FarFieldShape::Sphere;
  std::optional<double> radius;  ///< [length] of the sphere, half the edge of the box; nullopt: 50 diagonals
  std::optional<double> size;    ///< [length] of the edges of its triangles
  std::optional<Vec3> centre;    ///< nullopt: of the surface's box
  std::optional<Vec3> lower;     ///< corner of the box, with upper; instead of radius and centre
  std::optional<Vec3> upper;
  friend bool operator==(const FarFieldSettings&, const FarFieldSettings&) = default;
};

/// A plane across an axis that bounds the domain: the surface lies on one side of it.
struct SymmetrySetting {
  int axis = 0;              ///< of its normal: 0 x, 1 y, 2 z
  std::optional<double> at;  ///< its coordinate [length]; nullopt: where the open edges of the surface lie, else 0
  friend bool operator==(const SymmetrySetting&, const SymmetrySetting&) = default;
};

struct VolumeSettings {
  Fill fill = Fill::None;
  double growth = 1.3;  ///< of the edges of tetrahedra from one to the next away from the layers, in ]1, 3]
  FarFieldSettings far_field;
  std::vector<SymmetrySetting> symmetry;
  friend bool operator==(const VolumeSettings&, const VolumeSettings&) = default;
};

struct OutputSettings {
  std::filesystem::path directory = "out";  ///< as written; relative to the case file
  std::vector<io::MeshFormat> formats = {io::MeshFormat::Vtu};
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
  VolumeSettings volume;
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
  /// Empty for all but walls. Where vertices have lengths of their own, the stack that theirs are made from; where
  /// lines end when they are isotropic, of as many layers as the widest triangles need.
  spacing::Schedule schedule;
  std::optional<layers::VertexLength> first_height;     ///< of each vertex
  std::optional<layers::VertexLength> total_thickness;  ///< of each vertex
  bool is_until_isotropic = false;
  double largest_thickness = 0;  ///< that any vertex is asked for [length]
  OnConflict on_conflict = OnConflict::Auto;
  std::optional<int> max_level_step;  ///< levels between neighbouring lines that move; nullopt: any
  double min_coverage = 0;            ///< [percent]
  /// What is asked for and cannot be had whatever the room, for the patch and those alike: said of the first one.
  std::vector<std::string> warnings;
};

/// Names of the point arrays that a case takes lengths from, each once: those that its surface is read with.
std::vector<std::string> point_arrays(const Case& settings);

/// Looks at the lengths that patches of layers take from point arrays.
/// \param surface  as read from the file, with `point_arrays` of the case
/// \throws InputError  if one of them is not a finite number above 0 at a point of such a patch: which, where
void check_point_arrays(const Case& settings, const mesh::SurfaceMesh& surface);

/// \param surface  in the case's unit, as are the values of its point arrays; with those of the case, in their order
/// \returns one entry for each patch
/// \throws InputError  if a rule matches no patch (with the nearest name) or a schedule is impossible
std::vector<PatchSettings> resolve_patches(const Case& settings, const mesh::SurfaceMesh& surface,
                                           const mesh::Topology& topology);

/// The same from the names of the patches alone. \throws InputError  also where heights depend on the surface
std::vector<PatchSettings> resolve_patches(const Case& settings, std::span<const std::string> patch_names);

/// Types of patches of these names. \throws InputError  if a rule matches no patch (with the nearest name)
std::vector<PatchType> patch_types(const Case& settings, std::span<const std::string> patch_names);

/// What `nearwall init SURFACE` knows of a surface.
struct SurfaceFacts {
  std::filesystem::path file;
  geometry::Box box;
  double mean_edge = 0;  ///< mean length of an edge [length]
  std::vector<std::string> patch_names;
  std::vector<std::string> point_arrays;  ///< from which lengths may be taken
};

SurfaceFacts surface_facts(const std::filesystem::path& file, const mesh::SurfaceMesh& surface);

/// A commented case file with every key; with heights that suit the surface if one is given.
std::string case_template(const std::optional<SurfaceFacts>& facts);

/// The reference of all keys as Markdown: the tables of docs/case-file.md.
std::string case_reference();

}  // namespace nearwall
