#pragma once

#include <span>

#include "measurement/fit/fit.hpp"

namespace coilwright::measurement::fit {

/// Weighs the errors of recorded inputs (replay::weigh_input_errors()) as the hypothesis lets them through at `values`,
/// with the local numbers of `fitted`, or those that their priors hold for likeliest where that is null. Does nothing
/// where all inputs are exact.
void weigh_input_errors(std::span<replay::PreparedRun> runs, const Hypothesis& hypothesis,
                        const Eigen::VectorXd& values, const Fit* fitted);

}  // namespace coilwright::measurement::fit
