#pragma once

#include <span>

#include "coilwright/actuator/effect.hpp"
#include "coilwright/actuator/model.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::compare {

/// How large things are on this rig, from the records and the declared model.
[[nodiscard]] actuator::RigScale rig_scale(std::span<const replay::Record> records, const actuator::Model& nominal);

}  // namespace coilwright::measurement::compare
