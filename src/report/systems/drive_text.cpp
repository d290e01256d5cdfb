#include "coilwright/report/systems/drive_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <variant>

#include "coilwright/report/simulation/percent.hpp"
#include "coilwright/report/simulation/text_table.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::report {
namespace {

using systems::DrivenActuator;
using systems::DriveQuestion;
using systems::DriveWarning;
using enum TextTable::Align;

std::string number(double value) {
  return fmt::format("{:.5g}", value);
}

bool is_cell(const DriveQuestion& question) {
  return std::holds_alternative<systems::CellDrive>(question.driver);
}

std::string setting_text(const DrivenActuator& driven, const DriveQuestion& question) {
  const auto* bridge = std::get_if<drive::HBridge>(&question.driver);
  const std::string decay = bridge == nullptr                     ? ""
                            : bridge->decay == drive::Decay::slow ? ", slow decay"
                                                                  : ", fast decay";
  const Eigen::Index coils = driven.bank.shares.size();
  const std::string wiring = question.wiring == drive::BankWiring::series ? "series" : "parallel";
  return fmt::format("{} of {} V, {}, {} Hz{}, coils at {} degC\n",
                     is_cell(question) ? "Cell with a switch" : "H-bridge", number(driven.supply_voltage),
                     coils == 1 ? std::string("1 coil") : fmt::format("{} coils in {}", coils, wiring),
                     number(question.frequency), decay, number(driven.coil_temperatures.maxCoeff()));
}

std::string asked_text(const DrivenActuator& driven, const DriveQuestion& question) {
  const std::string gives = fmt::format("{} A of mean current in a coil.\n", number(driven.coil.mean));
  const bool reached = driven.warnings.empty() || driven.warnings.front() != DriveWarning::out_of_reach;
  if (question.mean && question.duty && reached)
    return fmt::format("{} V at duty {} give {}", number(driven.supply_voltage), number(driven.duty), gives);
  return fmt::format("Duty {} gives {}", number(driven.duty), gives);
}

std::string currents_text(const DrivenActuator& driven) {
  TextTable table;
  table.row({"current A", "mean", "rms", "peak", "valley", "ripple"});
  const auto row = [&](const char* name, const drive::SteadyCurrent& current) {
    table.row({name, number(current.mean), number(current.rms), number(current.peak), number(current.valley),
               number(current.ripple())});
  };
  row("coil", driven.coil);
  row("driver", driven.driver);
  return table.text(2, {left}) +
         fmt::format("  The supply delivers {} A on average.\n", number(driven.driver.supply_mean));
}

std::string powers_text(const DrivenActuator& driven) {
  const drive::DrivePowers& powers = driven.driver.powers;
  TextTable table;
  table.row({"power W", ""});
  table.row({"from the supply", number(powers.source)});
  table.row({"heat of all coils", number(powers.coils)});
  table.row({"as their mean current suggests", number(driven.heat_by_mean)});
  table.row({"heat of switches and diodes", number(powers.switches + powers.diodes)});
  table.row({"heat inside the supply", number(powers.supply)});
  return table.text(2, {left});
}

std::string circuit_text(const DrivenActuator& driven) {
  const drive::Circuit& circuit = driven.bank.circuit;
  const systems::MotionalEffect& motion = driven.motion;
  std::string out =
      fmt::format("The coils are {} Ohm and {} mH together, L/R {} ms; the driver adds {} Ohm while on.\n",
                  number(circuit.resistance), number(circuit.inductance * 1e3), number(circuit.time_constant() * 1e3),
                  number(driven.driver_resistance));
  out += fmt::format(
      "Straight and with every joint opening at 1 rad/s they induce {} mV; the closed circuit adds {} Nmms/rad of "
      "damping to {} of the joints.\n",
      number(motion.emf_per_rate * 1e3), number(units::from_memory(motion.damping, "damping_Nmms_rad")),
      number(units::from_memory(motion.joint_damping, "damping_Nmms_rad")));
  const std::string held = fmt::format(
      "{} A rms in a coil can be held for good with every joint at 30 deg, {} A where the actuator is straight",
      number(driven.continuous_current), number(driven.straight_continuous_current));
  out += driven.steady_hot_spot ? fmt::format("{}; these {} A bring the hottest turn to {} degC.\n", held,
                                              number(driven.coil.rms), number(*driven.steady_hot_spot))
                                : held + ".\n";
  if (driven.run_time)
    out += std::isfinite(*driven.run_time) ? fmt::format("The cell lasts {} min.\n", number(*driven.run_time / 60.0))
                                           : std::string("The cell is not discharged, as nothing flows.\n");
  return out;
}

// What would bring a current that is out of reach nearer.
std::string remedy(const DrivenActuator& driven, const DriveQuestion& question) {
  if (driven.driver.is_limited) return "Raise --current-limit-A.";
  if (question.duty) return "Raise --duty.";
  const std::string series = question.wiring == drive::BankWiring::series ? ", or take --wiring parallel" : "";
  return fmt::format("Raise {}{}.", is_cell(question) ? "--cell-voltage-V" : "--supply-voltage-V", series);
}

// What takes the peak of a bridge down: its ripple, where that is what is too much, or the current of many coils.
std::string lower_peak(const DrivenActuator& driven, const DriveQuestion& question) {
  const auto& bridge = std::get<drive::HBridge>(question.driver);
  if (driven.driver.rms < bridge.ratings.peak_current && driven.driver.ripple() > 0.1 * driven.driver.peak &&
      !bridge.trip)
    return "A higher --frequency-Hz has less ripple, and --current-limit-A cuts the peaks.";
  if (question.wiring == drive::BankWiring::parallel && driven.bank.shares.size() > 1)
    return "--wiring series carries the current of one coil, on more voltage.";
  return "A smaller duty or voltage takes less.";
}

// A limit that does not look while it is blanked does not hold a current that rises by more in that time than it falls
// in the off-time.
std::string current_limit_text(const DrivenActuator& driven, const drive::HBridge& bridge) {
  if (driven.driver.mean <= *bridge.trip)
    return "The current limit acts: peaks are clipped, a larger voltage gives little more, and the mean current is not "
           "in proportion to the duty.";
  return fmt::format(
      "The current limit does not hold: it does not look for {} us after switching on (--limit-blanking-us), in which "
      "the current rises by more than it falls in {} us (--limit-off-time-us), and the driver's mean of {} A is above "
      "its {} A (--current-limit-A). A lower --supply-voltage-V or a longer off-time lets it hold.",
      number(bridge.limit_blanking * 1e6), number(bridge.limit_off_time * 1e6), number(driven.driver.mean),
      number(*bridge.trip));
}

std::string sentence(DriveWarning warning, const DrivenActuator& driven, const DriveQuestion& question) {
  switch (warning) {
    case DriveWarning::out_of_reach:
      return fmt::format("{} A of mean current are out of reach: {} V at duty {} give {} A. {}", number(*question.mean),
                         number(driven.supply_voltage), number(driven.duty), number(driven.coil.mean),
                         remedy(driven, question));
    case DriveWarning::below_voltage:
      return fmt::format(
          "The supply of {} V is below the {} V from which the bridge works (--bridge-lowest-V): it switches nothing "
          "on.",
          number(driven.supply_voltage), number(std::get<drive::HBridge>(question.driver).ratings.lowest_voltage));
    case DriveWarning::above_voltage:
      return fmt::format("The supply of {} V is above the {} V that the bridge bears (--bridge-highest-V).",
                         number(driven.supply_voltage),
                         number(std::get<drive::HBridge>(question.driver).ratings.highest_voltage));
    case DriveWarning::above_peak:
      return fmt::format(
          "The driver's peak of {} A is above the {} A that the bridge bears (--bridge-peak-A): it switches itself "
          "off. {}",
          number(driven.driver.peak), number(std::get<drive::HBridge>(question.driver).ratings.peak_current),
          lower_peak(driven, question));
    case DriveWarning::above_cell: {
      const auto& cell = std::get<systems::CellDrive>(question.driver);
      return fmt::format(
          "The peak of {} A is above the {} A that the cell delivers ({}): its voltage breaks down.",
          number(driven.driver.peak), number(*cell.current_limit()),
          cell.most_current ? "--cell-limit-A" : "20 times its capacity an hour; --cell-limit-A says otherwise");
    }
    case DriveWarning::dead_time:
      return "The pulse is shorter than the dead time, so that nothing is switched on: raise --duty or lower "
             "--frequency-Hz.";
    case DriveWarning::limited:
      return current_limit_text(driven, std::get<drive::HBridge>(question.driver));
    case DriveWarning::no_period:
      return "Pulses and current limit beat: no period is like the one before, and the figures are means of 1000.";
    case DriveWarning::discontinuous:
      return fmt::format(
          "The current is discontinuous: it is zero for {} of each period, and its mean is not in proportion to the "
          "duty.",
          percent(1.0 - driven.driver.conduction));
    case DriveWarning::ripple:
      return fmt::format(
          "The coils get {} more heat than their mean current suggests: a higher --frequency-Hz has less ripple.",
          percent(driven.driver.powers.coils / driven.heat_by_mean - 1.0));
    case DriveWarning::above_continuous:
      return fmt::format("The rms current of {} A is above the continuous current of {} A: do not hold it for good.",
                         number(driven.coil.rms), number(driven.continuous_current));
    case DriveWarning::above_straight:
      return fmt::format(
          "The rms current of {} A can be held for good with every joint at 30 deg, and not where the actuator is "
          "straight or closed on an object ({} A straight): there coils heat the magnets more. evaluate tells both "
          "poses.",
          number(driven.coil.rms), number(driven.straight_continuous_current));
    case DriveWarning::above_ampacity:
      return fmt::format("The rms current of {} A is above the ampacity of the wire, {} A.", number(driven.coil.rms),
                         number(driven.ampacity));
    case DriveWarning::runaway:
      return "Held at this rms current the coils have no steady temperature: copper melts first.";
  }
  return {};
}

}  // namespace

