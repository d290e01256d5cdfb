#pragma once

#include <optional>
#include <span>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"
#include "measurement/compare/staged_fit.hpp"

namespace coilwright::measurement::compare {

using CountedFit = fit::Counted<std::optional<FittedHypothesis>>;

/// A hypothesis to be extended: by one effect from the best of several initial guesses, or by all `effects` jointly.
/// Refers to the hypothesis.
struct PlannedExtension {
  const FittedHypothesis* base{};
  std::vector<actuator::Effect> effects{};
  bool joint{};

  /// The effects of the extended hypothesis, in an order that depends on nothing but the set.
  [[nodiscard]] std::vector<const actuator::EffectKind*> kinds() const;
};

/// The planned extensions, each set of effects only once: by the first extension that reaches it.
[[nodiscard]] std::vector<PlannedExtension> without_repetitions(std::vector<PlannedExtension> planned);

/// Nothing if the model cannot be simulated.
[[nodiscard]] CountedFit fit_extension(std::span<const replay::PreparedRun> runs, const PlannedExtension& planned);

/// The same effects with one of their discrete choices (a side, a warm start) changed: the choice that is better for an
/// effect alone may not be better in combination. Refers to `fitted`.
[[nodiscard]] std::vector<PlannedFit> with_other_choices(const FittedHypothesis& fitted);

}  // namespace coilwright::measurement::compare
