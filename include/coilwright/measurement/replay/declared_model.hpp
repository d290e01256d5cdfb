#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/thermal/network.hpp"

namespace coilwright::measurement::replay {

/// A number of the declared model that may be recalibrated before its residual is judged.
struct CalibrationParameter {
  std::string key;    ///< with its unit, as the diagnosis writes it: "joint_stiffness_Nmm_rad", "/links/0/mass_kg"
  double declared{};  ///< value in the file, SI
  double lower{};     ///< physical lower bound, SI; may be -infinity
  double upper{};     ///< physical upper bound, SI; may be infinity
  double scale{};     ///< typical change, SI; > 0 even if `declared` is 0
};

/// The model that the user declares, with the numbers that may be recalibrated.
struct DeclaredModel {
  std::vector<CalibrationParameter> calibration;
  /// The model with those numbers (SI, one per parameter, inside the bounds), effects that the file declares included.
  /// Pure. Throws std::invalid_argument if the numbers make no model.
  std::function<actuator::ModelSpec(std::span<const double>)> build;
  /// JSON pointers of those numbers of declared effects that are not among the calibration.
  std::vector<std::string> uncalibrated_effect_numbers{};
  std::optional<thermal::Network> heat{};  ///< heat paths; nothing for a lumped model
};

}  // namespace coilwright::measurement::replay
