#pragma once

#include <filesystem>
#include <optional>

#include "nearwall/core/progress.h"
#include "nearwall/pipeline/case.h"
#include "nearwall/pipeline/report.h"

namespace nearwall {

struct RunOptions {
  std::optional<std::filesystem::path> output_directory;  ///< instead of the case's; relative to the working directory
  bool dry_run = false;  ///< checks everything and forecasts, without meshing; nothing is written
  bool force = false;    ///< write into a directory that holds other things, too
};

/// Meshes a case: reads, welds, admits and classifies the surface, grows layers, certifies them, and writes the files
/// of docs/report.md, each of which appears under its name only when it is complete and certified. \throws InputError,
/// GeometryError (SurfaceRejected, after NAME-faults.vtp is written), IoError, Interrupted (from the
///         sink); InternalError if the mesh cannot be certified: then nothing is written
Report run(const Case& settings, ProgressSink* progress = nullptr);
Report run(const Case& settings, const RunOptions& options, ProgressSink* progress = nullptr);

/// Whether the output directory holds a complete result of the same case, input (by its SHA-256) and version.
bool is_up_to_date(const Case& settings, const RunOptions& options);

}  // namespace nearwall
