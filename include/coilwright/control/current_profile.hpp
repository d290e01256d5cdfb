#pragma once

#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/simulation/model_input.hpp"

namespace coilwright::control {

/// One current in every coil over time. Before time 0 it has been `before` for a long time, and each level holds until
/// the next.
struct CurrentProfile {
  double before{};               ///< A
  std::vector<double> times{};   ///< s, the first 0, increasing
  std::vector<double> levels{};  ///< A, levels[i] from times[i] on; the last one holds for good

  [[nodiscard]] double last() const { return levels.back(); }  ///< A, the last level
};

/// Converts `profile` to the input of a model, up to `duration` (s, beyond the last of its times). Throws
/// std::invalid_argument for a profile that breaks its rules.
[[nodiscard]] simulation::ModelInput input_of(const actuator::Model& model, const CurrentProfile& profile,
                                              double duration);

}  // namespace coilwright::control
