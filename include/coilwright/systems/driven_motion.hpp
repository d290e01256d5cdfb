#pragma once

#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/drive/coil_bank.hpp"
#include "coilwright/drive/driver.hpp"
#include "coilwright/drive/pulses.hpp"
#include "coilwright/simulation/state.hpp"
#include "coilwright/simulation/transient.hpp"
#include "coilwright/systems/driven_actuator.hpp"

namespace coilwright::systems {

/// The largest number of pulses of one driver that are followed.
inline constexpr double most_pulses = 1e5;

/// Coils on a driver whose first pulse begins at time 0.
struct MotionDrive {
  drive::CoilBank bank{};  ///< of one actuator, constant: temperatures and mutual inductances stay as they are
  drive::Driver driver{};  ///< its current limit acts as in drive::steady_current()
  drive::Pulses pulses{};
  int actuators = 1;  ///< alike, on the same driver and moving alike; >= 1. Between them there is no mutual inductance.
};

/// Duration of a motion, and the times of its samples.
struct MotionTiming {
  double duration{};  ///< s; finite, > 0
  double interval{};  ///< between samples, s; finite, > 0, at most duration
};

/// Energies since the start, all actuators, J. source = coils + switches + diodes + supply + work + growth of the
/// field.
struct MotionEnergies {
  double source{};    ///< from the supply's electromotive force, less what has returned to it
  double coils{};     ///< heat in the coils' copper
  double switches{};  ///< heat in the switches
  double diodes{};    ///< heat in the diodes
  double supply{};    ///< heat inside the supply
  double work{};      ///< done on the chains
  double field{};     ///< of the currents now: 1/2 i . L i
};

/// A motion at one time.
struct MotionSample {
  double time{};                    ///< s
  simulation::State state{};        ///< internal: of the model's own effects
  actuator::CoilCurrents currents;  ///< of an actuator's coils, A
  double driver_current{};          ///< A
  double charge{};                  ///< charge that the driver has carried since the start, A s
  MotionEnergies energies{};
};

/// Follows `model` from `start` with its coils on a driver. The current of each coil is a state; di/dt follows by the
/// inverse of the inductances from the driver's voltage, the resistances and the induced voltages, and torques and
/// induced voltages are by the same curves. Each phase of each pulse is a run of simulation::simulate_at(), which ends
/// where a diode ceases or begins to conduct or the limit trips, found by halving. Samples are those from time 0 at
/// every interval and at the end.
///
/// The approximations of drive::Driver apply; a current that motion has reversed takes the phase after a dead time at
/// once. Throws std::invalid_argument naming field, rule and value, also for a model with effects on currents or
/// magnetics, and std::runtime_error with the time if the motion leaves the model, or drives a current backwards into a
/// diode.
[[nodiscard]] std::vector<MotionSample> drive_motion(const actuator::Model& model, const MotionDrive& drive,
                                                     const MotionTiming& timing, const simulation::State& start,
                                                     const simulation::Accuracy& accuracy = {});

/// Follows a design from its rest pose without current, with the drive that drive_actuator() finds for `question`.
/// Throws std::invalid_argument also if it has no such pose.
[[nodiscard]] std::vector<MotionSample> drive_motion(const actuator::Design& design, const actuator::Assembly& assembly,
                                                     const DriveQuestion& question, const DrivenActuator& answer,
                                                     const MotionTiming& timing);

/// Figures of a motion from its samples.
struct MotionSummary {
  double duration{};           ///< s
  double start_bending{};      ///< sum of the joint angles at the first sample, rad
  double end_bending{};        ///< sum of the joint angles at the last sample, rad
  double most_bending{};       ///< largest sum of the joint angles, rad
  double most_bending_time{};  ///< s
  double most_speed{};         ///< largest sum of the rates, either way, rad/s
  double most_speed_time{};    ///< s
  MotionEnergies energies{};   ///< energies at the end
};

/// Computes the figures. Precondition: `motion` has at least one sample.
[[nodiscard]] MotionSummary summary_of(const std::vector<MotionSample>& motion);

}  // namespace coilwright::systems
