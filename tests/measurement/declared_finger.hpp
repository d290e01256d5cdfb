#pragma once

#include <string>
#include <vector>

#include "coilwright/formats/data/declared_actuator.hpp"

namespace coilwright::measurement {

/// The paper's finger as a design file declares it; stiffness and damping of the joints are calibrated.
inline const formats::DeclaredActuator& finger() {
  static const std::vector<std::string> calibrated{"joint_stiffness", "joint_damping"};
  static const formats::DeclaredActuator declared = formats::parse_declared_actuator(
      R"({"format": "actuator/1", "configuration": "B",
          "coil": {"inner_radius_mm": 3, "turns_radial": 15, "turns_axial": 30, "wire_gauge_AWG": 28},
          "magnet": {"radius_mm": 10, "length_mm": 6, "grade": "N52"},
          "body": {"gap_mm": 0.9, "bottom_layer_mm": 2.5, "side_wall_mm": 1, "bottom_wall_mm": 0.25, "top_wall_mm": 1.25,
                   "front_length_mm": 8.6, "rear_length_mm": 20, "shore_hardness_A": 28},
          "measured": {"joint_stiffness_Nmm_rad": 12.5, "joint_damping_Nmms_rad": 0.129}})",
      "finger.json", {.names = calibrated, .file = "dataset.json", .tolerances = {}});
  return declared;
}

}  // namespace coilwright::measurement
