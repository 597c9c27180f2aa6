#include <fmt/format.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "io/surface_builder.h"
#include "io/surface_formats.h"

namespace nearwall::io {
namespace {

/// The statements that name parts of a surface, the preferred one first.
enum Naming { Group, Object, Material };
constexpr std::array<Naming, 3> kNamings = {Group, Object, Material};

constexpr std::string_view kUngrouped = "default";  // the format's own name for faces before the first group

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const std::string& file) : in_(bytes, file, '#') {}

  mesh::SurfaceMesh parse() {
    for (std::string_view keyword = word_of_statement(); !keyword.empty() || in_.left() > 0;
         keyword = word_of_statement()) {
      read_statement(keyword);
      while (!word_of_statement().empty()) {
      }
      in_.pass_line_end();
    }
    name_patches();
    return surface_.finish(in_.position());
  }

 private:
  /// Next word of the statement: of this line, and of the next one after a backslash.
  std::string_view word_of_statement() {
    for (;;) {
      const std::string_view word = in_.word_of_line();
      if (word != "\\") return word;
      in_.pass_line_end();
    }
  }

  void read_statement(std::string_view keyword) {
    if (keyword == "v") return read_point();
    if (keyword == "f" || keyword == "fo") return read_face();
    if (keyword == "g") return begin(Group);
    if (keyword == "o") return begin(Object);
    if (keyword == "usemtl") return begin(Material);
    // Everything else (vt, vn, s, l, p, mtllib, curves ...) says nothing about the triangles.
  }

  void read_point() {
    const double x = in_.to_number(word_of_statement(), "x");
    const double y = in_.to_number(word_of_statement(), "y");
    const double z = in_.to_number(word_of_statement(), "z");
    surface_.add_point({x, y, z}, in_.position());
  }

  void read_face() {
    corners_.clear();
    for (std::string_view word = word_of_statement(); !word.empty(); word = word_of_statement()) {
      const bool continued = word.ends_with('\\');
      if (continued) word.remove_suffix(1);
      corners_.push_back(point_index(word));
      if (continued) in_.pass_line_end();
    }
    surface_.add_face(corners_, in_.position());
    for (const Naming naming : kNamings) {
      part_of_face_[naming].resize(surface_.n_faces(), part_[naming]);
    }
  }

  /// "7", "7/1", "7//3" or "-1/…": the point's index from 0.
  std::int64_t point_index(std::string_view word) const {
    const std::int64_t index = in_.to_integer(word.substr(0, word.find('/')), "a point of the face");
    const auto n = static_cast<std::int64_t>(surface_.n_points());
    if (index == 0 || index > n || index < -n) {
      in_.fail(fmt::format("a face uses point {}, expected 1 to {} or -1 to -{} (the points before this line)", index,
                           n, n));
    }
    return index > 0 ? index - 1 : n + index;
  }

  void begin(Naming naming) {
    std::string name;
    for (std::string_view word = word_of_statement(); !word.empty(); word = word_of_statement()) {
      if (!name.empty()) name += ' ';
      name += word;
    }
    part_[naming] = number_of(naming, name.empty() ? kUngrouped : std::string_view(name));
  }

  /// The number of a part, a new one for a new name.
  std::int64_t number_of(Naming naming, std::string_view name) {
    const auto [found, is_new] = number_of_name_[naming].emplace(name, names_[naming].size());
    if (is_new) names_[naming].emplace_back(name);
    return static_cast<std::int64_t>(found->second);
  }

  /// By groups if any face has one, else by objects, else by materials.
  void name_patches() {
    for (const Naming naming : kNamings) {
      auto& parts = part_of_face_[naming];
      bool any = false;
      for (const std::int64_t part : parts) any = any || part >= 0;
      if (!any) continue;
      const std::int64_t ungrouped = number_of(naming, kUngrouped);
      for (std::int64_t& part : parts) part = part < 0 ? ungrouped : part;
      surface_.assign_patches(parts, names_[naming]);
      return;
    }
  }

  Cursor in_;
  SurfaceBuilder surface_;
  std::vector<std::int64_t> corners_;
  std::array<std::vector<std::string>, kNamings.size()> names_;
  std::array<std::map<std::string, std::size_t, std::less<>>, kNamings.size()> number_of_name_;
  std::array<std::int64_t, kNamings.size()> part_ = {-1, -1, -1};
  std::array<std::vector<std::int64_t>, kNamings.size()> part_of_face_;  // (n_faces) each
};

}  // namespace

mesh::SurfaceMesh parse_obj(std::string_view bytes, const std::string& file) { return ObjReader(bytes, file).parse(); }

}  // namespace nearwall::io
