#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/actuator_input.hpp"
#include "cli/model/commands.hpp"
#include "cli/model/task_options.hpp"
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

struct DriveOptions {
  ActuatorOptions actuator;
  formats::DriveTask task;
  bool supply_is_given{false};
  bool warm{false};
  std::optional<double> motion, warm_up;
  std::optional<double> interval;
  std::string out;
  bool force{false};
  bool json{false};
};

systems::DriveQuestion question_of(const DriveOptions& options) {
  systems::DriveQuestion question = options.task.asked();
  if (options.warm) question.coil_temperature.reset();
  return question;
}

// Usually between rows, ms.
constexpr double of_motion = 1.0;
constexpr double of_warm_up = 1000.0;

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
              {.duration = *options.warm_up, .interval = interval_of(options, *options.warm_up, of_warm_up)});
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
                   {.duration = *options.motion, .interval = interval_of(options, *options.motion, of_motion)});
  write_file(options.out, table_mark, options.force, [&](std::ostream& out) { formats::write_motion(out, motion); });
  return summary_of(motion);
}

void run_drive(const DriveOptions& options) {
  const std::optional<double>& duty = options.task.question.duty;
  const std::optional<double>& mean = options.task.question.mean;
  if (!duty && !mean) throw CLI::ValidationError("--duty", "or --mean-A is needed: what is set, or what is wanted");
  if (duty && mean) {
    if (options.task.cell.circuit.emf > 0.0)
      throw CLI::ValidationError("--cell-voltage-V",
                                 "a cell has the voltage it has; give --duty or --mean-A, not both");
    if (options.supply_is_given)
      throw CLI::ValidationError("--supply-voltage-V", "with --duty and --mean-A the voltage is what is looked for");
    if (*duty == 0.0) throw CLI::ValidationError("--duty", "must be > 0 with --mean-A; got 0");
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

void add_driver(CLI::App& command, DriveOptions& options) {
  add_rows(command, formats::drive_rows(), options.task);
  add_flag(command, "--warm", options.warm, "Coils as warm as this drive leaves them when it is held for good")
      ->excludes(command.get_option("--coil-temperature-degC"));
  CLI::Option* cell = command.get_option("--cell-voltage-V");
  for (const char* of_bridge : {"--supply-voltage-V", "--decay", "--current-limit-A", "--high-resistance-mOhm",
                                "--low-resistance-mOhm", "--dead-time-us", "--limit-off-time-us", "--limit-blanking-us",
                                "--bridge-lowest-V", "--bridge-highest-V", "--bridge-peak-A"})
    cell->excludes(command.get_option(of_bridge));
  for (const char* of_cell : {"--cell-capacity-mAh", "--cell-limit-A", "--switch-resistance-mOhm"})
    command.get_option(of_cell)->needs(cell);
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
  add_number(
      command, "--interval-ms", options.interval, text::Rule::between(1e-3, 1e6),
      fmt::format("Between rows of that file, ms (default {} for a motion, {} for a warm-up)", of_motion, of_warm_up))
      ->needs(out);
}

}  // namespace

void add_drive_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<DriveOptions>();
  CLI::App* command = add_command(app, "drive");
  add_actuator_options(*command, options->actuator);
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
  command->callback([options, command] {
    options->supply_is_given = command->count("--supply-voltage-V") > 0;
    run_drive(*options);
  });
}

}  // namespace coilwright::cli
