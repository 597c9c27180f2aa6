#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "nearwall/certify/certificate.h"
#include "nearwall/mesh/cell.h"
#include "nearwall/pipeline/case.h"
#include "nearwall/pipeline/forecast.h"
#include "nearwall/quality/coverage.h"
#include "nearwall/quality/layer_quality.h"
#include "nearwall/quality/limited_lines.h"
#include "nearwall/volume/domain_boundary.h"
#include "nearwall/volume/fill_quality.h"

namespace nearwall {

struct StageTime {
  std::string name;
  double seconds = 0;
};

struct PatchReport {
  std::string name;
  PatchType type = PatchType::Wall;
  double min_coverage = 0;  ///< [percent]
  quality::PatchCoverage coverage;
  std::array<std::uint64_t, mesh::kNLimitReasons> limited_lines{};  ///< by LimitReason
  bool is_below_min_coverage() const { return type == PatchType::Wall && coverage.all_layers_percent < min_coverage; }
};

/// The surface as meshed.
struct SurfaceReport {
  std::uint64_t points = 0;
  std::uint64_t triangles = 0;
  std::uint64_t components = 0;
  std::uint64_t unwetted_components = 0;  ///< cavities that the fluid cannot reach
  std::uint64_t merged_points = 0;        ///< by welding
  std::uint64_t convex_ridges = 0;        ///< edges
  std::uint64_t concave_ridges = 0;
  std::uint64_t corners = 0;
  std::uint64_t ridge_ends = 0;
  std::uint64_t tips = 0;
  std::uint64_t blind = 0;  ///< vertices that no direction sees all faces of
  std::vector<std::string> repairs;
};

/// A picture that was made: PNG bytes are read from the file for the page.
struct Picture {
  std::string file;  ///< name in the output directory
  std::string title;
};

/// What lies on the domain's boundary under one name.
struct BoundaryPatch {
  std::uint64_t triangles = 0;
  std::uint64_t quads = 0;
  double area = 0;  ///< [length²]
};

/// The whole volume, where it was asked for.
struct VolumeReport {
  std::uint64_t tetrahedra = 0;  ///< of the fill
  volume::DomainCertificate certificate;
  volume::FillQuality quality;
  std::vector<BoundaryPatch> boundary;  ///< (n_patches)
};

/// What a run did: everything of report.json.
struct Report {
  std::string name;
  std::string version;
  bool dry_run = false;  ///< only surface, forecast, input, case and patches' requests are filled in
  bool certified = false;
  std::array<std::uint64_t, mesh::kNCellTypes> cells{};  ///< by type
  std::uint64_t points = 0;
  SurfaceReport surface;
  Forecast forecast;
  std::vector<PatchReport> patches;
  quality::LayerQuality quality;
  quality::LimitedLines limited;
  certify::Certificate certificate;
  std::optional<VolumeReport> volume;
  std::string volume_failure;  ///< why the volume that was asked for is missing; empty if it is not
  int rounds = 0;              ///< of certify and shrink
  int smoothing_iterations = 0;
  std::vector<StageTime> stages;
  std::uint64_t peak_memory_bytes = 0;
  std::string input_file;
  std::string input_sha256;
  Case settings;
  std::filesystem::path output_directory;
  std::vector<std::string> files;  ///< names in the output directory
  std::vector<Picture> pictures;
  std::vector<std::string> notes;  ///< what a user wants to know
  std::vector<std::string> warnings;

  std::uint64_t n_cells() const;
  double seconds() const;  ///< of all stages
  /// A part that was asked for is missing: coverage under min_coverage (exit code 4).
  bool is_short_of_coverage() const;
};

/// "curvature 3.1, gap 0.4": what keeps triangles from being full, with its share of the area [percent], the largest
/// first. \param most  reasons named; "…" stands for the others
std::string reasons_in_words(const quality::PatchCoverage& coverage, std::size_t most);

/// 99.96 as "99.9": what is not all must not read as all.
std::string percent_in_words(double percent);

/// report.json. Keys in a fixed order, numbers in the shortest form that reads back to the same double.
std::string to_json(const Report& report);

/// report.html: one page that needs nothing else. \param picture_folder  where the pictures are read from
std::string to_html(const Report& report, const std::filesystem::path& picture_folder);

}  // namespace nearwall
