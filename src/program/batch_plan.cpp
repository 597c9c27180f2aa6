#include "program/batch_plan.h"

#include <fnmatch.h>

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/io/surface_reader.h"
#include "program/surface_files.h"

namespace nearwall::program {

namespace fs = std::filesystem;

namespace {

constexpr const char* kDefaultDirectory = "out";

struct Found {
  fs::path file;
  fs::path label;
};

std::vector<Found> find_inputs(const BatchRequest& request) {
  std::vector<Found> found;
  for (const std::string& input : request.inputs) {
    if (!fs::is_directory(input)) {
      found.push_back({input, input});
      continue;
    }
    for (const fs::path& file : files_below(input, request.template_file ? io::is_surface_name : is_case_file)) {
      found.push_back({file, file.lexically_relative(input)});
    }
  }
  return found;
}

bool is_excluded(const fs::path& label, const std::vector<std::string>& patterns) {
  return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
    return fnmatch(pattern.c_str(), label.c_str(), 0) == 0 ||
           fnmatch(pattern.c_str(), label.filename().c_str(), 0) == 0;
  });
}

/// Folder of the results below `directory`: the path of the input, so that no two share one.
fs::path results_folder(const fs::path& directory, const fs::path& label, std::set<fs::path>& taken) {
  fs::path below;
  for (const fs::path& part : label.relative_path().lexically_normal()) {
    if (part != ".." && part != ".") below /= part;
  }
  if (below.filename() == "case.toml" && below.has_parent_path()) below = below.parent_path();
  if (below.extension() == ".toml") below.replace_extension();
  fs::path folder = directory / below;
  for (int n = 2; !taken.insert(folder).second; ++n) folder = directory / fmt::format("{}-{}", below.string(), n);
  return folder;
}

/// A string as TOML writes it.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

}  // namespace

std::vector<BatchItem> plan_batch(const BatchRequest& request) {
  if (request.has_relative_lengths && !request.template_file) {
    throw InputError("--relative belongs to --template: case files of their own give their own lengths");
  }
  std::vector<BatchItem> items;
  std::set<fs::path> taken;
  for (const Found& found : find_inputs(request)) {
    if (is_excluded(found.label, request.excluded)) continue;
    BatchItem item{found.label.string(), {"run", request.template_file.value_or(found.file.string()), "--json"}};
    const auto add = [&](std::initializer_list<std::string> words) {
      item.arguments.insert(item.arguments.end(), words);
    };
    if (request.template_file) {
      add({"--set", "surface.file=" + quoted(fs::absolute(found.file).string())});
      add({"--set", "name=" + quoted(io::surface_stem(found.file))});
    }
    for (const std::string& override : request.overrides) add({"--set", override});
    if (request.directory || request.template_file) {
      add({"-o", results_folder(request.directory.value_or(kDefaultDirectory), found.label, taken).string()});
    }
    if (request.is_resumed) add({"--resume"});
    if (request.is_forced) add({"--force"});
    if (request.has_relative_lengths) add({"--relative"});
    items.push_back(std::move(item));
  }
  if (items.empty()) {
    throw InputError(fmt::format("no {} found: folders are searched for {}", request.template_file ? "surface" : "case",
                                 request.template_file ? "stl, obj, ply, off, vtp and vtk files, also gzipped"
                                                       : "*.toml files with a key 'format'; to mesh surfaces, give a "
                                                         "case file for them with --template"));
  }
  return items;
}

}  // namespace nearwall::program
