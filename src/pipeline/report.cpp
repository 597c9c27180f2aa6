#include "nearwall/pipeline/report.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace nearwall {

std::uint64_t Report::n_cells() const { return std::accumulate(cells.begin(), cells.end(), std::uint64_t{0}); }

double Report::seconds() const {
  return std::accumulate(stages.begin(), stages.end(), 0.0,
                         [](double sum, const StageTime& s) { return sum + s.seconds; });
}

bool Report::is_short_of_coverage() const {
  return std::any_of(patches.begin(), patches.end(), [](const PatchReport& p) { return p.is_below_min_coverage(); });
}

std::string reasons_in_words(const quality::PatchCoverage& coverage, std::size_t most) {
  constexpr double kLeastPercentNamed = 0.05;
  std::vector<std::pair<double, std::size_t>> shares;
  for (std::size_t r = 1; r < mesh::kNLimitReasons; ++r) {
    if (coverage.limit_percent[r] >= kLeastPercentNamed) shares.emplace_back(coverage.limit_percent[r], r);
  }
  std::stable_sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string out;
  for (std::size_t i = 0; i < shares.size() && i < most; ++i) {
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", mesh::kLimitReasonNames[shares[i].second],
                       percent_in_words(shares[i].first));
  }
  if (shares.size() > most) out += ", …";
  return out;
}

std::string percent_in_words(double percent) {
  constexpr double kLargestBelowAll = 99.9;
  return fmt::format("{:.1f}", percent < 100 && percent > kLargestBelowAll ? kLargestBelowAll : percent);
}

}  // namespace nearwall
