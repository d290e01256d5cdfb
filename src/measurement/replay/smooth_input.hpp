#pragma once

#include <boost/math/interpolators/cubic_hermite.hpp>
#include <cstddef>
#include <vector>

namespace coilwright::measurement::replay {

/// A smooth input between its samples: cubics whose slopes are those of polynomials through five samples. At six
/// samples a period a sine keeps 99.6 % of its amplitude (straight lines: 91 %).
class SmoothInput {
 public:
  /// Of the samples from `first` to one before `last`, at least two; `times` in s, ascending, a row for each time.
  SmoothInput(const std::vector<double>& times, const std::vector<std::vector<double>>& rows, std::size_t first,
              std::size_t last);

  /// The row at `time`, s, between the first and the last of its samples.
  [[nodiscard]] std::vector<double> at(double time) const;

 private:
  std::vector<boost::math::interpolators::cubic_hermite<std::vector<double>>> columns_;
};

}  // namespace coilwright::measurement::replay
