#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/actuator_input.hpp"
#include "cli/model/commands.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "coilwright/formats/systems/drive_json.hpp"
#include "coilwright/report/systems/drive_text.hpp"
#include "coilwright/systems/driven_actuator.hpp"
#include "coilwright/systems/driven_motion.hpp"
#include "coilwright/systems/warm_up.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_file.hpp"

namespace coilwright::cli {
namespace {

using text::Rule;

// As on the command line, each in the unit of its name.
struct DriveOptions {
  ActuatorOptions actuator;
  std::optional<double> duty, mean, supply_voltage, cell_voltage, cell_capacity, cell_limit, limit, switch_resistance;
  double supply_resistance{};
  double high_resistance = 307.0, low_resistance = 258.0;
  std::optional<double> diode_voltage;
  double dead_time = 0.22, limit_off_time = 25.0, limit_blanking = 2.0;
  drive::BridgeRatings ratings;
  double frequency = 490.0;
  std::string decay = "slow", wiring = "parallel";
  int actuators = 1;
  double coil_temperature = 20.0;
  bool warm{false};
  std::optional<double> motion, warm_up;
  std::optional<double> interval;
  std::string out;
  bool force{false};
  bool json{false};
};

drive::HBridge bridge_of(const DriveOptions& options) {
  drive::HBridge bridge{.supply_voltage = options.supply_voltage.value_or(24.0),
                        .supply_resistance = options.supply_resistance,
                        .high_resistance = options.high_resistance * 1e-3,
                        .low_resistance = options.low_resistance * 1e-3,
                        .dead_time = options.dead_time * 1e-6,
                        .decay = options.decay == "slow" ? drive::Decay::slow : drive::Decay::fast,
                        .trip = options.limit,
                        .limit_off_time = options.limit_off_time * 1e-6,
                        .limit_blanking = options.limit_blanking * 1e-6,
                        .ratings = options.ratings};
  bridge.diode_voltage = options.diode_voltage.value_or(bridge.diode_voltage);
  return bridge;
}

systems::CellDrive cell_of(const DriveOptions& options) {
  systems::CellDrive cell{.circuit = {.emf = *options.cell_voltage,
                                      .resistance = options.supply_resistance,
                                      .switch_resistance = options.switch_resistance.value_or(50.0) * 1e-3},
                          .most_current = options.cell_limit};
  if (options.cell_capacity) cell.capacity = *options.cell_capacity * 3.6;
  cell.circuit.diode_voltage = options.diode_voltage.value_or(cell.circuit.diode_voltage);
  return cell;
}

systems::DriveQuestion question_of(const DriveOptions& options) {
  systems::DriveQuestion question{
      .wiring = options.wiring == "series" ? drive::BankWiring::series : drive::BankWiring::parallel,
      .actuators = options.actuators,
      .frequency = options.frequency,
      .duty = options.duty,
      .mean = options.mean};
  if (options.cell_voltage)
    question.driver = cell_of(options);
  else
    question.driver = bridge_of(options);
  question.coil_temperature = options.warm ? std::nullopt : std::optional<double>(options.coil_temperature);
  return question;
}

// Between rows, s; `usual` in ms.
double interval_of(const DriveOptions& options, double duration, double usual) {
  return std::min(options.interval.value_or(usual) * 1e-3, duration);
}

// A cell gives nothing once it is empty.
void require_charge(const char* option, double duration, const systems::DrivenActuator& driven) {
  if (driven.run_time && duration > *driven.run_time)
    throw CLI::ValidationError(
        option, fmt::format("must be at most {:.5g} s, which the cell lasts; got {:.5g}", *driven.run_time, duration));
}

// Follows how it warms into its file, if that is asked for.
std::optional<systems::WarmUp> follow_warm_up(const DriveOptions& options, const BuiltDesign& built,
                                              const systems::DriveQuestion& question,
                                              const systems::DrivenActuator& driven) {
  if (!options.warm_up) return std::nullopt;
  require_charge("--warm-up-s", *options.warm_up, driven);
  systems::WarmUp found =
      warm_up(built.design, built.assembly, question, driven,
              {.duration = *options.warm_up, .interval = interval_of(options, *options.warm_up, 1000.0)});
  write_file(options.out, table_mark, options.force, [&](std::ostream& out) { formats::write_warm_up(out, found); });
  return found;
}

// Follows the motion into its file, if one is asked for.
std::optional<systems::MotionSummary> follow(const DriveOptions& options, const BuiltDesign& built,
                                             const systems::DriveQuestion& question,
                                             const systems::DrivenActuator& driven) {
  if (!options.motion) return std::nullopt;
  require_charge("--motion-s", *options.motion, driven);
  const std::vector<systems::MotionSample> motion =
      drive_motion(built.design, built.assembly, question, driven,
                   {.duration = *options.motion, .interval = interval_of(options, *options.motion, 1.0)});
  write_file(options.out, table_mark, options.force, [&](std::ostream& out) { formats::write_motion(out, motion); });
  return summary_of(motion);
}

void run_drive(const DriveOptions& options) {
  if (!options.duty && !options.mean)
    throw CLI::ValidationError("--duty", "or --mean-A is needed: what is set, or what is wanted");
  if (options.duty && options.mean) {
    if (options.cell_voltage)
      throw CLI::ValidationError("--cell-voltage-V",
                                 "a cell has the voltage it has; give --duty or --mean-A, not both");
    if (options.supply_voltage)
      throw CLI::ValidationError("--supply-voltage-V", "with --duty and --mean-A the voltage is what is looked for");
    if (*options.duty == 0.0) throw CLI::ValidationError("--duty", "must be > 0 with --mean-A; got 0");
  }
  if (!options.out.empty() && !options.motion && !options.warm_up)
    throw CLI::ValidationError("--out", "requires --motion-s or --warm-up-s");
  keep_inputs({options.actuator.file}, {options.out});
  require_writable({options.out});
  const BuiltDesign built =
      built_design(read_actuator(options.actuator), options.actuator, "a drive needs a design (actuator/1)");
  const systems::DriveQuestion question = question_of(options);
  try {
    const systems::DrivenActuator driven = systems::drive_actuator(built.design, built.assembly, question);
    const std::optional<systems::MotionSummary> motion = follow(options, built, question, driven);
    const std::optional<systems::WarmUp> warmed = follow_warm_up(options, built, question, driven);
    if (options.json) {
      text::Json out = formats::to_json(driven);
      if (motion) out.set("motion", formats::to_json(*motion));
      if (warmed) out.set("warm_up", formats::to_json(*warmed));
      report_stream(options.out) << out.text();
    } else {
      report_stream(options.out) << report::to_text(driven, question) << (motion ? report::to_text(*motion) : "")
                                 << (warmed ? report::to_text(*warmed) : "");
    }
  } catch (const std::invalid_argument& rule) {
    throw text::InputError({.file = options.actuator.file, .rule = rule.what()});
  }
}

void add_asked(CLI::App& command, DriveOptions& options) {
  add_number(command, "--duty", options.duty, Rule::between(0.0, 1.0),
             "Fraction of a period that is switched on, 0 to 1");
  add_number(command, "--mean-A", options.mean, up_to(100.0),
             "Wanted mean current of a coil, A: finds the duty for it, or with --duty the supply voltage");
  add_number(command, "--frequency-Hz", options.frequency, Rule::between(0.1, 1e6),
             "Frequency of the pulses, Hz (default 490)");
  add_word(command, "--wiring", options.wiring, {"series", "parallel"},
           "series or parallel: how all coils hang on the driver (default parallel)");
  add_whole_number(command, "--actuators", options.actuators, Rule::between(1, 16),
                   "Like actuators on the same driver (default 1)");
  auto* stated = add_number(command, "--coil-temperature-degC", options.coil_temperature, Rule::between(-50.0, 200.0),
                            "Mean temperature of the coils, degC (default 20)");
  add_flag(command, "--warm", options.warm, "Coils as warm as this drive leaves them when it is held for good")
      ->excludes(stated);
}

void add_driver(CLI::App& command, DriveOptions& options) {
  const Rule voltage = up_to(1000.0);
  auto* supply = add_number(command, "--supply-voltage-V", options.supply_voltage, voltage,
                            "Of the H-bridge's supply, V (default 24)");
  auto* decay = add_word(command, "--decay", options.decay, {"slow", "fast"},
                         "slow (coils shorted while off) or fast (current returned to the supply) (default slow)");
  auto* limit = add_number(command, "--current-limit-A", options.limit, up_to(100.0),
                           "At which the H-bridge chops, A (default none)");
  const auto from_zero = [&](double most, const char* name, double& value, const char* text) {
    return add_number(command, name, value, Rule::between(0.0, most), text);
  };
  from_zero(1e3, "--supply-resistance-Ohm", options.supply_resistance,
            "Inside supply or cell, with leads, Ohm (default 0)");
  auto* high =
      from_zero(1e5, "--high-resistance-mOhm", options.high_resistance, "Of a high switch, mOhm (default 307)");
  auto* low = from_zero(1e5, "--low-resistance-mOhm", options.low_resistance, "Of a low switch, mOhm (default 258)");
  auto* dead = from_zero(1e3, "--dead-time-us", options.dead_time, "Between switches, us (default 0.22)");
  auto* off = add_number(command, "--limit-off-time-us", options.limit_off_time, Rule::between(1.0, 1e4),
                         "For which the current limit switches off, us (default 25)");
  auto* blanking = from_zero(1e3, "--limit-blanking-us", options.limit_blanking,
                             "In which the limit does not look after switching on, us (default 2)");
  add_number(command, "--diode-voltage-V", options.diode_voltage, Rule::between(0.0, 10.0),
             "Of a diode, V (default 0.8 in a bridge, 0.4 across the coils at a cell)");
  auto* lowest = from_zero(1e3, "--bridge-lowest-V", options.ratings.lowest_voltage,
                           "Supply from which the H-bridge works, V (default 6.5)");
  const auto rating = [&](const char* name, double& value, const char* text) {
    return add_number(command, name, value, up_to(1e3), text);
  };
  auto* highest = rating("--bridge-highest-V", options.ratings.highest_voltage,
                         "Supply up to which the H-bridge works, V (default 45)");
  auto* peak =
      rating("--bridge-peak-A", options.ratings.peak_current, "Current that the H-bridge bears, A (default 3.6)");
  auto* cell = add_number(command, "--cell-voltage-V", options.cell_voltage, voltage,
                          "Drives by a battery cell of this open voltage through a switch instead, V");
  for (CLI::Option* other : {supply, decay, limit, high, low, dead, off, blanking, lowest, highest, peak})
    cell->excludes(other);
  add_number(command, "--cell-capacity-mAh", options.cell_capacity, up_to(1e6),
             "Of the cell, mAh; says how long it lasts")
      ->needs(cell);
  add_number(command, "--cell-limit-A", options.cell_limit, up_to(1e3),
             "The most that the cell delivers, A (default 20 times its capacity an hour, where that is given)")
      ->needs(cell);
  add_number(command, "--switch-resistance-mOhm", options.switch_resistance, Rule::between(0.0, 1e5),
             "Of the cell's switch, mOhm (default 50)")
      ->needs(cell);
}

// What is followed over time.
void add_course(CLI::App& command, DriveOptions& options) {
  auto* motion =
      add_number(command, "--motion-s", options.motion, up_to(1e4), "Follows the motion from rest for this long, s");
  auto* warm_up = add_number(command, "--warm-up-s", options.warm_up, up_to(1e5),
                             "Follows for this long how the actuator warms from the temperature of its surroundings, s")
                      ->excludes(motion);
  auto* out = command.add_option("--out", options.out, "CSV file to write the motion or the warm-up to");
  motion->needs(out);
  warm_up->needs(out);
  add_force_option(command, options.force);
  add_number(command, "--interval-ms", options.interval, Rule::between(1e-3, 1e6),
             "Between rows of that file, ms (default 1 for a motion, 1000 for a warm-up)")
      ->needs(out);
}

}  // namespace

void add_drive_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<DriveOptions>();
  CLI::App* command = add_command(app, "drive");
  add_actuator_options(*command, options->actuator);
  add_asked(*command, *options);
  add_driver(*command, *options);
  add_course(*command, *options);
  add_json_option(*command, options->json, "tables");
  command->footer(
      "The H-bridge's defaults are typical of an integrated driver such as the DRV8870 or DRV8871 on 24 V. All is the\n"
      "periodic steady state without motion; currents of a coil are those of the one that carries most. The motion\n"
      "starts at rest without current and with a pulse; its coils keep their temperatures. A warm-up holds duty and\n"
      "voltage, so that the current falls as the coils warm.\n\n"
      "Examples:\n"
      "  coilwright drive configs/actuators/paper_finger.json --mean-A 1.4 --wiring series --actuators 2\n"
      "  coilwright drive configs/actuators/paper_finger.json --duty 0.5 --frequency-Hz 10 --cell-voltage-V 4.2 \\\n"
      "    --cell-capacity-mAh 150\n"
      "  coilwright drive configs/actuators/paper_finger.json --mean-A 1.4 --motion-s 0.5 --out motion.csv\n"
      "  coilwright drive configs/actuators/paper_finger.json --mean-A 1.4 --warm-up-s 600 --out warm_up.csv");
  command->callback([options] { run_drive(*options); });
}

}  // namespace coilwright::cli
