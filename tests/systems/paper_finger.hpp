#pragma once

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/systems/validation/paper_finger.hpp"

namespace coilwright::systems {

inline const actuator::Design& finger() {
  static const actuator::Design design = validation::paper_finger();
  return design;
}

inline const actuator::Assembly& assembly() {
  static const actuator::Assembly built = actuator::assemble_or_throw(finger());
  return built;
}

}  // namespace coilwright::systems
