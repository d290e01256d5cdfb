#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/systems/driven_actuator.hpp"
#include "coilwright/systems/driven_motion.hpp"
#include "coilwright/thermal/network.hpp"

namespace coilwright::systems {

/// The largest number of samples of one warm-up.
inline constexpr double most_warm_up_samples = 1e6;

/// State of a driven actuator at one time while it warms.
struct WarmUpSample {
  double time{};                      ///< since the drive was switched on, s
  Eigen::VectorXd coil_temperatures;  ///< mean of each coil of an actuator, base to tip, degC
  double coil_hot_spot{};             ///< hottest place of any coil, degC
  double magnet_temperature{};        ///< of the warmest magnet, degC; that of the surroundings if there is none
  double resistance{};                ///< of all coils as the driver sees them, ohm
  double mean{};                      ///< current of the coil that carries most, A
  double rms{};                       ///< rms current of that coil, A
  double supply_mean{};               ///< current that the supply delivers, A
  double heat{};                      ///< of the coils of one actuator, W
};

/// The first part that passes its limit.
struct PassedLimit {
  double time{};             ///< s
  thermal::NodeKind kind{};  ///< coil or magnet
  int number{};              ///< among the actuator's parts of that kind, base to tip, from 1
  double limit{};            ///< degC
};

/// Temperatures and currents of a driven actuator while it warms.
struct WarmUp {
  std::vector<WarmUpSample> samples{};   ///< from time 0 at every interval and at the end, which is before the melting
  std::optional<PassedLimit> limit{};    ///< absent if no part passes its limit
  std::optional<double> melting_time{};  ///< time at which a coil's copper would melt, s; absent if it does not
};

/// Temperatures of a design's parts from those of its surroundings on, with the duty and the voltage of `answer`
/// (drive_actuator() of `question`) held: C dT/dt = q - G (T - Ta). Each coil makes the heat q of its share of the
/// current in the driver's periodic steady state at the present resistances, so under a voltage the current falls as
/// the coils warm. Joints are at actuator::thermal_joint_angle.
///
/// Left out are the transients of current (some L/R, under 1 ms) and motion (some 0.1 s), which end before anything
/// warms (a coil of the prototype by 0.9 K/s at 1.4 A), and the smaller torque of warm magnets. Throws
/// std::invalid_argument naming field, rule and value, also for effects on currents.
[[nodiscard]] WarmUp warm_up(const actuator::Design& design, const actuator::Assembly& assembly,
                             const DriveQuestion& question, const DrivenActuator& answer, const MotionTiming& timing);

}  // namespace coilwright::systems
