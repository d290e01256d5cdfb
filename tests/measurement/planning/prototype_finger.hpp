#pragma once

#include <string>
#include <vector>

#include "coilwright/formats/data/declared_actuator.hpp"

namespace coilwright::measurement::planning {

/// A finger of the prototype's parts as a file declares it; stiffness and damping of the joints are calibrated.
inline const formats::DeclaredActuator& finger() {
  static const std::vector<std::string> calibrated{"joint_stiffness", "joint_damping"};
  static const formats::DeclaredActuator declared =
      formats::parse_declared_actuator(R"({"format": "actuator/1", "configuration": "B"})", "finger.json",
                                       {.names = calibrated, .file = "dataset.json", .tolerances = {}});
  return declared;
}

}  // namespace coilwright::measurement::planning
