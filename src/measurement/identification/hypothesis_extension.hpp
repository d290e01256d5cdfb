#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"
#include "measurement/identification/linear_screening.hpp"
#include "measurement/identification/staged_fit.hpp"

namespace coilwright::measurement::identification {

/// Effects to be added to a hypothesis: one or several of the same kinds, from each of several starts. Refers to the
/// hypothesis.
struct PlannedExtension {
  const FittedHypothesis* base{};
  std::vector<std::vector<actuator::Effect>> starts{};  ///< at least one
  /// Tried from the declared numbers where a fit from `starts` does not show what the effect can do: see
  /// from_other_starts.
  std::vector<std::vector<actuator::Effect>> further_starts{};
  /// The fall of chi-square that its screening predicts; infinite where nothing is known of it.
  double predicted_fall = std::numeric_limits<double>::infinity();

  /// The effects of the extended hypothesis, in an order that depends on nothing but the set.
  [[nodiscard]] std::vector<const actuator::EffectKind*> kinds() const;
};

/// The extension of `base` by one effect from the starts that its screening promises most of, with at most `own`
/// further starts, of the strengths of the effect's guesses; none for an effect of one number.
[[nodiscard]] PlannedExtension one_more(const FittedHypothesis& base, const actuator::EffectKind* kind,
                                        std::span<const ScreenedEffect> screened, std::size_t own);

}  // namespace coilwright::measurement::identification
