#include <fmt/format.h>

#include <array>

#include "io/surface_builder.h"
#include "io/surface_formats.h"

namespace nearwall::io {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kTriangleBytes = 50;  // normal and corners as 12 floats, two bytes of attributes
constexpr std::size_t kFirstTriangle = kHeaderBytes + sizeof(std::uint32_t);

std::size_t claimed_triangles(std::string_view bytes) {
  return Cursor::decode<std::uint32_t>(bytes.data() + kHeaderBytes, std::endian::little);
}

/// Headers of binary files may begin with "solid", too: then the size, or bytes that no text has, tell.
bool is_binary(std::string_view bytes) {
  const std::string_view start = trimmed(bytes.substr(0, kHeaderBytes));
  const bool says_solid = same_word(start.substr(0, 5), "solid");
  if (bytes.size() < kFirstTriangle) return !says_solid && !start.empty();
  if (bytes.size() == kFirstTriangle + kTriangleBytes * claimed_triangles(bytes)) return true;
  return !says_solid || bytes.substr(kHeaderBytes, kTriangleBytes).find('\0') != std::string_view::npos;
}

mesh::SurfaceMesh parse_binary(std::string_view bytes, const std::string& file) {
  Cursor in(bytes, file);
  in.enter_binary();
  if (bytes.size() < kFirstTriangle) {
    in.fail(fmt::format("expected \"solid\" (ascii) or {} bytes of header (binary), found {} bytes", kFirstTriangle,
                        bytes.size()));
  }
  in.seek(kHeaderBytes);
  const std::size_t claimed = claimed_triangles(bytes);
  const std::size_t held = (bytes.size() - kFirstTriangle) / kTriangleBytes;
  if (claimed > held) {
    in.fail(
        fmt::format("the header claims {} triangles, the file holds {} ({} bytes); it is cut off or no STL file; "
                    "export it again",
                    claimed, held, bytes.size()));
  }
  if (held > claimed) {
    in.fail(fmt::format("the header claims {} triangles, but {} bytes follow them; export the file again", claimed,
                        bytes.size() - kFirstTriangle - kTriangleBytes * claimed));
  }
  in.seek(kFirstTriangle);
  SurfaceBuilder surface;
  surface.reserve(3 * claimed, claimed);
  for (std::size_t t = 0; t < claimed; ++t) {
    const FilePosition where = in.position();
    const char* at = in.bytes(kTriangleBytes, "a triangle").data() + 3 * sizeof(float);
    std::array<std::int64_t, 3> corners;
    for (std::int64_t& corner : corners) {
      Vec3 point;
      for (int axis = 0; axis < 3; ++axis, at += sizeof(float)) {
        point[axis] = static_cast<double>(Cursor::decode<float>(at, std::endian::little));
      }
      corner = surface.add_point(point, where).index();
    }
    surface.add_face(corners, where);
  }
  return surface.finish(in.position());
}

class AsciiStl {
 public:
  AsciiStl(std::string_view bytes, const std::string& file) : in_(bytes, file) { in_.allow_decimal_comma(); }

  mesh::SurfaceMesh parse() {
    for (std::string_view word = in_.word(); !word.empty(); word = in_.word()) {
      if (!same_word(word, "solid")) in_.fail_expected("'solid'", word);
      read_solid();
    }
    return surface_.finish(in_.position());
  }

 private:
  void read_solid() {
    const std::string name(in_.rest_of_line());
    surface_.begin_patch(name.empty() ? fmt::format("solid{}", n_solids_) : name);
    ++n_solids_;
    for (;;) {
      const std::string_view word = in_.word();
      if (same_word(word, "endsolid")) break;
      if (!same_word(word, "facet")) in_.fail_expected("'facet' or 'endsolid'", word);
      read_facet();
    }
    in_.rest_of_line();
  }

  void read_facet() {
    in_.rest_of_line();  // the normal: it follows from the corners, and files are often wrong about it
    const FilePosition where = in_.position();
    require("outer");
    require("loop");
    std::array<std::int64_t, 3> corners;
    for (std::int64_t& corner : corners) {
      require("vertex");
      const double x = in_.number("x"), y = in_.number("y"), z = in_.number("z");
      corner = surface_.add_point({x, y, z}, in_.position()).index();
    }
    const std::string_view word = in_.word();
    if (same_word(word, "vertex")) in_.fail("a facet of more than 3 vertices; STL knows triangles only");
    if (!same_word(word, "endloop")) in_.fail_expected("'endloop'", word);
    skip_remark("endfacet");
    require("endfacet");
    skip_remark("facet");
    surface_.add_face(corners, where);
  }

  /// Some programs leave words of their own behind the keywords that end a facet.
  void skip_remark(std::string_view next_keyword) {
    const std::size_t before = in_.offset();
    const std::string_view word = in_.word_of_line();
    if (word.empty() || same_word(word, next_keyword) || same_word(word, "endsolid")) {
      in_.seek(before);
    } else {
      in_.rest_of_line();
    }
  }

  void require(std::string_view expected) {
    const std::string_view word = in_.word();
    if (!same_word(word, expected)) in_.fail_expected(fmt::format("'{}'", expected), word);
  }

  Cursor in_;
  SurfaceBuilder surface_;
  int n_solids_ = 0;
};

}  // namespace

mesh::SurfaceMesh parse_stl(std::string_view bytes, const std::string& file) {
  return is_binary(bytes) ? parse_binary(bytes, file) : AsciiStl(bytes, file).parse();
}

}  // namespace nearwall::io
