#include <algorithm>
#include <cstdio>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/io/pending_file.h"
#include "nearwall/io/surface_reader.h"
#include "sweep_measure.h"
#include "sweep_tables.h"

// Grows layers on many surfaces and prints what share of each wall has what, the means, medians and worst: the figures
// by which thresholds and defaults of the growth are chosen (docs/theory/fans.md, docs/theory/layers.md), and the
// tables of docs/coverage.md (docs/coverage.sh). No meshes are written.
//   nearwall_coverage_sweep --schedule S --set 'layers.on_conflict="stair"' FILE|DIR...
//   nearwall_coverage_sweep --schedule S --schedule R --ablation FILE|DIR...

namespace nearwall::sweep {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::vector<std::string> inputs;
  std::vector<std::string> excluded;
  std::vector<std::string> overrides;
  std::vector<std::string> schedules = {"S"};
  bool has_ablation = false;
  std::size_t every = 1;
  std::size_t n_worst = 10;
  int n_threads = 0;
  std::string root, summary_file, surfaces_file, ablation_file, worst_file;
};

/// What the growth does for coverage, one means at a time switched off. The first entry is the default.
struct Lever {
  const char* name;
  Change change;
};

void set_on_conflict(layers::GrowOptions& options, OnConflict on_conflict) {
  for (layers::PatchSchedule& schedule : options.schedules) schedule.on_conflict = on_conflict;
}

std::vector<Lever> levers() {
  using layers::GrowOptions;
  return {
      {"nothing: as by default", {}},
      {"several lines at a vertex", [](GrowOptions& o) { o.several_lines = false; }},
      {"fans where a trial keeps more", [](GrowOptions& o) { o.try_fans = false; }},
      {"lines that lean away", [](GrowOptions& o) { o.lean_lines = false; }},
      {"search for better directions", [](GrowOptions& o) { o.search_lines = false; }},
      {"the three together", [](GrowOptions& o) { o.try_fans = o.lean_lines = o.search_lines = false; }},
      {"smoothing", [](GrowOptions& o) { o.filter = surface::SmoothingFilter::None; }},
      {"Taubin's counter-step", [](GrowOptions& o) { o.filter = surface::SmoothingFilter::Laplacian; }},
      {"most visible normals: means by angle", [](GrowOptions& o) { o.normals = surface::NormalMethod::Angle; }},
      {"thinning without end: to a hundredth", [](GrowOptions& o) { set_on_conflict(o, OnConflict::Compress); }},
      {"thinning: stairs", [](GrowOptions& o) { set_on_conflict(o, OnConflict::Stair); }},
  };
}

bool is_excluded(const fs::path& path, const Arguments& arguments) {
  return std::any_of(arguments.excluded.begin(), arguments.excluded.end(),
                     [&](const std::string& part) { return path.string().find(part) != std::string::npos; });
}

/// The files given and those below the folders given, in order of their paths, every so many of them.
std::vector<Sample> find_samples(const Arguments& arguments) {
  std::vector<fs::path> files;
  for (const std::string& input : arguments.inputs) {
    if (!fs::is_directory(input)) {
      files.emplace_back(input);
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(input)) {
      if (entry.is_regular_file() && io::is_surface_name(entry.path())) files.push_back(entry.path());
    }
  }
  std::erase_if(files, [&](const fs::path& file) { return is_excluded(file, arguments); });
  std::sort(files.begin(), files.end());
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < files.size(); i += arguments.every) {
    const fs::path name = arguments.root.empty() ? files[i].filename() : files[i].lexically_relative(arguments.root);
    samples.push_back({files[i], name.string(), {}, 0});
  }
  return samples;
}

std::vector<Standard> standards_of(const Arguments& arguments) {
  std::vector<Standard> standards;
  for (const std::string& name : arguments.schedules) standards.push_back(name == "S" ? Standard::S : Standard::R);
  return standards;
}

