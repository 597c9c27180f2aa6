#pragma once

#include <vector>

#include "nearwall/mesh/lines.h"

namespace nearwall::layers {

/// Stacks of several schedules in one height table. Each has some rows: the first is the stack as asked, each row after
/// it is thinner with the same first height, the last one uniform. With heights h_k, row p holds h_1 (h_k / h_1)^p, p
/// from 1 to 0: for a geometric stack the growth is lowered from r to r^p. Source: docs/theory/layers.md, Eq. (5).
/// Equal schedules share their rows.
class HeightRows {
 public:
  /// \param schedules  heights of the layers from the wall up, > 0; empty where there are none
  explicit HeightRows(const std::vector<std::vector<double>>& schedules);

  Level n_levels(std::size_t schedule) const { return rows_of(schedule).n_levels; }
  std::size_t first_row(std::size_t schedule) const { return rows_of(schedule).begin; }
  /// Distance of a level from the wall in the stack as asked, and in the uniform one.
  double asked_thickness(std::size_t schedule, Level level) const { return distances_[rows_of(schedule).begin][level]; }
  double uniform_thickness(std::size_t schedule, Level level) const {
    return distances_[rows_of(schedule).end - 1][level];
  }
  mesh::HeightTable table() const;

  /// Heights of a line of which `level`, 1 … n_levels, may lie `limit` above the wall: as asked if it fits, else
  /// flatter with the first height kept, and only below the uniform stack with all heights scaled down.
  mesh::Heights fit(std::size_t schedule, double limit, Level level) const;

 private:
  struct Rows {
    std::size_t begin = 0, end = 0;
    Level n_levels = 0;
  };

  const Rows& rows_of(std::size_t schedule) const { return rows_[of_schedule_[schedule]]; }
  void add_rows(const std::vector<double>& heights);

  std::vector<std::vector<double>> distances_;  // (n_rows) of the levels 0 … n_levels of the row's schedule
  std::vector<Rows> rows_;
  std::vector<std::size_t> of_schedule_;
};

}  // namespace nearwall::layers
