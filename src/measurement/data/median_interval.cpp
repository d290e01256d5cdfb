#include "measurement/data/median_interval.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace coilwright::measurement::data {

double median_interval(const Run& run) {
  std::vector<double> intervals(run.times.size() - 1);
  std::ranges::transform(run.times.begin() + 1, run.times.end(), run.times.begin(), run.times.end() - 1,
                         intervals.begin(), std::minus());
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::ranges::nth_element(intervals, middle);
  return *middle;
}

}  // namespace coilwright::measurement::data
