#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/thermal/network.hpp"

namespace coilwright::measurement::replay {

/// What is known of a declared number before any run is read.
struct Tolerance {
  double deviation{};  ///< one standard deviation, SI; > 0
  bool named{};        ///< whether the data set names it; otherwise it is a default
};

/// A number of the declared model that a fit may move: one that is recalibrated before a residual counts, or one that
/// is declared with a tolerance, within which it moves.
struct CalibrationParameter {
  std::string key;    ///< with its unit, as the diagnosis writes it: "joint_stiffness_Nmm_rad", "/links/0/mass_kg"
  double declared{};  ///< value in the file, SI
  double lower{};     ///< physical lower bound, SI; may be -infinity
  double upper{};     ///< physical upper bound, SI; may be infinity
  double scale{};     ///< typical change, SI; > 0 even if `declared` is 0
  std::optional<Tolerance> tolerance{};  ///< the prior of the fit; nothing: the number is free
  bool calibrated = true;                ///< whether the set calibrates it; a number that is not has a tolerance
  std::optional<double> start{};         ///< where a fit of a free number starts, SI; nothing: at the declared value
  /// Where a fit should start as well, SI: a number that does nothing beyond a limit (faces that never touch) leaves
  /// valleys on both sides of it. Nothing for most numbers.
  std::optional<double> other_start{};
  std::string_view effect{};  ///< id of the effect whose name a change of it alone bears; may be empty
  /// The function of which it is one of several coefficients, "force_curve": who measures one measures all. Empty for a
  /// number by itself.
  std::string_view function{};
};

/// The model that the user declares, with the numbers that may be recalibrated.
struct DeclaredModel {
  std::vector<CalibrationParameter> calibration;  ///< the calibrated numbers first
  /// The model with those numbers (SI, one per parameter, inside the bounds), effects that the file declares included.
  /// Pure. Throws std::invalid_argument if the numbers make no model.
  std::function<actuator::ModelSpec(std::span<const double>)> build;
  /// Declared numbers of which the diagnosis assumes that they are exact, as its report names them.
  std::vector<std::string> held_exact{};
  /// JSON pointers of those numbers of declared effects that are not among the calibration.
  std::vector<std::string> uncalibrated_effect_numbers{};
  std::optional<thermal::Network> heat{};  ///< heat paths; nothing for a lumped model
};

}  // namespace coilwright::measurement::replay
