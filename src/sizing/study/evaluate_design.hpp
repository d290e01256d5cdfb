#pragma once

#include <functional>
#include <optional>

#include "coilwright/sizing/study/design_problem.hpp"

namespace coilwright::sizing {

/// The operating point of a design that is known to have a wire that exists.
using OperatingPointOf = std::function<actuator::OperatingPoint(const actuator::Design&, const actuator::Assembly&,
                                                                const simulation::Settings&)>;

/// A design with its performance, or why it has none: also where a design far outside all hardware breaks a rule of the
/// physics rooms that assemble() does not name, or an interpolation fails, and where `driver` cannot give the current.
/// The search goes on then.
[[nodiscard]] DesignResult evaluate_design(actuator::Design design, simulation::Settings settings,
                                           const OperatingPointOf& operating_point,
                                           const std::optional<StudyDriver>& driver);

/// The failure of a design that has no value, or none that is finite, of a quantity that is asked for.
[[nodiscard]] NotEvaluated without_value(const simulation::ResultQuantity& quantity,
                                         const simulation::DesignView& design);

}  // namespace coilwright::sizing
