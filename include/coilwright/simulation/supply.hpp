#pragma once

#include <optional>
#include <string>

#include "coilwright/simulation/quantity.hpp"

namespace coilwright::simulation {

/// The quantity "supply_load": the voltage that the supply of an operating point needs for its current, with the coils
/// as warm as the point makes them, over its own voltage. Above 1 the current does not flow. No value if the point
/// states no voltage, or in a thermal runaway.
[[nodiscard]] const ResultQuantity& supply_load();

/// The largest current in every coil that `supply` drives through coils at 20 degC, A; absent if it states no voltage.
[[nodiscard]] std::optional<double> driven_cold(const actuator::Assembly& assembly, const actuator::Supply& supply);

/// A warning, a sentence without its end, that a supply which drives at most `most` A is asked for `current` A; empty
/// if it is not, or if nothing limits it.
[[nodiscard]] std::string supply_text(const std::optional<double>& most, double current);

}  // namespace coilwright::simulation
