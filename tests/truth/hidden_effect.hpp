#pragma once

#include <string>
#include <vector>

namespace truth {

/// A hidden effect with its numbers.
struct HiddenEffect {
  struct Number {
    std::string key;
    double value{};  ///< in the key's unit
  };
  std::string id;
  bool outsider = false;
  std::vector<Number> numbers;
  double asked{};           ///< strength that was drawn; 0 for an effect without numbers, and for one at its bound
  double share_of_bound{};  ///< 0 is absent, 1 the physical bound
  double strength{};  ///< rms deviation from the motion without it over the noise, in the fit run where it is largest
  /// The same after stiffness and damping of the declared model have been fitted (to first order).
  double strength_after_calibration{};
  /// Whether that is visible in the noise: at least six standard deviations over all samples of the fit runs together.
  bool visible = false;
  /// In a set of the laboratory: the same standard deviations that are left when the numbers of the declared model move
  /// within their tolerances, and the clocks within theirs, as suits best (in white noise).
  double evidence{};
  std::vector<std::string> confounders{};  ///< ids of effects that fit these data as well; empty unless searched
};

}  // namespace truth
