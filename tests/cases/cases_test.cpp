#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

// Each case of /cases, from its geometry to its report, against its expected.json: a list of checks
//   { "key": "/patches/upper/all_layers_percent", "min": 99.5 }   or "max", or "equals"
// with the keys of report.json as JSON pointers. A list "certify" holds such checks of what `nearwall certify` says of
// the mesh that was written. A case whose surface comes from a package that is not installed is skipped by name; `make
// test-slow` installs it.

namespace nearwall {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json read_json(const fs::path& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file.is_open()) << path;
  return json::parse(file);
}

std::vector<std::string> case_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(NEARWALL_CASES)) {
    if (fs::exists(entry.path() / "case.toml")) names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

int run(const std::string& command) {
  return std::system(fmt::format("PATH='{}':$PATH; {}", NEARWALL_PROGRAM_FOLDER, command).c_str());
}

void expect_checks(const json& found, const json& checks) {
  EXPECT_FALSE(checks.empty());
  for (const json& check : checks) {
    const std::string key = check.at("key");
    const json& value = found.at(json::json_pointer(key));
    EXPECT_GE(check.size(), 2u) << key << " has no bound";
    if (check.contains("equals")) {
      EXPECT_EQ(value, check["equals"]) << key;
    }
    if (check.contains("min")) {
      EXPECT_GE(value.get<double>(), check["min"].get<double>()) << key;
    }
    if (check.contains("max")) {
      EXPECT_LE(value.get<double>(), check["max"].get<double>()) << key;
    }
  }
}

class Cases : public testing::TestWithParam<std::string> {};

TEST_P(Cases, ComeOutAsExpected) {
  const fs::path source = fs::path(NEARWALL_CASES) / GetParam();
  const fs::path folder = fs::temp_directory_path() / fmt::format("nearwall-case-{}-{}", GetParam(), getpid());
  fs::remove_all(folder);
  fs::create_directories(folder);
  fs::copy(source / "case.toml", folder);
  fs::copy(source / "geometry.sh", folder);
  if (fs::exists(source / "geometry.py")) fs::copy(source / "geometry.py", folder);
  if (run(fmt::format("cd '{}' && sh geometry.sh", folder.string())) != 0) {
    fs::remove_all(folder);
    GTEST_SKIP() << "the surface of this case comes from a package that is not installed";
  }
  ASSERT_EQ(
      run(fmt::format("nearwall run '{}/case.toml' --quiet --set output.pictures=false > /dev/null", folder.string())),
      0);
  const json report = read_json(folder / "out/report.json");
  const json expected = read_json(source / "expected.json");
  expect_checks(report, expected.at("checks"));
  if (expected.contains("certify")) {
    const std::string mesh = (folder / "out" / report.at("name").get<std::string>()).string() + ".vtu";
    const fs::path verdict = folder / "certify.json";
    EXPECT_EQ(run(fmt::format("nearwall certify '{}' --json --quiet > '{}'", mesh, verdict.string())), 0);
    expect_checks(read_json(verdict), expected["certify"]);
  }
  fs::remove_all(folder);
}

std::string test_name(const testing::TestParamInfo<std::string>& parameter) {
  std::string name = parameter.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, Cases, testing::ValuesIn(case_names()), test_name);

}  // namespace
}  // namespace nearwall
