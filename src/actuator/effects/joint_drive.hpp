#pragma once

#include <optional>
#include <string>

#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/actuator/parts/magnetic_stage.hpp"

namespace coilwright::actuator::effects {

/// Why a model's joints have no motor with a shaft, bearings and gear: a coil and a magnet act across one of them.
/// Nothing where the drives are torques over current or torques as such.
[[nodiscard]] std::optional<std::string> without_shafts(const ModelSpec& spec);

}  // namespace coilwright::actuator::effects
