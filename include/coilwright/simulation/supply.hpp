#pragma once

#include <optional>
#include <string>

#include "coilwright/simulation/quantity.hpp"

namespace coilwright::simulation {

/// "supply_load": the voltage that the supply of an operating point needs for its current, with the coils as warm as
/// the point makes them, over the voltage that it has; above 1 the current does not flow. No value where the point
/// states no voltage, or in a thermal runaway.
[[nodiscard]] const ResultQuantity& supply_load();

/// The current in every coil that `supply` drives at most through coils at 20 degC, A; nothing where it states no
/// voltage.
[[nodiscard]] std::optional<double> driven_cold(const actuator::Assembly& assembly, const actuator::Supply& supply);

/// That a supply which drives `most` A at most is asked for more, `current` A, as a sentence without its end; empty
/// where it is not, or where nothing limits it.
[[nodiscard]] std::string supply_text(const std::optional<double>& most, double current);

}  // namespace coilwright::simulation
