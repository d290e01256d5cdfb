#pragma once

#include <optional>
#include <span>

#include "scored.hpp"

namespace coilwright::measurement {

/// The rest that a fitted hypothesis leaves, as a torque over the measured motion. Nothing where no run is a motion.
[[nodiscard]] std::optional<ResidualTorque> localise(std::span<const Record> records, const Scored& fitted);

}  // namespace coilwright::measurement
