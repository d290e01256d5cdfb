#pragma once

#include <span>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/simulation/performance.hpp"
#include "coilwright/simulation/state.hpp"

namespace coilwright::simulation {

/// One variable of a nameless correction of the torque: the range in which the correction was measured, and the range
/// in which it is used.
struct CorrectionReach {
  actuator::CorrectionVariable variable{};
  double measured_from{};  ///< SI
  double measured_to{};
  double used_from{};  ///< range in all joints that have the correction
  double used_to{};
  /// Whether the correction is used beyond the range of its measurement, where it fades to nothing.
  [[nodiscard]] bool is_beyond() const { return used_from < measured_from || used_to > measured_to; }
};

/// The ranges in a motion, from its states and the commanded currents (A) at each. Empty for a model without a
/// correction.
[[nodiscard]] std::vector<CorrectionReach> correction_reach(const actuator::Model& model, std::span<const State> states,
                                                            std::span<const actuator::CoilCurrents> currents);

/// The ranges in a step of the current (A) from rest: the joints' angles at rest, at the end and at their peak, and the
/// rate of the mean joint at the peak of the bending speed.
[[nodiscard]] std::vector<CorrectionReach> correction_reach(const actuator::Model& model, const FreeMotion& motion,
                                                            double current);

}  // namespace coilwright::simulation
