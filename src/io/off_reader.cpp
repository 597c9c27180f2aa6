#include <fmt/format.h>

#include <vector>

#include "io/surface_builder.h"
#include "io/surface_formats.h"

namespace nearwall::io {
namespace {

constexpr std::size_t kShortestPoint = 5;  // "0 0 0" in bytes, to hold counts against the size of the file
constexpr std::size_t kShortestFace = 5;

/// Optional first word: [ST][C][N][4][n]OFF. Texture, colour and normal only add numbers behind the coordinates.
void read_header(Cursor& in) {
  std::string_view word = in.word();
  if (!word.ends_with("OFF")) {
    if (word.empty() || word.find_first_not_of("0123456789") != std::string_view::npos) in.fail_expected("'OFF'", word);
    in.seek(in.offset() - word.size());  // the format lets the word be left out
    return;
  }
  if (word.find_first_of("4n") != std::string_view::npos) {
    in.fail("points of more than 3 coordinates (4OFF, nOFF) are not supported");
  }
  const std::size_t after_header = in.offset();
  word = in.word_of_line();
  if (same_word(word, "BINARY")) in.fail("binary OFF is not supported; convert it to ascii OFF, PLY or STL");
  in.seek(after_header);
}

}  // namespace

mesh::SurfaceMesh parse_off(std::string_view bytes, const std::string& file) {
  Cursor in(bytes, file, '#');
  read_header(in);
  const std::int64_t n_points_claimed = in.integer("the number of points");
  const std::int64_t n_faces_claimed = in.to_integer(in.word_of_line(), "the number of faces");
  const std::size_t n_points = in.checked_count(n_points_claimed, "the number of points", kShortestPoint);
  const std::size_t n_faces = in.checked_count(n_faces_claimed, "the number of faces", kShortestFace);

  SurfaceBuilder surface;
  surface.reserve(n_points, n_faces);
  for (std::size_t i = 0; i < n_points; ++i) {
    if (!in.next_line()) in.fail(fmt::format("expected {} points, found the end of the file after {}", n_points, i));
    const double x = in.to_number(in.word_of_line(), "x");
    const double y = in.to_number(in.word_of_line(), "y");
    const double z = in.to_number(in.word_of_line(), "z");
    surface.add_point({x, y, z}, in.position());
  }
  std::vector<std::int64_t> corners;
  for (std::size_t i = 0; i < n_faces; ++i) {
    if (!in.next_line()) in.fail(fmt::format("expected {} faces, found the end of the file after {}", n_faces, i));
    const std::int64_t claimed = in.to_integer(in.word_of_line(), "the number of corners of a face");
    corners.resize(in.checked_count(claimed, "the number of corners of a face", 2));
    for (std::int64_t& corner : corners) corner = in.to_integer(in.word_of_line(), "a point of the face");
    surface.add_face(corners, in.position());
  }
  return surface.finish(in.position());
}

}  // namespace nearwall::io
