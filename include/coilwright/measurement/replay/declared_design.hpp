#pragma once

#include <memory>
#include <span>
#include <vector>

#include "coilwright/actuator/calibrate.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/measurement/replay/calibration_target.hpp"

namespace coilwright::measurement::replay {

/// A declared design, and the numbers of it that may be calibrated. Copies share what they have computed; every member
/// may be called from many threads at once.
class DeclaredDesign {
 public:
  /// `measured` are the values from which the calibration factors of `design` followed; `assembled` is the nominal
  /// model of `design` without its `as_built`.
  DeclaredDesign(actuator::Design design, actuator::Measured measured, actuator::ModelSpec assembled,
                 std::vector<CalibratableNumber<DesignTarget>> numbers);

  /// What a fit must know of the numbers, in their order.
  [[nodiscard]] std::vector<CalibrationParameter> parameters() const;

  /// The model with those values (SI, one per number). Throws std::invalid_argument where they make no model.
  [[nodiscard]] actuator::ModelSpec spec_at(std::span<const double> values) const;

  /// The design with those values. Its hinges' numbers become calibration factors, which round. Throws as spec_at().
  [[nodiscard]] actuator::Design design_at(std::span<const double> values) const;

 private:
  class State;
  std::shared_ptr<State> state_;
};

}  // namespace coilwright::measurement::replay
