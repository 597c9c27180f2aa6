#include "io/vtk_xml_output.h"

#include <fmt/format.h>

#include "nearwall/core/markup.h"

namespace nearwall::io {

VtkXmlOutput::VtkXmlOutput(std::string_view type) : type_(type) {
  tags_ = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<{0}>\n",
      type_);
}

void VtkXmlOutput::open(std::string_view tag) { tags_ += fmt::format("<{}>\n", tag); }

void VtkXmlOutput::close(std::string_view name) { tags_ += fmt::format("</{}>\n", name); }

void VtkXmlOutput::add(PackedArray& array) {
  tags_ += fmt::format("{} format=\"appended\" offset=\"{}\"/>\n", array.tag(), offset_);
  offset_ += array.size();
  arrays_.push_back(&array);
}

void VtkXmlOutput::add_strings(std::string_view name, const std::vector<std::string>& strings) {
  tags_ += fmt::format("<Array type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"ascii\">\n",
                       escaped_markup(name), strings.size());
  for (const std::string& text : strings) {
    for (const unsigned char c : text) tags_ += fmt::format("{} ", c);
    tags_ += "0\n";
  }
  tags_ += "</Array>\n";
}

void VtkXmlOutput::write_to(const ByteSink& write) {
  write(tags_);
  write(fmt::format("</{}>\n<AppendedData encoding=\"raw\">\n_", type_));
  for (PackedArray* array : arrays_) array->copy_to(write);
  write("\n</AppendedData>\n</VTKFile>\n");
}

}  // namespace nearwall::io
