#pragma once

#include <vector>

#include "nearwall/mesh/lines.h"

namespace nearwall::layers {

/// The rows that one schedule has in the height table: row `first` is the stack as asked, each row after it is thinner
/// with the same first height, the last one uniform. With heights h_k, row p holds h_1 (h_k / h_1)^p, p from 1 to 0:
/// for a geometric stack the growth is lowered from r to r^p. Source: docs/theory/layers.md, Eq. (4).
struct ScheduleRows {
  std::size_t first = 0;
  std::vector<double> thickness;  ///< of each row, falling
  Level n_levels = 0;

  double asked_thickness() const { return thickness.empty() ? 0.0 : thickness.front(); }

  /// Heights of a line that may be `limit` thick: as asked if it fits, else flatter with the first height kept, and
  /// only below the uniform stack with all heights scaled down.
  mesh::Heights fit(double limit) const;
};

/// Rows of several schedules in one table. Equal schedules share their rows.
class HeightRows {
 public:
  /// \param schedules  heights of the layers from the wall up, > 0; empty where there are none
  explicit HeightRows(const std::vector<std::vector<double>>& schedules);

  const ScheduleRows& schedule(std::size_t i) const { return rows_[of_schedule_[i]]; }
  mesh::HeightTable table() const;

 private:
  void add_rows(const std::vector<double>& heights);

  std::vector<std::vector<double>> distances_;
  std::vector<ScheduleRows> rows_;
  std::vector<std::size_t> of_schedule_;
};

}  // namespace nearwall::layers
