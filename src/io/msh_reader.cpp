#include <fmt/format.h>

#include "io/msh_input.h"
#include "io/volume_formats.h"
#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

class MshReader {
 public:
  MshReader(std::string_view bytes, const std::string& file) : in_(bytes, file), content_(file) {}

  VolumeFile read() {
    for (std::string_view name = in_.next_section(); !name.empty(); name = in_.next_section()) read_section(name);
    if (!has_elements_) in_.cursor().fail("expected a section $Elements somewhere in the file, found none");
    return content_.finish();
  }

 private:
  void read_section(std::string_view name) {
    if (name == "PhysicalNames") {
      content_.read_names(in_);
    } else if (name == "Entities" && in_.is_version_4()) {
      read_msh41_entities(in_, entities_);
    } else if (name == "PartitionedEntities" && in_.is_version_4()) {
      read_msh41_partitioned_entities(in_, entities_);
    } else if (name == "Nodes") {
      if (content_.has_nodes()) in_.cursor().fail("expected one section $Nodes, found a second one");
      in_.is_version_4() ? read_msh41_nodes(in_, content_) : read_msh22_nodes(in_, content_);
    } else if (name == "Elements") {
      if (!content_.has_nodes()) in_.cursor().fail("expected $Nodes before $Elements, found none");
      if (has_elements_) in_.cursor().fail("expected one section $Elements, found a second one");
      in_.is_version_4() ? read_msh41_elements(in_, entities_, content_) : read_msh22_elements(in_, content_);
      has_elements_ = true;
    } else if (name == "ParametricNodes") {
      throw InputError(
          fmt::format("{}: nodes with parameters: save it again with Mesh.SaveParametric = 0", in_.cursor().file()));
    } else {
      in_.pass_section(name);  // periodic nodes, ghosts, data, …
    }
  }

  MshInput in_;
  MshContent content_;
  MshEntities entities_;
  bool has_elements_ = false;
};

}  // namespace

VolumeFile parse_msh(std::string_view bytes, const std::string& file) { return MshReader(bytes, file).read(); }

}  // namespace nearwall::io
