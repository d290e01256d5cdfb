#pragma once

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/mechanics/joint_vector.hpp"
#include "coilwright/thermal/network.hpp"

namespace coilwright::actuator {

/// Angle of every joint if no case gives its own, rad: 30 degrees. The prototype works there at its continuous current
/// (57 degrees over two joints at 1.05 A). The posture matters: at 0, 30 and 60 degrees the continuous current of the
/// prototype's coils is 1.067, 1.100 and 1.132 A and that of its magnet 0.96, 1.78 and 1.98 A, because only its
/// neighbours heat the magnet.
inline constexpr double thermal_joint_angle = 30.0 * 3.14159265358979323846 / 180.0;

/// Thermal network of an assembled design: the nodes of its components, base to tip, then those of the silicone.
/// `joint_angle` is the angle of every joint, rad, >= 0.
[[nodiscard]] thermal::Network heat_network(const Design& design, const Assembly& assembly,
                                            double joint_angle = thermal_joint_angle);

/// The network with each joint at its own angle, rad, base to tip, as in a finger that moves freely or grips. A joint
/// that is pressed closed counts as 0. Throws std::invalid_argument unless there is a finite angle for each joint.
[[nodiscard]] thermal::Network heat_network(const Design& design, const Assembly& assembly,
                                            const mechanics::JointVector& joint_angles);

/// The network in still air: the film is still_air_film() instead of the calibrated heat transfer.
[[nodiscard]] thermal::Network still_air_network(const Design& design, const Assembly& assembly,
                                                 const mechanics::JointVector& joint_angles);

/// Temperature of the hottest place of the body's outer surface, degC, where a hand or an object touches it:
/// thermal::skin_temperature() for `temperatures` of the nodes of heat_network() with the same arguments. Throws as
/// those do.
[[nodiscard]] double skin_temperature(const Design& design, const Assembly& assembly,
                                      const mechanics::JointVector& joint_angles,
                                      const thermal::NodeVector& temperatures);

/// The calibrated film coefficient of the surroundings, W/(m^2 K).
[[nodiscard]] double calibrated_film(const Design& design);

/// The film coefficient of still air, W/(m^2 K): natural convection and radiation from a surface as high as the
/// cross-section, at its temperature in that film while the first coil or magnet is at its limit. At a quarter of that
/// heat the film is up to a fifth lower and the rise as much higher than this value says; above the limit it is the
/// reverse.
[[nodiscard]] double still_air_film(const Design& design, const Assembly& assembly,
                                    const mechanics::JointVector& joint_angles);

}  // namespace coilwright::actuator
