#include "measurement/fit/part_of_fit.hpp"

#include <cstddef>

namespace coilwright::measurement::fit {

PartOfFit part_of(std::span<const replay::PreparedRun> runs, const Fit& fitted,
                  const std::function<bool(std::size_t)>& keep) {
  PartOfFit out{.fit = {.values = fitted.values}};
  std::size_t block = 0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::size_t blocks = runs[r].sample_ranges().size();
    if (keep(r)) {
      out.runs.push_back(runs[r]);
      out.fit.runs.push_back(fitted.runs[r]);
      for (std::size_t b = 0; b < blocks; ++b) {
        out.fit.parameter_columns.push_back(fitted.parameter_columns[block + b]);
        out.fit.local_columns.push_back(fitted.local_columns[block + b]);
      }
    }
    block += blocks;
  }
  return out;
}

}  // namespace coilwright::measurement::fit
