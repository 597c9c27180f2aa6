#include "nearwall/mesh/lines.h"

#include "nearwall/core/expect.h"

namespace nearwall::mesh {

HeightTable::HeightTable(const std::vector<std::vector<double>>& rows) {
  expect(!rows.empty() && !rows.front().empty(), "a height table with at least one row and level 0");
  n_levels_ = static_cast<Level>(rows.front().size() - 1);
  data_.reserve(rows.size() * rows.front().size());
  for (const auto& row : rows) {
    expect(row.size() == rows.front().size() && row.front() == 0, "rows of one length that begin with distance 0");
    data_.insert(data_.end(), row.begin(), row.end());
  }
}

void Lines::positions(LineId line, Level first, Level last, double* x, double* y, double* z) const {
  for (Level j = first;; ++j) {
    const Vec3 p = position(line, j);
    *x++ = p.x();
    *y++ = p.y();
    *z++ = p.z();
    if (j == last) break;
  }
}

}  // namespace nearwall::mesh
