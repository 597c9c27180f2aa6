#include <fstream>

#include "nearwall/io/surface_reader.h"
#include "nearwall/pipeline/run.h"
#include "pipeline/report_json.h"
#include "pipeline/sha256.h"
#include "pipeline/version.h"

namespace nearwall {

namespace {

bool tells_of(const pipeline::Json& report, const Case& settings, const std::filesystem::path& directory) {
  if (!report.is_object() || !report.value("certified", false)) return false;
  if (report.value("version", "") != pipeline::kVersion) return false;
  if (!report.contains("case") || report["case"] != pipeline::case_json(settings)) return false;
  for (const auto& file : report.value("files", std::vector<std::string>())) {
    if (!std::filesystem::exists(directory / file)) return false;
  }
  const pipeline::Json input = report.value("input", pipeline::Json::object());
  return input.value("sha256", "") == pipeline::sha256_of_files(io::surface_files(settings.surface_path()));
}

}  // namespace

bool is_up_to_date(const Case& settings, const RunOptions& options) {
  const std::filesystem::path directory = options.output_directory.value_or(settings.output_directory());
  std::ifstream in(directory / "report.json");
  if (!in) return false;
  try {
    return tells_of(pipeline::Json::parse(in), settings, directory);
  } catch (const pipeline::Json::exception&) {
    return false;  // somebody else's report, or one that was cut short
  }
}

}  // namespace nearwall
