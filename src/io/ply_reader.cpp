#include <fmt/format.h>

#include <string>
#include <vector>

#include "io/point_arrays.h"
#include "io/scalar_type.h"
#include "io/surface_builder.h"
#include "io/surface_formats.h"

namespace nearwall::io {
namespace {

struct Property {
  std::string name;
  ScalarType type = ScalarType::None;
  ScalarType length_type = ScalarType::None;  ///< of lists; None: a single value

  bool is_list() const { return length_type != ScalarType::None; }
};

struct Element {
  std::string name;
  std::int64_t n = 0;
  std::vector<Property> properties;
};

ScalarType scalar_type(std::string_view name) {
  if (name == "char" || name == "int8") return ScalarType::Int8;
  if (name == "uchar" || name == "uint8") return ScalarType::UInt8;
  if (name == "short" || name == "int16") return ScalarType::Int16;
  if (name == "ushort" || name == "uint16") return ScalarType::UInt16;
  if (name == "int" || name == "int32") return ScalarType::Int32;
  if (name == "uint" || name == "uint32") return ScalarType::UInt32;
  if (name == "float" || name == "float32") return ScalarType::Float32;
  if (name == "double" || name == "float64") return ScalarType::Float64;
  return ScalarType::None;
}

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& file, PointArrays& arrays)
      : in_(bytes, file), point_arrays_(arrays) {}

  mesh::SurfaceMesh parse() {
    read_header();
    for (const Element& element : elements_) read_element(element);
    for (auto& [name, values] : wanted_) point_arrays_.take(name, std::move(values));
    if (has_patches_) surface_.assign_patches(patch_of_triangle_, patch_names_);
    return surface_.finish(in_.position());
  }

 private:
  void read_header() {
    if (const auto word = in_.word(); word != "ply") in_.fail_expected("'ply'", word);
    for (;;) {
      const std::string_view keyword = in_.word();
      if (keyword == "end_header") break;
      if (keyword == "format") {
        read_format();
      } else if (keyword == "comment") {
        read_comment();
      } else if (keyword == "obj_info") {
        in_.rest_of_line();
      } else if (keyword == "element") {
        const std::string name(in_.word_of_line());
        elements_.push_back({name, in_.to_integer(in_.word_of_line(), "the number of elements"), {}});
      } else if (keyword == "property") {
        read_property();
      } else {
        in_.fail_expected("a statement of a PLY header", keyword);
      }
    }
    in_.pass_line_end();
    if (!is_ascii_) in_.enter_binary();
  }

  void read_format() {
    const std::string_view word = in_.word_of_line();
    is_ascii_ = word == "ascii";
    order_ = word == "binary_big_endian" ? std::endian::big : std::endian::little;
    if (!is_ascii_ && word != "binary_big_endian" && word != "binary_little_endian") {
      in_.fail_expected("'ascii', 'binary_little_endian' or 'binary_big_endian'", word);
    }
    in_.rest_of_line();
  }

  /// "comment patch NUMBER NAME" is what format_ply writes; other comments mean nothing.
  void read_comment() {
    if (in_.word_of_line() == "patch" && in_.word_of_line() == std::to_string(patch_names_.size())) {
      patch_names_.emplace_back(in_.rest_of_line());
    }
    in_.rest_of_line();
  }

  void read_property() {
    if (elements_.empty()) in_.fail("a property before the first element");
    Property property;
    std::string_view word = in_.word_of_line();
    if (word == "list") {
      property.length_type = scalar_type(in_.word_of_line());
      if (property.length_type == ScalarType::None || is_real(property.length_type)) {
        in_.fail("expected a whole-number type for the length of a list");
      }
      word = in_.word_of_line();
    }
    property.type = scalar_type(word);
    if (property.type == ScalarType::None) in_.fail_expected("a type of PLY such as 'float'", word);
    property.name = in_.word_of_line();
    elements_.back().properties.push_back(property);
  }

  /// Bytes that one item takes at least.
  std::size_t least_bytes(const Element& element) const {
    std::size_t n = 0;
    for (const Property& p : element.properties) {
      n += is_ascii_ ? 2 : size_of(p.is_list() ? p.length_type : p.type);
    }
    return is_ascii_ && n > 0 ? n - 1 : n;
  }

