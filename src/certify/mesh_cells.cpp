#include <algorithm>

#include "nearwall/certify/mesh_certificate.h"
#include "nearwall/core/parallel.h"

namespace nearwall::certify {

namespace {

using mesh::CellType;
using predicates::Positivity;

constexpr std::size_t kCellsInBlock = 4096;

Positivity verdict_of(CellType type, const std::array<Vec3, 8>& corners) {
  const std::span<const Vec3, 8> p(corners);
  switch (type) {
    case CellType::Tetrahedron:
      return predicates::tetrahedron(p.first<4>());
    case CellType::Pyramid:
      return predicates::pyramid(p.first<5>());
    case CellType::Wedge:
      return predicates::wedge(p.first<6>());
    case CellType::Hexahedron:
      return predicates::hexahedron(p);
  }
  return Positivity::NotPositive;
}

bool has_repeated_node(std::span<const std::uint32_t> nodes) {
  for (auto it = nodes.begin(); it != nodes.end(); ++it) {
    if (std::find(nodes.begin(), it, *it) != it) return true;
  }
  return false;
}

void look_at(const mesh::VolumeMesh& mesh, std::size_t cell, CellVerdicts& verdicts) {
  const CellType type = mesh.type[cell];
  const auto t = static_cast<std::size_t>(type);
  ++verdicts.count[t];
  const std::array<Vec3, 8> corners = mesh.corners_of(cell);
  // The predicates of some types refuse what is not finite.
  const bool is_finite_cell = std::all_of(corners.begin(), corners.begin() + mesh::size_of(type), is_finite);
  const Positivity verdict = is_finite_cell ? verdict_of(type, corners) : Positivity::NotPositive;
  if (verdict == Positivity::Positive) return;
  ++(verdict == Positivity::Undecided ? verdicts.undecided : verdicts.not_positive)[t];
  verdicts.offenders.push_back({cell, verdict, has_repeated_node(mesh.nodes_of(cell))});
}

}  // namespace

CellVerdicts cell_verdicts(const mesh::VolumeMesh& mesh) {
  mesh::require_nodes(mesh);
  std::vector<CellVerdicts> by_block((mesh.n_cells() + kCellsInBlock - 1) / kCellsInBlock);
  parallel_blocks(mesh.n_cells(), kCellsInBlock, [&](std::size_t begin, std::size_t end) {
    CellVerdicts verdicts;
    for (std::size_t cell = begin; cell < end; ++cell) look_at(mesh, cell, verdicts);
    by_block[begin / kCellsInBlock] = std::move(verdicts);
  });
  CellVerdicts all;
  for (const CellVerdicts& block : by_block) {
    for (std::size_t t = 0; t < mesh::kNCellTypes; ++t) {
      all.count[t] += block.count[t];
      all.not_positive[t] += block.not_positive[t];
      all.undecided[t] += block.undecided[t];
    }
    all.offenders.insert(all.offenders.end(), block.offenders.begin(), block.offenders.end());
  }
  return all;
}

}  // namespace nearwall::certify
