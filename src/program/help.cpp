#include "program/help.h"

#include <algorithm>

#include <fmt/format.h>

#include "program/table.h"

namespace nearwall::program {

namespace {

constexpr std::size_t kLeftWidth = 28;
constexpr std::size_t kLineWidth = 100;

/// Text broken at blanks so that no line is wider than `width`; all lines but the first are indented.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  std::string out;
  std::size_t column = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (column > 0 && column + 1 + text_width(word) > width) {
      out += "\n" + std::string(indent, ' ');
      column = 0;
    } else if (column > 0) {
      out += ' ';
      ++column;
    }
    out += word;
    column += text_width(word);
    begin = end + 1;
  }
  return out;
}

std::string left_side(const CLI::Option& option) {
  if (option.nonpositional()) {
    // CLI11 appends what its validators accept, which belongs into the description.
    const std::string type = option.get_type_name();
    const std::string value = option.get_type_size() == 0 ? "" : " " + type.substr(0, type.find(':'));
    const std::string indent = option.get_snames().empty() ? "    " : "";
    return indent + option.get_name(false, true) + value;
  }
  return option.get_name(true);
}

std::string right_side(const CLI::Option& option) {
  const std::string value = option.get_default_str();
  return option.get_description() + (value.empty() ? "" : fmt::format(" [{}]", value));
}

std::string section(const CLI::App& app, const std::string& title, bool is_positional, const std::string& group = "") {
  std::string out;
  for (const CLI::Option* option : app.get_options()) {
    if (option->nonpositional() == is_positional || (!is_positional && option->get_group() != group)) continue;
    out += entry(left_side(*option), right_side(*option));
  }
  return out.empty() ? out : fmt::format("\n{}\n{}", title, out);
}

std::string names_below(const CLI::App& app) {
  std::string out;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    out += entry(sub->get_name(), sub->get_description());
  }
  return out.empty() ? out : "\nnames\n" + out;
}

std::string indented(const std::string& lines) {
  std::string out = "  ";
  for (const char c : lines) out += c == '\n' ? std::string("\n  ") : std::string(1, c);
  return out + "\n";
}

std::string command_help(const CLI::App& app, const std::string& usage, const std::string& example) {
  std::string out = fmt::format("{}\n\nusage\n  nearwall {}\n", app.get_description(), usage);
  out += section(app, "arguments", true);
  for (const std::string& group : app.get_groups()) {
    if (!group.empty() && group != kCommonGroup)
      out += section(app, group == "Options" ? "options" : group, false, group);
  }
  out += section(app, "common options", false, kCommonGroup);
  out += names_below(app);
  return out + fmt::format("\nexample\n{}", indented(example));
}

}  // namespace

std::string entry(const std::string& left, const std::string& right) {
  std::string line = "  " + left;
  const std::size_t width = text_width(line);
  line += width + 2 <= kLeftWidth ? std::string(kLeftWidth - width, ' ') : "\n" + std::string(kLeftWidth, ' ');
  return line + wrapped(right, kLineWidth - kLeftWidth, kLeftWidth) + "\n";
}

std::string overview() {
  return R"(nearwall meshes the boundary layer: prisms grown from a surface, every one of them certified.

  start
    nearwall init wing.stl > case.toml     a commented case file for your surface
    nearwall run case.toml                 surface to layers, pictures and report

  mesh
    run        the main job: surface to certified layers, files and report
    batch      many cases or surfaces, a table at the end
    init       print a commented case file

  look
    check      what is wrong with a surface, and what its edges are like
    normals    point normals of a surface
    picture    a picture of a surface or mesh, no display needed
    certify    the certificate of any mesh, and the layers it has on a wall

  prepare
    layers     first height and layers for a y+ that you want
    shape      surfaces of wings, bodies, ducts and test shapes
    convert    a surface from one format to another

  look into
    study      the studies of papers on normals, run again

  nearwall COMMAND --help      options, each command with an example
  nearwall --version
)";
}

std::shared_ptr<CLI::FormatterBase> help_formatter(const std::string& usage, const std::string& example) {
  return std::make_shared<CLI::FormatterLambda>(
      [usage, example](const CLI::App* app, const std::string&, CLI::AppFormatMode) {
        return command_help(*app, usage, example);
      });
}

}  // namespace nearwall::program
