#pragma once

#include <mujoco/mujoco.h>

#include "exports/torque_table.hpp"

namespace second_engine {

// Closes the scene's fingers on its object, lifts it until it slips, and prints what it found as JSON, SI.
void grip(mjModel* model, mjData* data, const Tables& tables);

}  // namespace second_engine
