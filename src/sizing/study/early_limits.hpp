#pragma once

#include <functional>

#include "coilwright/sizing/study/study.hpp"

namespace coilwright::sizing {

/// Whether a design at a current (A; NaN where that is not known yet) breaks a limit of a study whatever a simulation
/// would find.
using BreaksEarlyLimit = std::function<bool(const actuator::Design& design, double current)>;

/// That of `study`: its limits on mass, dimensions, current, and resistance, voltages and power of cold coils follow
/// from the shape and the winding. Hot coils are at least as warm as the surroundings and, where the study limits their
/// heat, at most as that allows: a limit on their resistance, voltage or power is broken early where no temperature
/// between keeps it. Empty where no limit can be told early. False for a design that cannot be built.
[[nodiscard]] BreaksEarlyLimit early_limits(const Study& study);

}  // namespace coilwright::sizing
