#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/measurement/diagnosis.hpp"

namespace coilwright::measurement {

/// What a diagnosis leaves of the numbers of a design: normal about the corrected ones, together.
struct DesignPosterior {
  /// One number of the corrected design.
  struct Number {
    std::string name;  ///< of a parameter of designs, or as actuator::effect_number_name()
    double value{};    ///< in the unit of the name, as is the next
    double sd{};       ///< standard deviation; > 0
  };
  std::vector<Number> numbers;
  Eigen::MatrixXd correlation;  ///< (numbers, numbers)
};

/// The posterior of `diagnosis` in the numbers of its corrected design, which `updated` gives for values of the fit as
/// measurement::calibration_of() and effects_of() have them: linear about those that were found. What the records do
/// not determine, and how the measured finger deviates from its own design, is not in it.
[[nodiscard]] DesignPosterior design_posterior(
    const Diagnosis& diagnosis,
    const std::function<actuator::Design(std::span<const double>, const std::vector<actuator::Effect>&)>& updated);

}  // namespace coilwright::measurement
