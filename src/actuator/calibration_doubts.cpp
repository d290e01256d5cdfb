#include "coilwright/actuator/calibration_doubts.hpp"

#include <array>

namespace coilwright::actuator {
namespace {

constexpr double plausible = 1.25;

}  // namespace

std::vector<CalibrationDoubt> calibration_doubts(const Calibration& calibration) {
  const std::array factors{
      CalibrationDoubt{.quantity = "coil length", .factor = calibration.axial_pitch},
      CalibrationDoubt{.quantity = "coil outer radius", .factor = calibration.radial_pitch},
      CalibrationDoubt{.quantity = "joint stiffness", .factor = calibration.joint_stiffness},
      CalibrationDoubt{.quantity = "joint damping", .factor = calibration.joint_damping},
      CalibrationDoubt{.quantity = "axis offset", .factor = calibration.axis_offset},
      CalibrationDoubt{.quantity = "magnet segment mass", .factor = calibration.magnet_segment_mass},
      CalibrationDoubt{.quantity = "tip segment mass", .factor = calibration.coil_segment_mass},
      CalibrationDoubt{.quantity = "tip centre of mass", .factor = calibration.tip_com},
      CalibrationDoubt{.quantity = "coil resistance", .factor = calibration.coil_resistance}};
  std::vector<CalibrationDoubt> out;
  for (const CalibrationDoubt& each : factors)
    if (each.factor > plausible || each.factor < 1.0 / plausible) out.push_back(each);
  return out;
}

}  // namespace coilwright::actuator
