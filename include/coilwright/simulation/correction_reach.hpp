#pragma once

#include <span>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/simulation/performance.hpp"
#include "coilwright/simulation/state.hpp"

namespace coilwright::simulation {

/// One variable of a nameless correction of the torque: where the correction was measured, and where it is used.
struct CorrectionReach {
  actuator::CorrectionVariable variable{};
  double measured_from{};  ///< SI
  double measured_to{};
  double used_from{};  ///< of all joints that have it
  double used_to{};
  /// Whether it is used where nothing was measured, and fades to nothing.
  [[nodiscard]] bool is_beyond() const { return used_from < measured_from || used_to > measured_to; }
};

/// Of a motion: its states, and the commanded currents (A) at each. Empty for a model without a correction.
[[nodiscard]] std::vector<CorrectionReach> correction_reach(const actuator::Model& model, std::span<const State> states,
                                                            std::span<const actuator::CoilCurrents> currents);

/// Of a step of the current (A) from rest: the joints' angles at rest, at the end and at their peak; of their rates
/// only what the peak of the bending speed makes of the mean joint.
[[nodiscard]] std::vector<CorrectionReach> correction_reach(const actuator::Model& model, const FreeMotion& motion,
                                                            double current);

}  // namespace coilwright::simulation
