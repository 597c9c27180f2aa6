#include "nearwall/pipeline/report.h"

#include <algorithm>
#include <numeric>

namespace nearwall {

std::uint64_t Report::n_cells() const { return std::accumulate(cells.begin(), cells.end(), std::uint64_t{0}); }

double Report::seconds() const {
  return std::accumulate(stages.begin(), stages.end(), 0.0,
                         [](double sum, const StageTime& s) { return sum + s.seconds; });
}

bool Report::is_short_of_coverage() const {
  return std::any_of(patches.begin(), patches.end(), [](const PatchReport& p) { return p.is_below_min_coverage(); });
}

}  // namespace nearwall
