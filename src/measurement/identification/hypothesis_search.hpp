#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/identification/attribution.hpp"

namespace coilwright::measurement::identification {

struct AttributionRequest {
  /// Outliers that effects uncover are set aside here, and the model error of the answer is left here.
  std::span<replay::PreparedRun> runs{};
  const replay::DeclaredModel* declared{};
  std::uint64_t seed = 1;  ///< random seed for the additional fit starts
  std::function<void(const std::string&)> progress{};
  /// Called with the recalibrated model, and again with what has been compared since (first_impressions()); may be
  /// empty.
  std::function<void(const FittedHypothesis&, const Posterior&)> known{};
  std::span<const Belief> beliefs{};
  actuator::EffectCatalogue effects = actuator::standard_effects();  ///< that the declared model may lack
};

/// Compares the declared model with every effect, then with pairs and triples of effects while structure remains, all
/// of them recalibrated. Outliers hide behind the motion that an effect makes until a model has it: where the best
/// hypothesis of a size shows more of them, they are set aside and the comparison begins anew. Throws
/// std::runtime_error if the declared model cannot be simulated.
[[nodiscard]] Attribution attribute(const AttributionRequest& request);

}  // namespace coilwright::measurement::identification
