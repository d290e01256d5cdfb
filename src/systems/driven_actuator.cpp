#include "coilwright/systems/driven_actuator.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <stdexcept>

#include "coilwright/actuator/coil_bank.hpp"
#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/drive/settings.hpp"
#include "coilwright/thermal/steady_state.hpp"
#include "systems/check.hpp"
#include "systems/driven_coils.hpp"

namespace coilwright::systems {
namespace {

using actuator::Assembly;
using actuator::Design;
using drive::Driver;
using drive::ReducedBank;
using drive::Setting;

// Of temperatures that are looked for, K, and how often at most. Half of each change is taken: the heat of a voltage
// falls as a coil warms, that of a current grows by less than 0.81 of the change where the end is below melting.
constexpr double temperature_closeness = 1e-9;
constexpr int most_rounds = 2000;

// Heat over what the mean current suggests: 2.5 % of current, as a good ammeter reads.
constexpr double worth_a_warning = 1.05;

// In the order of DriveWarning.
constexpr std::array<std::string_view, 14> warning_names = {
    "out_of_reach",     "below_voltage",  "above_voltage",  "above_peak",    "above_cell",
    "dead_time",        "limited",        "no_period",      "discontinuous", "ripple",
    "above_continuous", "above_straight", "above_ampacity", "runaway"};

void check(const DriveQuestion& question) {
  if (!question.duty && !question.mean) throw std::invalid_argument("duty or mean must be given; got neither");
  if (question.mean) require(*question.mean > 0.0, "mean", "> 0", *question.mean, "A");
  if (question.duty) require(*question.duty >= 0.0 && *question.duty <= 1.0, "duty", "from 0 to 1", *question.duty);
  require(question.actuators >= 1, "actuators", ">= 1", question.actuators);
  if (const auto* cell = std::get_if<CellDrive>(&question.driver)) {
    if (cell->capacity) require(*cell->capacity > 0.0, "capacity", "> 0", *cell->capacity, "A s");
    if (const auto limit = cell->current_limit()) require(*limit > 0.0, "most_current", "finite and > 0", *limit, "A");
  }
}

double voltage_of(const DriveQuestion& question) {
  if (const auto* bridge = std::get_if<drive::HBridge>(&question.driver)) return bridge->supply_voltage;
  return std::get<CellDrive>(question.driver).circuit.emf;
}

Driver driver_at(const DriveQuestion& question, double voltage) {
  if (const auto* bridge = std::get_if<drive::HBridge>(&question.driver)) {
    drive::HBridge other = *bridge;
    other.supply_voltage = voltage;
    return driver_of(other);
  }
  drive::CellSwitch other = std::get<CellDrive>(question.driver).circuit;
  other.emf = voltage;
  return driver_of(other);
}

drive::CoilBank bank_of(const Design& design, const Assembly& assembly, const DriveQuestion& question,
                        const Eigen::VectorXd& temperatures) {
  return of_like_actuators(coil_bank(design, assembly, question.wiring, temperatures), question.actuators);
}

struct Solved {
  ReducedBank bank;
  Driver driver;
  drive::SteadyCurrent current;
  double duty{}, voltage{};
  bool reached = true;
};

Solved solve(const drive::CoilBank& coils, const DriveQuestion& question) {
  Solved out{.bank = reduce(coils), .driver = {}, .current = {}, .duty = 0.0, .voltage = voltage_of(question)};
  out.driver = driver_at(question, out.voltage);
  const auto answer = [&](double duty, double voltage, const drive::SteadyCurrent& current, bool reached) {
    out.duty = duty;
    out.voltage = voltage;
    out.driver = driver_at(question, voltage);
    out.current = current;
    out.reached = reached;
    return out;
  };
  const drive::Circuit& circuit = out.bank.circuit;
  if (!question.mean)
    return answer(*question.duty, out.voltage,
                  steady_current(circuit, out.driver, {.frequency = question.frequency, .duty = *question.duty}), true);
  const double mean = *question.mean / out.bank.shares.maxCoeff();
  if (!question.duty) {
    const Setting found = duty_for_mean(circuit, out.driver, question.frequency, mean);
    return answer(found.value.value_or(1.0), out.voltage, found.current, found.value.has_value());
  }
  const Setting found = voltage_for_mean(
      circuit, [&](double voltage) { return driver_at(question, voltage); },
      {.frequency = question.frequency, .duty = *question.duty}, mean, most_supply_voltage);
  return answer(*question.duty, found.value.value_or(most_supply_voltage), found.current, found.value.has_value());
}

// Of one actuator's parts under that drive; all its actuators are alike.
thermal::SteadyState heated(const Design& design, const thermal::Network& network, const Solved& solved) {
  thermal::NodeVector squares = thermal::NodeVector::Zero(network.size());
  Eigen::Index coil = 0;
  for (const int place : actuator::coil_places(design.layout))
    squares[place] = std::pow(solved.bank.shares[coil++] * solved.current.rms, 2);
  return steady_state(network, squares);
}

Eigen::VectorXd of_coils(const Design& design, const thermal::NodeVector& nodes) {
  const std::vector<int> places = actuator::coil_places(design.layout);
  Eigen::VectorXd out(static_cast<Eigen::Index>(places.size()));
  for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = nodes[places[i]];
  return out;
}

// The drive with the coils as warm as it makes them. The heat is that of the present currents at the present
// temperatures: a network under fixed currents would run away where a voltage, whose current falls, does not.
Solved solve_warm(const Design& design, const Assembly& assembly, const thermal::Network& network,
                  const DriveQuestion& question, Eigen::VectorXd& temperatures) {
  const std::vector<int> places = actuator::coil_places(design.layout);
  const Eigen::LLT<thermal::NodeMatrix> conductance(network.conductance());
  for (int round = 0; round < most_rounds; ++round) {
    const drive::CoilBank bank = bank_of(design, assembly, question, temperatures);
    Solved solved = solve(bank, question);
    thermal::NodeVector heat = thermal::NodeVector::Zero(network.size());
    for (Eigen::Index i = 0; i < temperatures.size(); ++i)
      heat[places[i]] = bank.resistances[i] * std::pow(solved.bank.shares[i] * solved.current.rms, 2);
    const thermal::NodeVector rises = conductance.solve(heat);
    const Eigen::VectorXd change = of_coils(design, rises).array() + network.ambient() - temperatures.array();
    if (!(temperatures.maxCoeff() < 1e6)) break;  // without end
    if (change.cwiseAbs().maxCoeff() < temperature_closeness) {
      if (temperatures.maxCoeff() > copper_melts) break;
      return solved;
    }
    temperatures += 0.5 * change;
  }
  throw std::invalid_argument(fmt::format(
      "coil temperature must be given: held for good, this drive heats the coils beyond {} degC, where copper melts",
      copper_melts));
}

drive::SteadyCurrent shared(drive::SteadyCurrent current, double share) {
  current.mean *= share;
  current.rms *= share;
  current.peak *= share;
  current.valley *= share;
  current.supply_mean *= share;
  current.powers = {};
  return current;
}

std::vector<DriveWarning> warnings_of(const DrivenActuator& answer, const Solved& solved,
                                      const DriveQuestion& question) {
  std::vector<DriveWarning> out;
  const auto warn = [&](bool holds, DriveWarning warning) {
    if (holds) out.push_back(warning);
  };
  const double frequency = question.frequency;
  warn(!solved.reached, DriveWarning::out_of_reach);
  if (const auto* bridge = std::get_if<drive::HBridge>(&question.driver)) {
    warn(answer.supply_voltage < bridge->ratings.lowest_voltage, DriveWarning::below_voltage);
    warn(answer.supply_voltage > bridge->ratings.highest_voltage, DriveWarning::above_voltage);
    warn(answer.driver.peak > bridge->ratings.peak_current, DriveWarning::above_peak);
  } else {
    const auto limit = std::get<CellDrive>(question.driver).current_limit();
    warn(limit && answer.driver.peak > *limit, DriveWarning::above_cell);
  }
  warn(answer.duty > 0.0 && answer.duty < 1.0 && answer.duty <= solved.driver.dead_time * frequency,
       DriveWarning::dead_time);
  warn(answer.driver.is_limited, DriveWarning::limited);
  warn(!answer.driver.repeats, DriveWarning::no_period);
  warn(answer.driver.is_discontinuous() && answer.driver.peak > 0.0, DriveWarning::discontinuous);
  warn(answer.driver.powers.coils >= worth_a_warning * answer.heat_by_mean && answer.heat_by_mean > 0.0,
       DriveWarning::ripple);
  warn(answer.coil.rms > answer.continuous_current, DriveWarning::above_continuous);
  warn(answer.coil.rms <= answer.continuous_current && answer.coil.rms > answer.straight_continuous_current,
       DriveWarning::above_straight);
  warn(answer.coil.rms > answer.ampacity, DriveWarning::above_ampacity);
  warn(!answer.steady_hot_spot, DriveWarning::runaway);
  return out;
}

}  // namespace

std::string_view name_of(DriveWarning warning) {
  return warning_names.at(static_cast<std::size_t>(warning));
}

DrivenActuator drive_actuator(const Design& design, const Assembly& assembly, const DriveQuestion& question) {
  check(question);
  require_one_current(design, "one driver");
  require_no_effects_up_to(assembly.model, actuator::Stage::drive, "the currents");
  const thermal::Network network = heat_network(design, assembly);
  Eigen::VectorXd temperatures =
      Eigen::VectorXd::Constant(assembly.coils, question.coil_temperature.value_or(network.ambient()));
  const Solved solved = question.coil_temperature ? solve(bank_of(design, assembly, question, temperatures), question)
                                                  : solve_warm(design, assembly, network, question, temperatures);
  const thermal::CurrentLimits limits = current_limits(network);
  const mechanics::JointVector straight = mechanics::JointVector::Zero(assembly.model.joints());
  const thermal::CurrentLimits nearest = current_limits(heat_network(design, assembly, straight));
  const thermal::SteadyState heat = heated(design, network, solved);
  DrivenActuator out{
      .duty = solved.duty,
      .supply_voltage = solved.voltage,
      .bank = solved.bank,
      .phases = solved.driver,
      .driver_resistance = solved.driver.on.resistance + solved.driver.on.supply_resistance,
      .driver = solved.current,
      .coil = shared(solved.current, solved.bank.shares.maxCoeff()),
      .heat_by_mean = solved.bank.circuit.resistance * solved.current.mean * solved.current.mean,
      .continuous_current = limits.for_good(),
      .straight_continuous_current = nearest.for_good(),
      .ampacity = assembly.coil.current_limit,
      .coil_temperatures = temperatures,
      .motion = motional_effect(assembly, bank_of(design, assembly, question, temperatures), solved.driver)};
  if (heat.outcome == thermal::Outcome::settles) {
    const double hottest = of_coils(design, heat.hot_spots).maxCoeff();
    if (hottest < copper_melts) out.steady_hot_spot = hottest;
  }
  if (const auto* cell = std::get_if<CellDrive>(&question.driver); cell != nullptr && cell->capacity)
    out.run_time = drive::run_time(*cell->capacity, solved.current.supply_mean);
  out.warnings = warnings_of(out, solved, question);
  return out;
}

}  // namespace coilwright::systems
