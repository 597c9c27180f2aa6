#include "io/picture_arguments.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <functional>
#include <map>

#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

std::string to_text(const Vec3& v) { return fmt::format("{},{},{}", v.x(), v.y(), v.z()); }

/// Comma-separated finite numbers, as many as the text has.
std::vector<double> numbers(std::string_view text) {
  std::vector<double> out;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    std::string_view word = text.substr(begin, end - begin);
    while (word.starts_with(' ')) word.remove_prefix(1);
    while (word.ends_with(' ')) word.remove_suffix(1);
    double value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || stop != word.data() + word.size() || !std::isfinite(value)) {
      throw InputError(fmt::format("expected a number, found '{}' in '{}'", word, text));
    }
    out.push_back(value);
    begin = end + 1;
  }
  return out;
}

std::vector<double> numbers(std::string_view text, std::size_t n) {
  std::vector<double> out = numbers(text);
  if (out.size() != n) throw InputError(fmt::format("expected {} numbers, found '{}'", n, text));
  return out;
}

Vec3 vector_of(std::span<const double> n) { return {n[0], n[1], n[2]}; }

/// "x", "-y", "z=0.3"; nothing if the text is none of them.
std::optional<ClipPlane> parse_axis_plane(std::string_view text) {
  const bool is_turned = text.starts_with('-');
  const std::string_view rest = text.substr(is_turned ? 1 : 0);
  if (rest.empty() || rest[0] < 'x' || rest[0] > 'z' || (rest.size() > 1 && rest[1] != '=')) return std::nullopt;
  const int axis = rest[0] - 'x';
  ClipPlane plane;
  plane.normal[axis] = is_turned ? -1 : 1;
  if (rest.size() > 1) {
    plane.point = Vec3();
    (*plane.point)[axis] = numbers(rest.substr(2), 1)[0];
  }
  return plane;
}

}  // namespace

ClipPlane parse_clip_plane(std::string_view text) try {
  if (const auto plane = parse_axis_plane(text)) return *plane;
  const std::vector<double> n = numbers(text);
  if (n.size() != 3 && n.size() != 6) throw InputError(fmt::format("expected 3 or 6 numbers, found {}", n.size()));
  ClipPlane plane{vector_of(n), std::nullopt};
  if (n.size() == 6) plane.point = vector_of(std::span(n).subspan(3));
  if (plane.normal == Vec3()) throw InputError("the normal is zero");
  return plane;
} catch (const InputError& error) {
  throw InputError(fmt::format("clip plane '{}': {}; allowed: x, y, z, -x ..., x=0.3, nx,ny,nz or nx,ny,nz,px,py,pz",
                               text, error.what()));
}

std::vector<std::string> to_arguments(const PictureRequest& r) {
  std::vector<std::string> out = {"input=" + r.input.string(), "output=" + r.output.string(),
                                  fmt::format("size={},{}", r.size[0], r.size[1]), "colour_by=" + r.colour_by,
                                  "title=" + r.title};
  if (r.logarithmic) out.emplace_back("logarithmic=1");
  if (!r.edges) out.emplace_back("edges=0");
  if (r.range) out.push_back(fmt::format("range={},{}", (*r.range)[0], (*r.range)[1]));
  if (r.clip) out.push_back("clip_normal=" + to_text(r.clip->normal));
  if (r.clip && r.clip->point) out.push_back("clip_point=" + to_text(*r.clip->point));
  if (r.zoom) out.push_back("zoom=" + to_text(r.zoom->low) + "," + to_text(r.zoom->high));
  if (r.view) out.push_back("view=" + to_text(*r.view));
  return out;
}

PictureRequest request_of(std::span<const std::string> arguments) {
  PictureRequest r;
  const auto clip = [&]() -> ClipPlane& { return r.clip ? *r.clip : r.clip.emplace(); };
  const std::map<std::string_view, std::function<void(const std::string&)>> setters = {
      {"input", [&](const std::string& v) { r.input = v; }},
      {"output", [&](const std::string& v) { r.output = v; }},
      {"colour_by", [&](const std::string& v) { r.colour_by = v; }},
      {"title", [&](const std::string& v) { r.title = v; }},
      {"logarithmic", [&](const std::string& v) { r.logarithmic = v == "1"; }},
      {"edges", [&](const std::string& v) { r.edges = v == "1"; }},
      {"size",
       [&](const std::string& v) {
         const auto n = numbers(v, 2);
         r.size = {static_cast<int>(n[0]), static_cast<int>(n[1])};
       }},
      {"range",
       [&](const std::string& v) {
         const auto n = numbers(v, 2);
         r.range = {{n[0], n[1]}};
       }},
      {"clip_normal", [&](const std::string& v) { clip().normal = vector_of(numbers(v, 3)); }},
      {"clip_point", [&](const std::string& v) { clip().point = vector_of(numbers(v, 3)); }},
      {"zoom",
       [&](const std::string& v) {
         const auto n = numbers(v, 6);
         r.zoom = ZoomBox{vector_of(n), vector_of(std::span(n).subspan(3))};
       }},
      {"view", [&](const std::string& v) { r.view = vector_of(numbers(v, 3)); }},
  };
  for (const std::string& argument : arguments) {
    const std::size_t equals = std::min(argument.find('='), argument.size());
    const auto setter = setters.find(std::string_view(argument).substr(0, equals));
    if (setter == setters.end()) throw InputError(fmt::format("unknown argument '{}'", argument));
    setter->second(argument.substr(std::min(equals + 1, argument.size())));
  }
  return r;
}

}  // namespace nearwall::io
