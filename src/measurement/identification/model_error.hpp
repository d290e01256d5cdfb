#pragma once

#include <span>

#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::identification {

/// Whether a model leaves more than SearchEffort::near_the_noise times the noise.
[[nodiscard]] bool is_far_from_noise(const FittedHypothesis& fitted);

/// How many times the noise a hypothesis is wrong by, as priors are to be weighed against it
/// (replay::PreparedRun::model_error): 1 near the noise, and the root of the overdispersion far from it. Against the
/// noise alone the residual of a model that is far from it is evidence of thousands of standard deviations, and
/// declared numbers, the noise of an input and the place of its edges move as far as they take up a little of it. The
/// sum that a fit makes smallest is then the quasi-likelihood with its priors (overdispersion_of() has the source).
[[nodiscard]] double model_error_of(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted);

/// Gives all runs of a fit the same model error. Fits made before do not change.
void set_model_error(std::span<replay::PreparedRun> runs, double model_error);

/// Whether two model errors are the same as far as numbers depend on them.
[[nodiscard]] bool is_same_model_error(double one, double other);

}  // namespace coilwright::measurement::identification