std::string to_text(const DrivenActuator& driven, const DriveQuestion& question) {
  std::string out = setting_text(driven, question) + asked_text(driven, question) + currents_text(driven) +
                    powers_text(driven) + circuit_text(driven);
  for (const DriveWarning warning : driven.warnings) out += sentence(warning, driven, question) + '\n';
  return out;
}

std::string to_text(const systems::MotionSummary& motion) {
  const auto degrees = [](double angle) { return fmt::format("{:.2f}", units::from_memory(angle, "angle_deg")); };
  const systems::MotionEnergies& energy = motion.energies;
  return fmt::format(
      "Pulses from rest for {} s: bending {} deg before, {} deg at the end, at most {} deg at {} s; at most {:.5g} "
      "deg/s at {} s.\n"
      "Of {} J from the supply {} J heat the coils, {} J switches and diodes, {} J the supply itself; {} J move the "
      "actuator, {} J are left in the coils' field.\n",
      number(motion.duration), degrees(motion.start_bending), degrees(motion.end_bending), degrees(motion.most_bending),
      number(motion.most_bending_time), units::from_memory(motion.most_speed, "speed_deg_s"),
      number(motion.most_speed_time), number(energy.source), number(energy.coils),
      number(energy.switches + energy.diodes), number(energy.supply), number(energy.work), number(energy.field));
}

std::string to_text(const systems::WarmUp& warm_up) {
  const systems::WarmUpSample& start = warm_up.samples.front();
  const systems::WarmUpSample& end = warm_up.samples.back();
  std::string out = fmt::format(
      "Held for {} s with every joint at 30 deg, from {} degC: coils of {} degC ({} at their hottest place), magnets "
      "of {} degC; the mean current in a coil goes from {} to {} A, and the force with it.\n",
      number(end.time), number(start.coil_temperatures.maxCoeff()), number(end.coil_temperatures.maxCoeff()),
      number(end.coil_hot_spot), number(end.magnet_temperature), number(start.mean), number(end.mean));
  if (warm_up.limit)
    out += fmt::format("{} {} is the first to pass its limit, {} degC, after {} s: do not hold it longer.\n",
                       warm_up.limit->kind == thermal::NodeKind::coil ? "Coil" : "Magnet", warm_up.limit->number,
                       number(warm_up.limit->limit), number(warm_up.limit->time));
  else
    out += "No coil and no magnet passes its limit in that time and pose.\n";
  if (warm_up.melting_time)
    out += fmt::format("Copper would melt after {} s, where this ends.\n", number(*warm_up.melting_time));
  return out;
}

}  // namespace coilwright::report
