#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "coilwright/sizing/study/design_problem.hpp"

namespace coilwright::cli {

/// The design at a point that an answer recommends, evaluated anew whatever the search says of it. Throws
/// std::logic_error where it comes out other than `found`.
[[nodiscard]] sizing::DesignResult evaluated_again(const sizing::DesignProblem& problem, std::span<const double> point,
                                                   const sizing::Evaluation& found);

/// The same of every design of a range, each with its `point` and the `evaluation` that the search has of it, which
/// must break no limit.
[[nodiscard]] std::vector<sizing::DesignResult> evaluated_again(const sizing::DesignProblem& problem,
                                                                const auto& designs) {
  std::vector<sizing::DesignResult> out;
  for (const auto& each : designs) {
    if (!sizing::is_feasible(each.evaluation)) throw std::logic_error("a design that breaks a limit is recommended");
    out.push_back(evaluated_again(problem, each.point, each.evaluation));
  }
  return out;
}

/// The design of a study at a point as an actuator file (actuator/1) under that name, with the operating point at which
/// it was judged: none where `result`, its evaluation, has none.
[[nodiscard]] std::string design_text(const sizing::DesignProblem& problem, std::span<const double> point,
                                      const sizing::DesignResult& result, const std::string& name);

}  // namespace coilwright::cli
