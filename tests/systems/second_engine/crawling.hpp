#pragma once

#include <mujoco/mujoco.h>

#include "exports/torque_table.hpp"

namespace second_engine {

// Has the scene's robot crawl for its periods, and prints how fast it was as JSON, SI.
void crawl(mjModel* model, mjData* data, const Tables& tables);

}  // namespace second_engine
