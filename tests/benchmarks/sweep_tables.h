#pragma once

#include <string>
#include <vector>

#include "sweep_measure.h"

namespace nearwall::sweep {

/// The rows of all surfaces under one schedule and one set of options; as many as there are surfaces that can be used.
using Rows = std::vector<Row>;

/// One lever of the ablation, switched off.
struct Variant {
  std::string name;
  std::vector<Rows> rows;  ///< by schedule
};

double mean(const Rows& rows, double Row::*member);
double median(const Rows& rows, double Row::*member);
double smallest(const Rows& rows, double Row::*member);
double largest(const Rows& rows, double Row::*member);

/// For the terminal: a line for each surface, then mean, median, worst.
std::string text_table(const std::vector<std::string>& names, const Rows& rows);

/// What is asked of all surfaces together, and what there is.
std::string summary_markdown(const std::vector<Standard>& standards, const std::vector<Rows>& rows);

/// A row for each surface with the figures under each schedule, then those that were refused.
std::string surfaces_markdown(const std::vector<Sample>& samples, const std::vector<Standard>& standards,
                              const std::vector<Rows>& rows);

/// A row for each variant and schedule.
std::string ablation_markdown(const std::vector<Standard>& standards, const std::vector<Variant>& variants);

/// The surfaces that have the smallest share at full thickness, the smallest first: name, file, shares, reason, place,
/// normal there, diagonal of the bounding box, separated by tabs.
std::string worst_table(const std::vector<Sample>& samples, const Rows& rows, std::size_t n);

}  // namespace nearwall::sweep
