#include "nearwall/surface/fitted_normals.h"

namespace nearwall::surface {

namespace {

constexpr std::uint32_t kEmpty = 0xffffffff;
constexpr std::size_t kSmallestTable = 128;

/// Spreads ids that follow one another over the table (multiplicative hashing with 2^32 over the golden ratio).
std::size_t slot_of(std::uint32_t id, std::size_t table_size) {
  constexpr std::uint32_t kGolden = 0x9e3779b1;
  return (std::uint64_t{id * kGolden} * table_size) >> 32;
}

bool insert(std::vector<std::uint32_t>& table, std::uint32_t id) {
  std::size_t slot = slot_of(id, table.size());
  while (table[slot] != kEmpty) {
    if (table[slot] == id) return false;
    slot = (slot + 1) & (table.size() - 1);
  }
  table[slot] = id;
  return true;
}

}  // namespace

void Neighbourhood::add(VertexId v) {
  if (!insert(table_, v.index())) return;
  found_.push_back(v);
  if (2 * found_.size() > table_.size()) grow_table();
}

void Neighbourhood::grow_table() {
  table_.assign(2 * table_.size(), kEmpty);
  for (const VertexId v : found_) insert(table_, v.index());
}

void Neighbourhood::add_ring(VertexId v) {
  const auto fan = topology_.fan(v);
  for (const HalfedgeId h : fan) add(topology_.target(h));
  // On a boundary the last face ends at a neighbour that no halfedge leaves v for.
  if (!fan.empty()) add(topology_.origin(mesh::Topology::previous(fan.back())));
}

std::span<const VertexId> Neighbourhood::of(VertexId v, int n_rings) {
  found_.clear();
  table_.assign(kSmallestTable, kEmpty);
  add(v);
  std::size_t begin = 0;
  for (int ring = 0; ring < n_rings; ++ring) {
    const std::size_t end = found_.size();
    for (; begin < end; ++begin) {
      const VertexId w = found_[begin];
      if (w == v || topology_.fan(w).size() <= kMaxFan) add_ring(w);
    }
  }
  return std::span<const VertexId>(found_).subspan(1);
}

}  // namespace nearwall::surface
