#pragma once

#include <optional>

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::actuator {

/// Values that were measured on a built actuator, SI; those that were not measured are absent. The symbols of the
/// paper's Table II are in brackets.
struct Measured {
  std::optional<double> coil_outer_radius{};    ///< (R_c), m
  std::optional<double> coil_length{};          ///< (l_c), m
  std::optional<double> joint_stiffness{};      ///< (k), N m/rad, mean of the joints
  std::optional<double> joint_damping{};        ///< (b), N m s/rad
  std::optional<double> axis_offset{};          ///< (h), m
  std::optional<double> magnet_segment_mass{};  ///< (m_1), kg; of a segment that is not the last
  std::optional<double> tip_segment_mass{};     ///< (m_2), kg; of a last segment with a coil, front part included
  std::optional<double> tip_com{};              ///< (l_2), m; centre of mass of the last segment from its joint
  std::optional<double> coil_resistance{};      ///< of one coil at 20 degC, ohm
  std::optional<double> continuous_current{};   ///< largest current held for hours in every coil, A
  /// Angle of every joint while that current was held, rad, 0 to pi. If it is absent, thermal_joint_angle is taken.
  std::optional<double> continuous_current_joint_angle{};
};

/// Returns the factors measured over derived, at the geometry of `design`, whose own calibration is ignored. A derived
/// value times its factor is the measured value to rounding. Throws std::invalid_argument naming the value if it is not
/// finite and > 0 or if the design has no such part, and with the first fault of a design that cannot be built.
[[nodiscard]] Calibration calibrate(Design design, const Measured& measured);

}  // namespace coilwright::actuator
