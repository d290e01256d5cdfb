#pragma once

#include <span>

#include "coilwright/sizing/study/design_problem.hpp"

namespace coilwright::cli {

/// The design at a point that an answer recommends, evaluated anew whatever the search says of it. Throws
/// std::logic_error where it comes out other than `found`, or where that breaks a limit.
[[nodiscard]] sizing::DesignResult evaluated_again(const sizing::DesignProblem& problem, std::span<const double> point,
                                                   const sizing::Evaluation& found);

}  // namespace coilwright::cli
