#pragma once

#include <span>
#include <vector>

#include "measurement/compare/attribution.hpp"

namespace coilwright::measurement::compare {

/// The selected hypothesis and the order of all others.
struct Selection {
  /// One more effect at each step, up to the selected hypothesis; empty if none gains decisively on the declared model.
  std::vector<FittedHypothesis> steps{};
  std::vector<FittedHypothesis> rivals{};  ///< other hypotheses that these data cannot separate from the selected one
  std::vector<std::vector<const actuator::EffectKind*>> indistinguishable{};  ///< as Attribution has them
  std::vector<ComparedHypothesis> ranked{};                                   ///< best first
  std::vector<ComparedHypothesis> ruled_out{};
};

/// Ranks all fitted hypotheses by their quasi-BIC. If the best one gains decisively on `declared`, the recalibrated
/// declared model, the simplest of those within a decisive gain of the best is selected.
[[nodiscard]] Selection select_hypothesis(std::span<const replay::PreparedRun> runs, const FittedHypothesis& declared,
                                          std::vector<FittedHypothesis> all, double overdispersion);

}  // namespace coilwright::measurement::compare
