#include "coilwright/actuator/calibration_doubts.hpp"

#include <array>
#include <utility>

#include "coilwright/actuator/hinges.hpp"

namespace coilwright::actuator {
namespace {

constexpr double plausible = 1.25;

// Its parts have factors of their own, and that of the silicone follows the stiffness where the rest takes what is
// left.
double damping_factor(const Design& design) {
  if (!design.calibration.hinge) return 1.0;
  Design derived = design;
  derived.calibration.joint_stiffness = 1.0;
  derived.calibration.joint_damping = 1.0;
  derived.calibration.constant_damping = 1.0;
  // Both at the design's own size, each in the mode of its own stiffness.
  const auto damping = [](Design of) { return with_measured_hinge(std::move(of), {}, {}).calibration.hinge->damping; };
  const double by_laws = damping(std::move(derived));
  return by_laws > 0.0 ? damping(design) / by_laws : 1.0;
}

}  // namespace

std::vector<CalibrationDoubt> calibration_doubts(const Design& design) {
  const Calibration& calibration = design.calibration;
  const std::array factors{
      CalibrationDoubt{.quantity = "coil length", .factor = calibration.axial_pitch},
      CalibrationDoubt{.quantity = "coil outer radius", .factor = calibration.radial_pitch},
      CalibrationDoubt{.quantity = "joint stiffness", .factor = calibration.joint_stiffness},
      CalibrationDoubt{.quantity = "joint damping", .factor = damping_factor(design)},
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
