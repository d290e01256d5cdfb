#pragma once

#include <functional>
#include <span>
#include <vector>

#include "coilwright/measurement/identification/posterior.hpp"
#include "measurement/identification/hypothesis_extension.hpp"
#include "measurement/identification/linear_screening.hpp"

namespace coilwright::measurement::identification {

/// What a hypothesis weighs before its evidence is taken: its prior, and Schwarz's approximation of the evidence.
struct RoughWeight {
  const std::vector<const actuator::EffectKind*>& kinds;  ///< that were compared
  std::span<const Belief> beliefs{};
  double overdispersion{};

  /// The logarithm of the weight, up to a constant.
  [[nodiscard]] double of(const FittedHypothesis& fitted) const;
  /// The same of a hypothesis with further effects, whose chi-square falls by so much.
  [[nodiscard]] double of(const FittedHypothesis& base, const std::vector<actuator::Effect>& effects,
                          double fall) const;
};

/// The hypotheses that were fitted when there is an answer, and how others are looked at.
struct FittedSoFar {
  const FittedHypothesis& before;  ///< without effects
  std::span<const FittedHypothesis> all{};
  std::span<const ScreenedEffect> screened{};                                    ///< beside `before`
  std::function<std::vector<ScreenedEffect>(const FittedHypothesis&)> screen{};  ///< effects beside another one
  RoughWeight weight;
};

/// Larger hypotheses, which count as impossible unless they are fitted: those that would hold
/// SearchEffort::least_weight of what the best weighs, by what their directions predict. They add an effect to one of
/// the best, or are the best combinations of all directions, whose parts need explain nothing alone. The heaviest
/// first, none that was fitted; they refer to the hypotheses of `so_far`.
[[nodiscard]] std::vector<PlannedExtension> larger_hypotheses_with_weight(const FittedSoFar& so_far);

}  // namespace coilwright::measurement::identification
