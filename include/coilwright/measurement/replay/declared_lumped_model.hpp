#pragma once

#include <memory>
#include <span>
#include <vector>

#include "coilwright/actuator/model/lumped_model.hpp"
#include "coilwright/measurement/replay/calibration_target.hpp"

namespace coilwright::measurement::replay {

/// A declared lumped model, and the numbers of it that may be calibrated. Copies share what they have computed; every
/// member may be called from many threads at once.
class DeclaredLumpedModel {
 public:
  /// `magnetics` are those of `model`.
  DeclaredLumpedModel(actuator::LumpedModel model, actuator::LumpedMagnetics magnetics,
                      std::vector<CalibratableNumber<LumpedTarget>> numbers);

  /// What a fit must know of the numbers, in their order.
  [[nodiscard]] std::vector<CalibrationParameter> parameters() const;

  /// The model with those values (SI, one per number). Throws std::invalid_argument where they make no model.
  [[nodiscard]] actuator::ModelSpec spec_at(std::span<const double> values) const;

  /// Its numbers with those values. Throws std::invalid_argument where there are too few or too many values.
  [[nodiscard]] actuator::LumpedModel model_at(std::span<const double> values) const;

 private:
  class State;
  std::shared_ptr<State> state_;
};

}  // namespace coilwright::measurement::replay
