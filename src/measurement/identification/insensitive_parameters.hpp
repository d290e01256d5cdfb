#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::identification {

/// A declared number that changes nothing where the fit has it: the closing angle of faces that touch nowhere in the
/// records.
struct InsensitiveParameter {
  Eigen::Index index{};  ///< in the hypothesis
  double nearest{};      ///< the value nearest to the declared one at which it still changes nothing, SI
};

/// Of the numbers whose prior has an end (fit::FitParameter::farthest), those beyond it that are idle.
[[nodiscard]] std::vector<InsensitiveParameter> insensitive_parameters(std::span<const replay::PreparedRun> runs,
                                                                       const FittedHypothesis& fitted);

/// As the probability of a fit, but with each idle number at its nearest value, and counted at its whole distance.
[[nodiscard]] double probability_of_declared_numbers(const FittedHypothesis& fitted,
                                                     std::span<const InsensitiveParameter> idle);

}  // namespace coilwright::measurement::identification
