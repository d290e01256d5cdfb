#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "measurement/identification/linear_screening.hpp"

namespace coilwright::measurement::identification {

/// Effects of different kinds that are tried together.
struct ScreenedCombination {
  std::vector<actuator::Effect> effects{};  ///< each at the strength that the linearisation predicts for all together
  double predicted_chi_square_fall{};
};

/// The combinations of `size` (2 or 3) screened effects with the largest fall of chi-square predicted for all together,
/// best first, at most `count`, each set of kinds once. Every combination is looked at: none of its effects need
/// explain anything by itself. One whose residual directions are nearly dependent, or in which an effect would have to
/// act against its sign, is left out.
[[nodiscard]] std::vector<ScreenedCombination> combinations_by_predicted_fall(const FittedHypothesis& base,
                                                                              std::span<const ScreenedEffect> screened,
                                                                              std::size_t size, std::size_t count);

}  // namespace coilwright::measurement::identification
