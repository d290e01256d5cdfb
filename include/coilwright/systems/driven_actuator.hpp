#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/drive/coil_bank.hpp"
#include "coilwright/drive/driver.hpp"
#include "coilwright/drive/steady_current.hpp"

namespace coilwright::systems {

/// A battery cell with a switch.
struct CellDrive {
  drive::CellSwitch circuit{};
  std::optional<double> capacity{};      ///< A s; finite, > 0; absent: the run time is not computed
  std::optional<double> most_current{};  ///< largest current, A; finite, > 0; absent: 20 times the capacity an hour

  /// The largest current: most_current, or the usual rating of small lithium cells. Absent if neither is known.
  [[nodiscard]] std::optional<double> current_limit() const {
    return most_current || !capacity ? most_current : std::optional(20.0 * *capacity / 3600.0);
  }
};

/// The drive of an actuator, and the question about it. At least one of duty and mean current is given: the duty alone
/// asks for the current, the mean current alone for its duty, and both for the supply voltage that gives it at that
/// duty.
struct DriveQuestion {
  std::variant<drive::HBridge, CellDrive> driver{};
  drive::BankWiring wiring = drive::BankWiring::parallel;
  int actuators = 1;             ///< alike and on the same driver; >= 1. Between them there is no mutual inductance.
  double frequency = 490.0;      ///< of the pulses, Hz
  std::optional<double> duty{};  ///< 0 to 1
  std::optional<double> mean{};  ///< of the coil that carries most, A; > 0
  /// Mean temperature of every coil, degC; absent: the temperature that this drive gives when held for good.
  std::optional<double> coil_temperature = 20.0;
};

/// The highest supply voltage that is tried, V.
inline constexpr double most_supply_voltage = 1000.0;

/// Warnings about a driven actuator.
enum class DriveWarning {
  out_of_reach,      ///< the wanted mean current cannot be had
  below_voltage,     ///< the supply is below what the bridge needs
  above_voltage,     ///< the supply is above what the bridge bears
  above_peak,        ///< the peak current is more than the bridge bears
  above_cell,        ///< the peak current is more than the cell delivers
  dead_time,         ///< the pulse is shorter than the dead time: nothing is switched on
  limited,           ///< the current limit clips the current
  no_period,         ///< the limit and the pulses beat: no period is as the one before
  discontinuous,     ///< the current is zero for part of each period
  ripple,            ///< the coils have at least 5 % more heat than their mean current would make
  above_continuous,  ///< the rms current is more than can be held for good
  above_straight,    ///< it can be held for good with open joints, and not where the actuator is straight
  above_ampacity,    ///< the rms current is more than the wire's ampacity
  runaway            ///< at this rms current the coils have no steady temperature below copper's melting
};

/// The word in JSON: "out_of_reach" and so on.
[[nodiscard]] std::string_view name_of(DriveWarning warning);

/// Effect of motion on the circuit while it carries a current, for the straight actuator.
struct MotionalEffect {
  double emf_per_rate{};  ///< voltage at the driver per rate of bending with like rates of all joints, V s/rad
  /// Damping of a motion by the currents that it drives through a closed circuit, and by the joints, N m s/rad, as the
  /// sum over all joints of one actuator.
  double damping{};
  double joint_damping{};
};

/// The answer to a DriveQuestion.
struct DrivenActuator {
  double duty{};
  double supply_voltage{};               ///< of the open circuit, V
  drive::ReducedBank bank{};             ///< of all actuators
  drive::Driver phases{};                ///< the driver at that voltage
  double driver_resistance{};            ///< of switches and supply while on, ohm
  drive::SteadyCurrent driver{};         ///< of the driver; powers are those of all actuators
  drive::SteadyCurrent coil{};           ///< of the coil that carries most; without powers
  double heat_by_mean{};                 ///< heat that the coils' mean current alone would make in them, W
  double continuous_current{};           ///< rms that coils and magnets bear for good, joints at thermal_joint_angle, A
  double straight_continuous_current{};  ///< the same for the straight actuator, where coils and magnets are nearest to
                                         ///< each other, A
  double ampacity{};                     ///< of the wire, A
  Eigen::VectorXd coil_temperatures{};   ///< mean temperature of each coil of an actuator, for these figures, degC
  /// Hottest temperature of the coils when this rms current is held for good, degC; absent in a runaway. A coil that
  /// warms takes less current from a voltage; there it is an upper bound, unless coil_temperature asks for the coils'
  /// own temperature.
  std::optional<double> steady_hot_spot{};
  std::optional<double> run_time{};  ///< of the cell, s; infinite without current
  MotionalEffect motion{};
  std::vector<DriveWarning> warnings{};
};

/// Drives an assembled design. The thermal figures have the joints at actuator::thermal_joint_angle; magnets are those
/// of the model at 20 degC. Throws std::invalid_argument naming field, rule and value for an invalid question, and if
/// the coils' own temperature is asked for and copper is not solid there.
[[nodiscard]] DrivenActuator drive_actuator(const actuator::Design& design, const actuator::Assembly& assembly,
                                            const DriveQuestion& question);

}  // namespace coilwright::systems
