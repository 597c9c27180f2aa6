#include "io/cell_sections.h"

namespace nearwall::io {

CellSections::CellSections(const mesh::MeshSource& mesh) : mesh_(&mesh), count_(mesh.n_cell_batches()) {
  parallel_blocks(count_.size(), 1, [&](std::size_t begin, std::size_t end) {
    mesh::CellBatch cells;
    for (std::size_t b = begin; b < end; ++b) {
      mesh.read_cells(b, cells);
      count_[b] = {};
      for (std::size_t c = 0; c < cells.size(); ++c) ++count_[b][slot_of(cells.layer[c] > 0, cells.type[c])];
    }
  });
  for (const bool in_layers : {true, false}) {
    for (std::size_t type = 0; type < mesh::kNCellTypes; ++type) {
      CellSection section{in_layers, static_cast<mesh::CellType>(type), 0};
      for (const auto& count : count_) section.n_cells += count[slot_of(in_layers, section.type)];
      if (section.n_cells > 0) sections_.push_back(section);
    }
  }
}

std::vector<std::uint32_t> CellSections::places_in(const mesh::CellBatch& cells, std::size_t slot) {
  std::vector<std::uint32_t> places;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (slot_of(cells.layer[c] > 0, cells.type[c]) == slot) places.push_back(static_cast<std::uint32_t>(c));
  }
  return places;
}

}  // namespace nearwall::io
