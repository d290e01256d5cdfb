#pragma once

#include <span>
#include <vector>

#include "coilwright/sizing/study/design_problem.hpp"

namespace coilwright::cli {

/// The design at a point that an answer recommends, evaluated anew whatever the search says of it. Throws
/// std::logic_error where it comes out other than `found`, or where that breaks a limit.
[[nodiscard]] sizing::DesignResult evaluated_again(const sizing::DesignProblem& problem, std::span<const double> point,
                                                   const sizing::Evaluation& found);

/// The same of every design of a range, each with its `point` and the `evaluation` that the search has of it.
[[nodiscard]] std::vector<sizing::DesignResult> evaluated_again(const sizing::DesignProblem& problem,
                                                                const auto& designs) {
  std::vector<sizing::DesignResult> out;
  for (const auto& each : designs) out.push_back(evaluated_again(problem, each.point, each.evaluation));
  return out;
}

}  // namespace coilwright::cli
