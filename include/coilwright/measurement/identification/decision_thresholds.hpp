#pragma once

namespace coilwright::measurement::identification {

/// The constants of what the search tries further and of which declared numbers are off.
struct DecisionThresholds {
  /// A smaller gain of the quasi-BIC decides nothing: odds of 20 to 1 (Kass and Raftery 1995, "strong").
  double decisive_gain = 6.0;
  /// Declared numbers that so few of the rigs built to their tolerances would have are off.
  double least_probability = 0.01;
  /// What has a smaller standard deviation, over that of the noise, changes nothing that anyone would see.
  double least_over_noise = 0.1;
  /// Where what is left is no noise, what takes away less than this share of its squares is no answer to it.
  double least_share = 0.05;
};
inline constexpr DecisionThresholds decision_thresholds{};

}  // namespace coilwright::measurement::identification
