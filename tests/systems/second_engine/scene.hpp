// What a scene for MuJoCo tells of what is to be done with it.
#pragma once

#include <mujoco/mujoco.h>

#include <functional>
#include <string>
#include <vector>

#include "exports/torque_table.hpp"

namespace second_engine {

[[noreturn]] void fail(const std::string& what);

// Ends the program where the scene has none of that name.
int id_of(const mjModel* model, mjtObj kind, const std::string& name);
// The scene's number of that name, in the unit at its end.
double number(const mjModel* model, const std::string& name);

// A joint with a coil: where it is in the state, and its table of torque per ampere.
struct Driven {
  int position{}, rate{};
  const Table* table{};
};
// The joints whose names end with a digit, which says whose table drives them.
std::vector<Driven> driven_joints(const mjModel* model, const Tables& tables);

// Has all that acts on the bodies besides gravity, springs and contacts done by `actions`, which MuJoCo calls in every
// step with no force applied yet; MuJoCo's first warning goes to the standard error.
void act_by(std::function<void(const mjModel*, mjData*)> actions);

}  // namespace second_engine
