#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "io/batches.h"
#include "nearwall/mesh/mesh_source.h"

namespace nearwall::io {

/// Cells of one type in one group, for formats that list cells by their type.
struct CellSection {
  bool in_layers = false;
  mesh::CellType type = mesh::CellType::Tetrahedron;
  CellIndex n_cells = 0;
};

/// The cells of a source by sections: those of the layers by type, then the others by type; within a section they keep
/// the source's order. Reads the source once when it is made. Memory: 64 bytes a batch.
class CellSections {
 public:
  explicit CellSections(const mesh::MeshSource& mesh);

  /// Those that have cells.
  const std::vector<CellSection>& sections() const { return sections_; }

  /// Streams one section: format(cells, places) → bytes of the cells at these places of a batch, on several threads;
  /// then write(bytes) in order. `format` is called for batches that have cells of the section only.
  template <class Format, class Write>
  void stream(const CellSection& section, const Format& format, const Write& write) const {
    const std::size_t slot = slot_of(section.in_layers, section.type);
    std::vector<std::size_t> batches;
    for (std::size_t b = 0; b < count_.size(); ++b) {
      if (count_[b][slot] > 0) batches.push_back(b);
    }
    in_batches(
        batches.size(),
        [&](std::size_t i) {
          mesh::CellBatch cells;
          mesh_->read_cells(batches[i], cells);
          return format(cells, places_in(cells, slot));
        },
        [&](std::size_t, auto& bytes) { write(bytes); });
  }

 private:
  static constexpr std::size_t kNSlots = 2 * mesh::kNCellTypes;
  static std::size_t slot_of(bool in_layers, mesh::CellType type) {
    return (in_layers ? 0 : mesh::kNCellTypes) + static_cast<std::size_t>(type);
  }
  static std::vector<std::uint32_t> places_in(const mesh::CellBatch& cells, std::size_t slot);

  const mesh::MeshSource* mesh_;
  std::vector<std::array<std::uint32_t, kNSlots>> count_;  // (n_batches)
  std::vector<CellSection> sections_;
};

}  // namespace nearwall::io