/// Grows on every surface under every schedule with every lever, and says so as it goes.
std::vector<Variant> grow_all(const Arguments& arguments, std::vector<Sample>& samples,
                              const std::vector<Lever>& chosen) {
  const std::vector<Standard> standards = standards_of(arguments);
  std::vector<Variant> variants;
  for (const Lever& lever : chosen) variants.push_back({lever.name, std::vector<Rows>(standards.size())});
  for (std::size_t i = 0; i < samples.size(); ++i) {
    Sample& sample = samples[i];
    fmt::print(stderr, "[{}/{}] {}\n", i + 1, samples.size(), sample.name);
    try {
      const Body body(sample.file, arguments.overrides);
      sample.n_triangles = body.n_triangles();
      for (std::size_t v = 0; v < chosen.size(); ++v) {
        for (std::size_t s = 0; s < standards.size(); ++s) {
          variants[v].rows[s].push_back(body.grow(standards[s], chosen[v].change));
        }
      }
    } catch (const Error& e) {
      sample.refusal = short_refusal(e.what(), sample.file);
      // All variants keep rows for the same surfaces.
      const std::size_t n = variants.back().rows.back().size();
      for (Variant& variant : variants) {
        for (Rows& rows : variant.rows) rows.resize(n);
      }
    }
  }
  return variants;
}

void print_text(const std::vector<Sample>& samples, const std::vector<Standard>& standards,
                const std::vector<Rows>& rows) {
  std::vector<std::string> names;
  for (const Sample& sample : samples) {
    if (sample.refusal.empty()) {
      names.push_back(sample.name);
    } else {
      fmt::print("{:<44} {}\n", sample.name, sample.refusal);
    }
  }
  for (std::size_t s = 0; s < standards.size(); ++s) {
    fmt::print("\nschedule {}\n{}", kStandardNames[static_cast<std::size_t>(standards[s])], text_table(names, rows[s]));
  }
}

int run(const Arguments& arguments) {
  const ThreadLimit limit(arguments.n_threads);
  std::vector<Sample> samples = find_samples(arguments);
  std::vector<Lever> chosen = levers();
  if (!arguments.has_ablation) chosen.resize(1);
  const std::vector<Variant> variants = grow_all(arguments, samples, chosen);
  const std::vector<Standard> standards = standards_of(arguments);
  const std::vector<Rows>& rows = variants.front().rows;
  if (rows.front().empty()) return 1;

  print_text(samples, standards, rows);
  const std::string ablation = ablation_markdown(standards, variants);
  if (arguments.has_ablation) fmt::print("\n{}", ablation);
  const auto write = [](const std::string& file, const std::string& text) {
    if (!file.empty()) io::write_text(file, text);
  };
  write(arguments.summary_file, summary_markdown(standards, rows));
  write(arguments.surfaces_file, surfaces_markdown(samples, standards, rows));
  write(arguments.ablation_file, ablation);
  write(arguments.worst_file, worst_table(samples, rows.front(), arguments.n_worst));
  return 0;
}

}  // namespace
}  // namespace nearwall::sweep

int main(int argc, char** argv) {
  nearwall::sweep::Arguments arguments;
  CLI::App app("coverage of many surfaces under standard schedules");
  app.add_option("FILE|DIR", arguments.inputs, "surfaces, and folders to search for them")->required();
  app.add_option("--schedule", arguments.schedules,
                 "S: 20 layers, 1 % of the diagonal; R: 30 from a millionth of it on; may be repeated")
      ->check(CLI::IsMember({"S", "R"}))
      ->allow_extra_args(false)
      ->take_all();
  app.add_option("--set", arguments.overrides, "key=value of a case file; may be repeated")->allow_extra_args(false);
  app.add_option("--exclude", arguments.excluded, "leave out paths that hold this; may be repeated")
      ->allow_extra_args(false);
  app.add_option("--root", arguments.root, "names are relative to this folder");
  app.add_option("--every", arguments.every, "take every so many of the surfaces")->check(CLI::PositiveNumber);
  app.add_option("--threads", arguments.n_threads, "threads to use; 0: all");
  app.add_flag("--ablation", arguments.has_ablation, "again with each of the means switched off");
  app.add_option("--summary", arguments.summary_file, "write what is asked of all surfaces and what there is");
  app.add_option("--markdown", arguments.surfaces_file, "write the table of all surfaces");
  app.add_option("--ablation-markdown", arguments.ablation_file, "write the table of the ablation");
  app.add_option("--worst", arguments.worst_file,
                 "write those with least at full thickness under the first schedule, separated by tabs");
  app.add_option("--n-worst", arguments.n_worst, "as many of them");
  CLI11_PARSE(app, argc, argv);
  return nearwall::sweep::run(arguments);
}
