#include "io/msh_input.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "nearwall/core/errors.h"
#include "nearwall/io/whole_mesh.h"

namespace nearwall::io {
namespace {

[[noreturn]] void fail_version(const std::string& file, std::string_view version) {
  throw InputError(
      fmt::format("{}: version {} of Gmsh's format, expected 2.2 or 4.1: save it again with "
                  "gmsh OLD.msh -save -format msh41 -o NEW.msh",
                  file, version));
}

}  // namespace

MshInput::MshInput(std::string_view bytes, const std::string& file) : cursor_(bytes, file) {
  const std::string_view first = cursor_.word();
  if (first == "$NOD") fail_version(file, "1");
  if (first != "$MeshFormat") cursor_.fail_expected("$MeshFormat", first);
  read_format();
}

void MshInput::read_format() {
  const std::string_view version = cursor_.word();
  const double value = cursor_.to_number(version, "the version of the format");
  constexpr double kVersion41 = 4.1;
  is_version_4_ = value == kVersion41;
  if (!is_version_4_ && std::floor(value) != 2) fail_version(cursor_.file(), quoted(version));
  const std::int64_t type = cursor_.integer("the file type, 0 (text) or 1 (binary)");
  if (type != 0 && type != 1) cursor_.fail(fmt::format("expected a file type of 0 or 1, found {}", type));
  const std::int64_t size = cursor_.integer("the size of numbers");
  if (size != 8) cursor_.fail(fmt::format("expected numbers of 8 bytes, found {}", size));
  is_binary_ = type == 1;
  if (is_binary_) {
    cursor_.pass_line_end();
    cursor_.enter_binary();
    const std::string_view one = cursor_.bytes(4, "the number 1 that tells the byte order");
    const auto is_one = [&](std::endian order) { return Cursor::decode<std::int32_t>(one.data(), order) == 1; };
    if (!is_one(std::endian::little) && !is_one(std::endian::big)) {
      cursor_.fail("expected the number 1 in 4 bytes behind the line of the version");
    }
    order_ = is_one(std::endian::little) ? std::endian::little : std::endian::big;
  }
  end_section("MeshFormat");
}

std::string_view MshInput::next_section() {
  const std::string_view word = cursor_.word();
  if (word.empty()) return {};
  if (!word.starts_with('$')) cursor_.fail_expected("a section such as $Nodes", word);
  cursor_.pass_line_end();
  return word.substr(1);
}

void MshInput::end_section(std::string_view name) {
  const std::string expected = fmt::format("$End{}", name);
  const std::string_view word = cursor_.word();
  if (word != expected) cursor_.fail_expected(expected, word);
}

void MshInput::pass_section(std::string_view name) {
  const std::string end = fmt::format("$End{}", name);
  if (is_binary_) {
    const std::size_t at = cursor_.all().find(end, cursor_.offset());
    if (at == std::string_view::npos) cursor_.fail(fmt::format("expected {}, found the end of the file", end));
    cursor_.seek(at + end.size());
    return;
  }
  while (cursor_.word_of_line() != end) {
    if (!cursor_.next_line()) cursor_.fail(fmt::format("expected {}, found the end of the file", end));
  }
}

std::int64_t MshInput::tag(std::string_view what) {
  if (is_binary_) return cursor_.value<std::int32_t>(order_, what);
  const std::int64_t value = cursor_.integer(what);
  using Limits = std::numeric_limits<std::int32_t>;
  if (value < Limits::min() || value > Limits::max()) {
    cursor_.fail(fmt::format("expected {} of at most 32 bits, found {}", what, value));
  }
  return value;
}

std::int64_t MshInput::number(std::string_view what) {
  const std::int64_t value = is_binary_ ? cursor_.value<std::int64_t>(order_, what) : cursor_.integer(what);
  if (value < 0) cursor_.fail(fmt::format("expected {}, found {}", what, value));
  return value;
}

double MshInput::real(std::string_view what) {
  return is_binary_ ? cursor_.value<double>(order_, what) : cursor_.number(what);
}

Vec3 MshInput::point() {
  Vec3 p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = real("a coordinate");
  return p;
}

std::size_t MshInput::count(std::string_view what, std::size_t bytes_in_text, std::size_t bytes_in_binary) {
  return cursor_.checked_count(number(what), what, is_binary_ ? bytes_in_binary : bytes_in_text);
}

void MshContent::read_names(MshInput& in) {
  Cursor& cursor = in.cursor();
  const std::size_t n = cursor.count("the number of physical names", 6);
  for (std::size_t i = 0; i < n; ++i) {
    const std::int64_t dimension = cursor.integer("the dimension of a physical group");
    if (dimension < 0 || dimension > 3) cursor.fail(fmt::format("expected a dimension of 0 to 3, found {}", dimension));
    const std::int64_t number = cursor.integer("the number of a physical group");
    std::string_view name = trimmed(cursor.rest_of_line());
    if (name.size() < 2 || !name.starts_with('"') || !name.ends_with('"')) {
      cursor.fail_expected("a physical name in double quotes", name);
    }
    name = name.substr(1, name.size() - 2);
    if (!name.empty()) names_[{static_cast<int>(dimension), number}] = name;
  }
  in.end_section("PhysicalNames");
}

void MshContent::end_nodes(const FilePosition& where) {
  if (const auto twice = tags_.prepare()) fail_at(where, fmt::format("two nodes have the number {}", *twice));
  has_nodes_ = true;
}

MshGroup MshContent::group(int dimension, std::int64_t physical, std::int64_t entity) {
  if (dimension < 2) return {};
  const auto named = names_.find({dimension, physical});
  if (dimension == 3) return {{}, named != names_.end() && named->second == kLayersGroup ? 1 : 0};
  if (named != names_.end()) return {builder_.patch(named->second)};
  return {builder_.patch(physical != 0 ? fmt::format("patch{}", physical) : fmt::format("surface{}", entity))};
}

MshElement MshContent::element(std::int64_t code) const {
  if (const auto known = msh_element(code)) return *known;
  throw InputError(
      fmt::format("{}: cell {} is of Gmsh's type {}: of higher order, or none that meshes of flows have; "
                  "save it with linear cells (Gmsh: SetOrder 1)",
                  file_, n_elements_, code));
}

void MshContent::add_element(const MshElement& element, const MshGroup& group, std::span<const std::int64_t> nodes,
                             const FilePosition& where) {
  std::array<std::int64_t, 8> points{};
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    points[k] = tags_.find(nodes[k]);
    if (points[k] < 0) {
      fail_at(where, fmt::format("cell {} uses node {}, which the file does not have", n_elements_, nodes[k]));
    }
  }
  const std::span<const std::int64_t> used(points.data(), nodes.size());
  if (element.dimension == 0) ++builder_.skipped().points;
  if (element.dimension == 1) ++builder_.skipped().lines;
  if (element.dimension == 2) builder_.add_face(group.patch, used, where);
  if (element.dimension == 3) builder_.add_cell(element.cell, used, n_elements_, group.layer, where);
  ++n_elements_;
}

}  // namespace nearwall::io
