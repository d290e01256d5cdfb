#pragma once

#include <functional>

#include "coilwright/sizing/study/study.hpp"

namespace coilwright::sizing {

/// Of the currents that a variable allows, A, the one that an actuator is best driven with: the best value of the first
/// objective among those that keep all limits or, where none does, the one that is nearest to keeping them. `assess`
/// gives the evaluation of the actuator at a current.
///
/// It looks at 17 currents from end to end of the range, and then as closely between the neighbours of the best, down
/// to the steps of the range or to a thousandth of it: exact where the answer rises and falls once over the current.
[[nodiscard]] double best_current(const CurrentVariable& variable, const StudyObjective& objective,
                                  const std::function<Evaluation(double)>& assess);

}  // namespace coilwright::sizing
