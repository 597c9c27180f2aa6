#include "nearwall/mesh/front_part.h"

#include <algorithm>

#include "nearwall/core/expect.h"

namespace nearwall::mesh {

FrontPart::FrontPart(const Front& whole) : whole_(whole), number_(whole.n_lines()) { front_.first_line.push_back(0); }

void FrontPart::add(FrontFaceId f) {
  FrontFace face = whole_.faces[f];
  for (int k = 0; k < whole_.faces[f].size(); ++k) {
    LineId& line = face.lines[static_cast<std::size_t>(k)];
    line = take(line);
  }
  if (whole_.is_wall(f)) {
    expect(front_.n_wall_faces == front_.faces.size(), "wall faces before virtual ones");
    ++front_.n_wall_faces;
  }
  front_.faces.push_back(face);
}

bool FrontPart::has_vertices_of(FrontFaceId f) const {
  const FrontFace& face = whole_.faces[f];
  return std::all_of(face.lines.begin(), face.lines.begin() + face.size(),
                     [&](LineId line) { return number_[line].is_valid(); });
}

LineId FrontPart::take(LineId line) {
  if (number_[line].is_valid()) return number_[line];
  const VertexId v = whole_.line_vertex[line];
  const VertexId own(front_.first_line.size() - 1);
  for (const LineId l : whole_.lines_of(v)) {
    number_[l] = front_.line_vertex.push_back(own);
    original_line_.push_back(l);
  }
  front_.first_line.push_back(static_cast<std::uint32_t>(front_.n_lines()));
  return number_[line];
}

}  // namespace nearwall::mesh
