#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/actuator/model.hpp"
#include "coilwright/thermal/network.hpp"

namespace coilwright::measurement::replay {

/// A number of the declared model that may be fitted anew before a residual counts.
struct CalibrationParameter {
  std::string key;           ///< as the diagnosis writes it: "joint_stiffness_Nmm_rad", "/links/0/mass_kg"
  double declared{};         ///< as written in the file, SI
  double lower{};            ///< physical bounds, SI; may be infinite
  double upper{};            ///< SI
  double scale{};            ///< how large a change of it is usual, SI; > 0 also where `declared` is 0
  double denominator = 1.0;  ///< SI value = value in the key's unit / denominator
};

/// The model that somebody believes in, with the numbers that may move.
struct DeclaredModel {
  std::vector<CalibrationParameter> calibration;
  /// The model with those numbers (SI, one per parameter, inside the bounds). Pure. Throws std::invalid_argument where
  /// they make no model. Effects that the file itself declares are in it.
  std::function<actuator::ModelSpec(std::span<const double>)> build;
  std::vector<std::string> held_effects{};  ///< numbers of declared effects that are not in the calibration: pointers
  std::optional<thermal::Network> heat{};   ///< heat paths; nothing for a lumped model
};

}  // namespace coilwright::measurement::replay
