#pragma once

#include <vector>

#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::measurement::replay {

/// A number of all joints as one value: their mean, to which each keeps its ratio.
struct MeanOfJoints {
  double mean{};                 ///< SI; of joints that are alike theirs to the bit
  std::vector<double> ratios{};  ///< of each joint to the mean, from the base; 1 where all are alike
};

/// That of a number of `hinges`, one at least. Ratios to a mean of 0 are NaN, unless all are alike.
[[nodiscard]] MeanOfJoints mean_of_joints(const std::vector<actuator::Hinge>& hinges, double actuator::Hinge::*member);

}  // namespace coilwright::measurement::replay
