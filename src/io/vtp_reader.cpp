#include <fmt/format.h>

#include "io/point_arrays.h"
#include "io/polydata_input.h"
#include "io/surface_formats.h"
#include "io/vtk_xml_input.h"

namespace nearwall::io {
namespace {

class VtpReader {
 public:
  VtpReader(std::string_view bytes, const std::string& file, PointArrays& arrays)
      : in_(bytes, file), file_(file), point_arrays_(arrays) {}

  mesh::SurfaceMesh parse() {
    const FilePosition start{file_, true, 0};
    if (in_.type() != "PolyData") {
      fail_at(start,
              fmt::format("expected a VTK file of type 'PolyData', found '{}' (in ParaView: Extract Surface, then "
                          "save as .vtp)",
                          quoted(in_.type())));
    }
    if (in_.pieces().size() > 1) {
      fail_at(start, fmt::format("the file has {} pieces, expected 1; merge them and save again", in_.pieces().size()));
    }
    data_.n_vertices_and_lines = static_cast<std::size_t>(in_.count_of(0, "NumberOfVerts")) +
                                 static_cast<std::size_t>(in_.count_of(0, "NumberOfLines"));
    for (const XmlArray& array : in_.arrays()) read_array(array);
    check_count("NumberOfPoints", data_.points.size());
    check_count("NumberOfPolys", data_.polygons.ends.size());
    check_count("NumberOfStrips", data_.strips.ends.size());
    return to_surface(data_, start);
  }

 private:
  void read_array(const XmlArray& array) {
    if (array.section == "Points") {
      read_points(array);
    } else if (array.section == "Polys") {
      read_cells(array, data_.polygons);
    } else if (array.section == "Strips") {
      read_cells(array, data_.strips);
    } else if (array.section == "CellData" && is_patch_array_name(array.name()) && is_single_integer(array)) {
      point_arrays_.meet_other(std::string(array.name()), "a cell array");
      data_.cell_arrays.push_back({std::string(array.name()), in_.integers(array)});
    } else if (array.section == "PointData" && is_single_number(array)) {
      const std::string name(array.name());
      if (point_arrays_.meet(name)) point_arrays_.take(name, in_.reals(array));
    } else if (array.section == "PointData" && !is_single(array)) {
      const std::string components(array.tag.attribute("NumberOfComponents"));
      point_arrays_.meet_other(std::string(array.name()), fmt::format("a point array of {} components", components));
    } else if (array.section == "CellData") {
      point_arrays_.meet_other(std::string(array.name()), "a cell array");
    } else if (array.section == "FieldData" && array.name() == kPatchNames) {
      data_.patch_names = in_.strings(array);
    }
  }

  static bool is_single(const XmlArray& array) {
    const std::string_view components = array.tag.attribute("NumberOfComponents");
    return components.empty() || components == "1";
  }

  static bool is_single_integer(const XmlArray& array) {
    const std::string_view type = array.tag.attribute("type");
    return is_single(array) && (type.starts_with("Int") || type.starts_with("UInt"));
  }

  static bool is_single_number(const XmlArray& array) {
    return is_single_integer(array) || (is_single(array) && array.tag.attribute("type").starts_with("Float"));
  }

  void read_points(const XmlArray& array) {
    const std::vector<double> values = in_.reals(array);
    if (values.size() % 3 != 0) in_.at(array).fail("the points do not have 3 coordinates each");
    data_.points.clear();
    data_.points.reserve(values.size() / 3);
    for (std::size_t i = 0; i < values.size(); i += 3)
      data_.points.emplace_back(values[i], values[i + 1], values[i + 2]);
  }

  void read_cells(const XmlArray& array, CellList& cells) {
    if (array.name() == "connectivity") cells.points = in_.integers(array);
    if (array.name() == "offsets") cells.ends = in_.integers(array);
  }

  void check_count(std::string_view attribute, std::size_t found) const {
    const std::int64_t expected = in_.count_of(0, attribute);
    if (static_cast<std::uint64_t>(expected) != found) {
      fail_at({file_, true, 0}, fmt::format("{} is {}, but the arrays hold {}", attribute, expected, found));
    }
  }

  VtkXmlInput in_;
  std::string file_;
  PolyDataInput data_;
  PointArrays& point_arrays_;
};

}  // namespace

mesh::SurfaceMesh parse_vtp(std::string_view bytes, const std::string& file, PointArrays& arrays) {
  return VtpReader(bytes, file, arrays).parse();
}

mesh::SurfaceMesh parse_vtp(std::string_view bytes, const std::string& file) {
  PointArrays none;
  return parse_vtp(bytes, file, none);
}

}  // namespace nearwall::io
