#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

// Holds every #include of the tree against the table of docs/development.md.

namespace nearwall {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = NEARWALL_SOURCE_DIR;

/// Modules and what each may include, as the table says.
std::map<std::string, std::set<std::string>> allowed_includes() {
  std::map<std::string, std::set<std::string>> allowed;
  std::ifstream file(kSource / "docs/development.md");
  const std::regex row(R"(^\| `(\w+)` \|[^|]*\|([^|]*)\|$)"), name(R"(`(\w+)`)");
  for (std::string line; std::getline(file, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    const std::string list = match[2];
    std::set<std::string>& modules = allowed[match[1]];
    modules.insert(match[1]);
    for (std::sregex_iterator it(list.begin(), list.end(), name), end; it != end; ++it) modules.insert((*it)[1]);
  }
  return allowed;
}

struct Include {
  fs::path file;
  std::string module, what;
  bool is_public_header = false;
};

std::vector<Include> includes_below(const fs::path& root, bool is_public) {
  std::vector<Include> includes;
  const std::regex directive(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"].*)re");
  for (const auto& entry : fs::recursive_directory_iterator(kSource / root)) {
    const auto extension = entry.path().extension();
    if (extension != ".h" && extension != ".cpp") continue;
    const fs::path below = fs::relative(entry.path(), kSource / root);
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      std::smatch match;
      if (std::regex_match(line, match, directive)) {
        includes.push_back({entry.path(), below.begin()->string(), match[1], is_public});
      }
    }
  }
  return includes;
}

std::vector<Include> all_includes() {
  auto all = includes_below("include/nearwall", true);
  const auto sources = includes_below("src", false);
  all.insert(all.end(), sources.begin(), sources.end());
  return all;
}

TEST(IncludeDirection, EveryModuleHasARow) {
  const auto allowed = allowed_includes();
  for (const char* root : {"src", "include/nearwall"}) {
    for (const auto& entry : fs::directory_iterator(kSource / root)) {
      if (!entry.is_directory()) continue;
      EXPECT_TRUE(allowed.contains(entry.path().filename())) << entry.path();
    }
  }
}

TEST(IncludeDirection, ModulesSeeOnlyWhatTheirRowNames) {
  const auto allowed = allowed_includes();
  std::size_t n = 0;
  const std::regex of_module(R"(^(?:nearwall/)?(\w+)/[\w/]+\.h$)");
  for (const Include& include : all_includes()) {
    std::smatch match;
    if (!std::regex_match(include.what, match, of_module) || !allowed.contains(match[1])) continue;
    ++n;
    EXPECT_TRUE(allowed.at(include.module).contains(match[1])) << include.file << " includes " << include.what;
  }
  EXPECT_GT(n, 100u) << "the includes were not found at all";
}

TEST(IncludeDirection, EveryPublicHeaderIsInstalled) {
  for (const auto& entry : fs::recursive_directory_iterator(kSource / "include/nearwall")) {
    if (entry.path().extension() != ".h") continue;
    const fs::path list = kSource / "src" / entry.path().parent_path().filename() / "CMakeLists.txt";
    std::ifstream file(list);
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    EXPECT_TRUE(std::regex_search(text, std::regex("\\b" + entry.path().filename().string() + "\\b")))
        << entry.path() << " is not in the HEADERS of " << list;
  }
}

TEST(IncludeDirection, TheTableHasNoCycle) {
  const auto allowed = allowed_includes();
  for (const auto& [module, seen] : allowed) {
    for (const std::string& other : seen) {
      if (other == module) continue;
      EXPECT_FALSE(allowed.at(other).contains(module)) << module << " and " << other;
    }
  }
}

TEST(IncludeDirection, HeavyLibrariesStayBehindFilesOfTheirName) {
  for (const Include& include : all_includes()) {
    const std::string stem = include.file.stem();
    EXPECT_TRUE(!include.what.starts_with("CGAL/") || stem.ends_with("_cgal")) << include.file;
    EXPECT_TRUE(!include.what.starts_with("tetgen") || stem.ends_with("_tetgen")) << include.file;
    EXPECT_TRUE(!include.what.starts_with("vtk") || stem.ends_with("_vtk")) << include.file;
    EXPECT_TRUE(!include.what.starts_with("cgns") || stem.ends_with("_cgns")) << include.file;
    const bool is_hdf5 = include.what.starts_with("hdf5") || include.what.starts_with("H5");
    EXPECT_TRUE(!is_hdf5 || stem.ends_with("_hdf5")) << include.file;
  }
}

TEST(IncludeDirection, PublicHeadersIncludeTheStandardLibraryAndNearwallOnly) {
  for (const Include& include : all_includes()) {
    if (!include.is_public_header) continue;
    const bool is_standard = include.what.find_first_of("/.") == std::string::npos;
    // The compiler's own header for the processor's instructions.
    const bool is_of_compiler = include.what == "emmintrin.h";
    EXPECT_TRUE(is_standard || is_of_compiler || include.what.starts_with("nearwall/"))
        << include.file << " includes " << include.what;
  }
}

}  // namespace
}  // namespace nearwall
