#pragma once

#include <span>
#include <string>

#include "coilwright/sizing/study/design_problem.hpp"

namespace coilwright::cli {

/// The design of a study at a point as an actuator file (actuator/1) under that name, with the operating point at which
/// it was judged. It is evaluated for that, and has no operating point if it cannot be.
[[nodiscard]] std::string design_text(const sizing::DesignProblem& problem, std::span<const double> point,
                                      const std::string& name);

}  // namespace coilwright::cli
