#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/measurement/compare/estimate.hpp"
#include "measurement/compare/attribution.hpp"

namespace coilwright::measurement::compare {

/// An attribution without the effects that the data do not support.
struct PrunedAttribution {
  Attribution attribution{};
  std::vector<Evidence> evidence{};   ///< of each step after the first
  std::vector<Estimate> estimates{};  ///< of the last step, as estimated() has them
  double overdispersion{};            ///< of the last step
};

/// Removes effects, the last first, that gain or explain too little (DecisionThresholds), make runs worse that were
/// left out, or have an interval that contains the value at which the effect is absent. What is left is fitted anew
/// where it leaves much more or less than the removed effect did (with_settled_model_error()).
[[nodiscard]] PrunedAttribution prune_unsupported_effects(std::span<replay::PreparedRun> runs, Attribution attribution,
                                                          const std::function<void(const std::string&)>& progress = {});

}  // namespace coilwright::measurement::compare
