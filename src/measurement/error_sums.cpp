#include "measurement/error_sums.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace coilwright::measurement {

void ErrorSums::add(const Replay& replay, const std::vector<double>& deviations, const std::vector<double>& noise) {
  const std::array models{&replay.declared, &replay.before, &replay.after, &replay.corrected};
  const auto counts = [&](std::size_t i) { return replay.left_out.empty() || replay.left_out[i] == 0; };
  has_correction_ = !replay.corrected.empty();
  for (std::size_t m = 0; m < models.size() - (has_correction_ ? 0 : 1); ++m) {
    for (std::size_t i = 0; i < replay.measured.size(); ++i) {
      if (!counts(i)) continue;
      const double error = std::abs(replay.measured[i] - (*models[m])[i]);
      absolute_[m] += error;
      square_[m] += error * error;
      largest_[m] = std::max(largest_[m], error);
    }
  }
  for (std::size_t i = 0; i < replay.measured.size(); ++i) {
    if (!counts(i)) continue;
    noise_square_ += noise[i] * noise[i];
    uncertainty_square_ += deviations[i] * deviations[i];
    ++samples_;
  }
}

ErrorComparison ErrorSums::comparison(data::ChannelKind kind) const {
  const auto n = static_cast<double>(samples_);
  const auto errors = [&](std::size_t m) {
    return Errors{.mae = absolute_[m] / n, .rmse = std::sqrt(square_[m] / n), .max = largest_[m]};
  };
  return {.kind = kind,
          .samples = samples_,
          .declared = errors(0),
          .before = errors(1),
          .after = errors(2),
          .corrected = has_correction_ ? std::optional(errors(3)) : std::nullopt,
          .noise_floor_rmse = std::sqrt(noise_square_ / n),
          .uncertainty_rmse = std::sqrt(uncertainty_square_ / n)};
}

}  // namespace coilwright::measurement
