#include <fmt/format.h>

#include "io/polydata_input.h"
#include "io/volume_builder.h"
#include "io/volume_formats.h"
#include "io/vtk_xml_input.h"

namespace nearwall::io {
namespace {

/// Of cells: 1 at the wall, 0 outside the layers.
constexpr std::string_view kLayer = "Layer";

class VtuReader {
 public:
  VtuReader(std::string_view bytes, const std::string& file)
      : in_(bytes, file), start_{file, true, 0}, builder_(file) {}

  VolumeFile parse() {
    if (in_.type() != "UnstructuredGrid") {
      fail_at(start_, fmt::format("expected a VTK file of type 'UnstructuredGrid', found '{}'", quoted(in_.type())));
    }
    if (in_.pieces().empty()) fail_at(start_, "expected a <Piece>, found none; the file is cut off or damaged");
    for (std::size_t piece = 0; piece < in_.pieces().size(); ++piece) read_piece(piece);
    return builder_.finish(patch_names());
  }

 private:
  /// In the order that lets each array be checked against those before, wherever they stand in the file.
  void read_piece(std::size_t piece) {
    if (const XmlArray* points = find(piece, "Points", "")) {
      in_.read_reals(
          *points, [&](std::size_t n) { builder_.expect_points(n / 3); },
          [&](std::span<const double> run) { builder_.add_coordinates(run); });
    }
    check_count(piece, "NumberOfPoints", "points", builder_.n_points());
    const auto reserve_cells = [&](std::size_t n) { builder_.expect_cells(n); };
    read_integers(find(piece, "Cells", "types"), reserve_cells, &VolumeBuilder::add_types);
    check_count(piece, "NumberOfCells", "types", builder_.n_types());
    read_integers(find(piece, "Cells", "offsets"), reserve_cells, &VolumeBuilder::add_ends);
    check_count(piece, "NumberOfCells", "offsets", builder_.n_ends());
    const auto reserve_nodes = [&](std::size_t n) { builder_.expect_nodes(n); };
    read_integers(find(piece, "Cells", "connectivity"), reserve_nodes, &VolumeBuilder::add_nodes);
    if (const XmlArray* layers = find(piece, "CellData", kLayer); layers && is_single_integer(*layers)) {
      read_integers(
          layers, [](std::size_t) {}, &VolumeBuilder::add_layers);
    }
    builder_.end_piece();
  }

  static bool is_single_integer(const XmlArray& array) {
    const std::string_view components = array.tag.attribute("NumberOfComponents");
    const std::string_view type = array.tag.attribute("type");
    return (components.empty() || components == "1") && (type.starts_with("Int") || type.starts_with("UInt"));
  }

  void read_integers(const XmlArray* array, const VtkXmlInput::Announce& reserve,
                     void (VolumeBuilder::*add)(std::span<const std::int64_t>)) {
    if (!array) return;
    in_.read_integers(*array, reserve, [&](std::span<const std::int64_t> run) { (builder_.*add)(run); });
  }

  /// \param name  empty: any
  const XmlArray* find(std::size_t piece, std::string_view section, std::string_view name) const {
    for (const XmlArray& array : in_.arrays()) {
      if (array.piece == piece && array.section == section && (name.empty() || array.name() == name)) return &array;
    }
    return nullptr;
  }

  void check_count(std::size_t piece, std::string_view attribute, std::string_view what, std::size_t found) const {
    const std::int64_t expected = in_.count_of(piece, attribute);
    if (static_cast<std::uint64_t>(expected) != found) {
      fail_at(start_, fmt::format("{} is {}, but the file holds {} {}", attribute, expected, found, what));
    }
  }

  std::vector<std::string> patch_names() const {
    for (const XmlArray& array : in_.arrays()) {
      if (array.section == "FieldData" && array.name() == kPatchNames) return in_.strings(array);
    }
    return {};
  }

  VtkXmlInput in_;
  FilePosition start_;
  VolumeBuilder builder_;
};

}  // namespace

VolumeFile parse_vtu(std::string_view bytes, const std::string& file) { return VtuReader(bytes, file).parse(); }

}  // namespace nearwall::io
