#pragma once

#include <span>

#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/actuator/model/model.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::identification {

/// Characteristic magnitudes of the measured motion, from the runs and the declared model.
[[nodiscard]] actuator::RigScale rig_scale(std::span<const replay::PreparedRun> runs, const actuator::Model& nominal);

/// The period in which the joint that is fastest swings by itself, s; infinite where none has a spring.
[[nodiscard]] double shortest_period(const actuator::Model& nominal);

}  // namespace coilwright::measurement::identification
