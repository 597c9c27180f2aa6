#include <charconv>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "nearwall/core/errors.h"
#include "nearwall/io/picture.h"
#include "program/cli.h"

namespace nearwall::program {

namespace {

struct PictureArguments {
  std::string file;
  std::string output;
  std::string clip;
  std::string size = "1600x1000";
  std::string color;
  std::string title;
  std::vector<double> range;
  std::vector<double> zoom;
  std::vector<double> view;
  bool is_logarithmic = false;
  bool has_no_edges = false;
};

/// "1600x1000" as two numbers.
std::array<int, 2> parse_size(const std::string& text) {
  std::array<int, 2> size{};
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size[0]);
  const bool has_cross = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = has_cross ? std::from_chars(width.ptr + 1, end, size[1]) : width;
  if (!has_cross || height.ec != std::errc() || height.ptr != end) {
    throw InputError(fmt::format("--size {}: expected width and height in pixels, as 1600x1000", text));
  }
  return size;
}

io::PictureRequest request_of(const PictureArguments& arguments) {
  io::PictureRequest request;
  request.input = arguments.file;
  request.output = arguments.output;
  request.size = parse_size(arguments.size);
  request.colour_by = arguments.color;
  request.logarithmic = arguments.is_logarithmic;
  request.title = arguments.title;
  request.edges = !arguments.has_no_edges;
  if (!arguments.clip.empty()) request.clip = io::parse_clip_plane(arguments.clip);
  if (const auto& r = arguments.range; !r.empty()) request.range = {r[0], r[1]};
  if (const auto& z = arguments.zoom; !z.empty()) request.zoom = {{z[0], z[1], z[2]}, {z[3], z[4], z[5]}};
  if (const auto& v = arguments.view; !v.empty()) request.view = Vec3(v[0], v[1], v[2]);
  return request;
}

ExitCode run_picture(const PictureArguments& arguments, Console& console) {
  const io::PictureRequest request = request_of(arguments);
  const io::PictureResult result = staged(console, "picture", [&] { return io::render_picture(request); });
  if (!result.made) throw BackendError(fmt::format("{}: no picture was made: {}", arguments.output, result.reason));
  console.print_json(nlohmann::json{{"file", arguments.output}, {"size", request.size}});
  console.print(fmt::format("{}: {} x {} pixels\n", arguments.output, request.size[0], request.size[1]));
  return ExitCode::Done;
}

}  // namespace

void add_picture_command(CommandLine& line) {
  const auto arguments = std::make_shared<PictureArguments>();
  CLI::App& app =
      line.add("picture", "a picture of a surface or mesh; no display is needed", "picture FILE -o OUT.png [options]",
               "nearwall picture out/onera-m6.vtu -o cut.png --clip y=0.6 --color Layer\n"
               "nearwall picture out/onera-m6-surface.vtp -o kinds.png --color PointKind --view -1,-1,1",
               [arguments](CommandContext& context) { return run_picture(*arguments, context.console); });
  app.add_option("FILE", arguments->file, "a mesh (vtu) or a surface (vtp, stl, obj, ply, off, vtk)")->required();
  app.add_option("-o,--output", arguments->output, "the picture")->type_name("OUT.png")->required();
  app.add_option("--clip", arguments->clip,
                 "cut: x, y, z or -x, -y, -z through the middle; y=0.6 at a coordinate; nx,ny,nz across a normal; "
                 "nx,ny,nz,px,py,pz through a point, too. What lies on the side of the normal is taken away")
      ->type_name("PLANE");
  app.add_option("--color,--colour", arguments->color, "cell or point array to colour by, such as Layer")
      ->type_name("ARRAY");
  app.add_flag("--log", arguments->is_logarithmic, "colours by the logarithm, for positive values");
  app.add_option("--range", arguments->range, "of the colours; otherwise that of the array")
      ->type_name("LOW,HIGH")
      ->delimiter(',')
      ->expected(2);
  app.add_option("--title", arguments->title, "of the colour bar; otherwise the name of the array")->type_name("TEXT");
  app.add_option("--zoom", arguments->zoom, "box that fills the picture: x0,y0,z0,x1,y1,z1")
      ->type_name("BOX")
      ->delimiter(',')
      ->expected(6);
  app.add_option("--view", arguments->view, "direction from the object to the eye: x,y,z")
      ->type_name("X,Y,Z")
      ->delimiter(',')
      ->expected(3);
  app.add_option("--size", arguments->size, "width and height in pixels")->type_name("WxH")->capture_default_str();
  app.add_flag("--no-edges", arguments->has_no_edges, "leave out the edges of the cells");
}

}  // namespace nearwall::program