  void read_element(const Element& element) {
    if (element.properties.empty()) return;
    const std::size_t n =
        in_.checked_count(element.n, fmt::format("the number of elements '{}'", element.name), least_bytes(element));
    if (element.name == "tristrips") in_.fail("triangle strips are not supported; write the file with triangles");
    if (element.name == "vertex") {
      check_point_properties(element);
      find_wanted(element);
      surface_.reserve(n, 0);
    }
    if (element.name == "face") {
      for (const Property& p : element.properties) point_arrays_.meet_other(p.name, "a property of the faces");
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (element.name == "vertex") {
        read_point(element);
      } else if (element.name == "face") {
        read_face(element);
      } else {
        for (const Property& p : element.properties) skip(p);
      }
    }
  }

  void check_point_properties(const Element& element) {
    for (const char* axis : {"x", "y", "z"}) {
      bool found = false;
      for (const Property& p : element.properties) found = found || (p.name == axis && !p.is_list());
      if (!found) in_.fail(fmt::format("the points have no property '{}'", axis));
    }
  }

  static bool is_axis(const Property& p) {
    return p.name.size() == 1 && p.name[0] >= 'x' && p.name[0] <= 'z' && !p.is_list();
  }

  void find_wanted(const Element& element) {
    for (const Property& p : element.properties) {
      if (!p.is_list() && !is_axis(p) && point_arrays_.meet(p.name)) wanted_.push_back({p.name, {}});
    }
  }

  void read_point(const Element& element) {
    Vec3 point;
    const FilePosition where = in_.position();
    auto wanted = wanted_.begin();  // in the order of the properties
    for (const Property& p : element.properties) {
      if (is_axis(p)) {
        point[p.name[0] - 'x'] = next<double>(p.type);
      } else if (wanted != wanted_.end() && !p.is_list() && p.name == wanted->first) {
        (wanted++)->second.push_back(next<double>(p.type));
      } else {
        skip(p);
      }
    }
    surface_.add_point(point, where);
  }

  void read_face(const Element& element) {
    const FilePosition where = in_.position();
    std::int64_t patch = 0;
    corners_.clear();
    for (const Property& p : element.properties) {
      if (p.is_list() && (p.name == "vertex_indices" || p.name == "vertex_index")) {
        corners_.resize(length(p));
        for (std::int64_t& corner : corners_) corner = next<std::int64_t>(p.type);
      } else if (!p.is_list() && p.name == "patch") {
        patch = next<std::int64_t>(p.type);
        has_patches_ = true;
      } else {
        skip(p);
      }
    }
    surface_.add_face(corners_, where);
    patch_of_triangle_.resize(surface_.n_faces(), patch);
  }

  std::size_t length(const Property& p) {
    return in_.checked_count(next<std::int64_t>(p.length_type), fmt::format("the length of '{}'", p.name),
                             is_ascii_ ? 2 : size_of(p.type));
  }

  void skip(const Property& p) {
    const std::size_t n = p.is_list() ? length(p) : 1;
    for (std::size_t i = 0; i < n; ++i) {
      if (!is_ascii_) {
        in_.bytes(size_of(p.type), "a value");
      } else if (in_.word().empty()) {
        in_.fail_expected(fmt::format("property '{}'", p.name), "");
      }
    }
  }

  template <class T>
  T next(ScalarType type) {
    if (!is_ascii_) return decode_as<T>(type, in_.bytes(size_of(type), "a value").data(), order_);
    if constexpr (std::is_integral_v<T>) {
      return in_.integer("a whole number");
    } else {
      return in_.number("a number");
    }
  }

  Cursor in_;
  SurfaceBuilder surface_;
  bool is_ascii_ = true;
  std::endian order_ = std::endian::little;
  std::vector<Element> elements_;
  PointArrays& point_arrays_;
  std::vector<std::pair<std::string, std::vector<double>>> wanted_;  // properties of the points and their values
  std::vector<std::int64_t> corners_;
  bool has_patches_ = false;
  std::vector<std::int64_t> patch_of_triangle_;
  std::vector<std::string> patch_names_;
};

}  // namespace

mesh::SurfaceMesh parse_ply(std::string_view bytes, const std::string& file, PointArrays& arrays) {
  return PlyReader(bytes, file, arrays).parse();
}

mesh::SurfaceMesh parse_ply(std::string_view bytes, const std::string& file) {
  PointArrays none;
  return parse_ply(bytes, file, none);
}

}  // namespace nearwall::io
