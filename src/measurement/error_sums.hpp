#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "coilwright/measurement/error_comparison.hpp"

namespace coilwright::measurement {

/// Sums of the errors of finished models over all channels of one kind.
class ErrorSums {
 public:
  /// Adds one channel of one run, without the samples that it leaves out, with the standard deviations, SI, of each of
  /// its predictions due to the uncertainty of the parameters, and of what a model that is right leaves there.
  void add(const Replay& replay, const std::vector<double>& deviations, const std::vector<double>& noise);

  [[nodiscard]] ErrorComparison comparison(data::ChannelKind kind) const;

 private:
  std::array<double, 4> absolute_{}, square_{}, largest_{};  // declared, before, after, corrected
  bool has_correction_{};
  double noise_square_{};
  double uncertainty_square_{};
  std::size_t samples_{};
};

}  // namespace coilwright::measurement
