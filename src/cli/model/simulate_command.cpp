#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/actuator_input.hpp"
#include "cli/model/commands.hpp"
#include "cli/model/task_options.hpp"
#include "cli/outputs.hpp"
#include "cli/progress_line.hpp"
#include "coilwright/actuator/assemble.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/simulation/commanded_input_file.hpp"
#include "coilwright/formats/simulation/motion_table.hpp"
#include "coilwright/report/simulation/motion_remarks.hpp"
#include "coilwright/simulation/initial_state.hpp"
#include "coilwright/simulation/model_input.hpp"
#include "coilwright/simulation/recorded_motion.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "coilwright/units/angle.hpp"

namespace coilwright::cli {
namespace {

using simulation::CommandedInput;
using simulation::Drive;
using simulation::ModelInput;
using simulation::RecordedMotion;
using simulation::State;

struct SimulateOptions {
  ActuatorOptions actuator;
  std::string out;
  std::optional<double> step;
  std::vector<double> sine;  // amplitude A, offset A, frequency Hz
  std::string input;
  std::optional<double> duration;
  std::optional<double> interval;
  bool as_written{false};
  bool force{false};
  bool json{false};
};

constexpr double usual_duration = 1.0;    // s
constexpr double usual_interval = 0.002;  // s

CommandedInput read_command(const SimulateOptions& options, const actuator::Model& model) {
  if (!options.input.empty()) {
    if (options.duration)
      throw CLI::ValidationError("--duration-s", "is of --step-A and --sine: an input lasts as long as its file says");
    CommandedInput command = formats::read_commanded_input(options.input);
    return options.interval ? simulation::sampled_at_least_every(command, *options.interval) : command;
  }
  if (model.coils() == 0) throw std::runtime_error(options.actuator.file + ": has no coils to drive");
  const double duration = options.duration.value_or(usual_duration);
  const double interval = options.interval.value_or(usual_interval);
  if (options.step)
    return simulation::step_command({.current = *options.step, .duration = duration, .interval = interval});
  return simulation::sine_command({.amplitude = options.sine[0],
                                   .offset = options.sine[1],
                                   .frequency = options.sine[2],
                                   .duration = duration,
                                   .interval = interval});
}

// Durations, intervals and frequencies that make more samples than there may be, or too few.
CommandedInput command_of(const SimulateOptions& options, const actuator::Model& model) {
  try {
    return read_command(options, model);
  } catch (const std::invalid_argument& rule) {
    const std::string text = rule.what();
    const bool is_frequency = text.starts_with("frequency");
    throw text::InputError({.file = is_frequency            ? "--sine, --interval-s"
                                    : options.input.empty() ? "--duration-s, --interval-s"
                                                            : "--interval-s",
                            .rule = text});
  }
}

ModelInput model_input(const SimulateOptions& options, const actuator::Model& model, const CommandedInput& command) {
  try {
    return simulation::model_input(model, command);
  } catch (const std::invalid_argument& rule) {
    throw text::InputError({.file = options.input, .place = "line 1", .rule = rule.what()});
  }
}

RecordedMotion record(const actuator::Model& model, const ModelInput& input, const State& start) {
  // A stiff model, or a long time, takes long: then it is said how far it is.
  std::atomic<double> reached = input.times.front();
  const ProgressLine::Place place = progress_place(false);
  const ProgressLine line(std::cerr, place, progress_interval(place), [&] {
    return fmt::format("the motion is known to {:.6g} s of {:.6g} s", reached.load(), input.times.back());
  });
  return simulation::record_motion(model, input, start, {.progress = [&](double time) { reached = time; }});
}

// Writing the result over its own input would lose the input.
void check_output(const SimulateOptions& options) {
  keep_inputs({options.actuator.file, options.input}, {options.out});
}

void run_simulate(const SimulateOptions& options) {
  require_file_for_json(options.json, options.out);
  check_output(options);
  const DrivenModel driven = read_driven_model(options.actuator);
  const actuator::Model& model = driven.model;
  const CommandedInput command = command_of(options, model);
  const ModelInput input = model_input(options, model, command);
  if (!options.input.empty() && !options.as_written)
    formats::require_bearable(command, input, driven.coil, options.input);
  const std::vector<std::string> columns = formats::columns_of_motion(command, model.joints());
  text::OutputFile file(options.out);
  keep_other_table(file, columns, options.force);
  const RecordedMotion recording =
      record(model, input,
             start_of(model, input, options.step ? simulation::Start::no_current : simulation::Start::first_input,
                      options.actuator.file));
  formats::write_motion(file.stream(), command, recording);
  file.commit();
  if (options.json) {
    const auto [least, greatest] = std::ranges::minmax(recording.bending_angles);
    double fastest = 0.0;
    for (const State& state : recording.states) fastest = std::max(fastest, std::abs(state.rates.sum()));
    std::cout << written_json({options.out})
                     .set("samples", recording.states.size())
                     .set("least_bending_angle_deg", least * units::degrees_per_radian)
                     .set("greatest_bending_angle_deg", greatest * units::degrees_per_radian)
                     .set("last_bending_angle_deg", recording.bending_angles.back() * units::degrees_per_radian)
                     .set("greatest_bending_speed_deg_s", fastest * units::degrees_per_radian)
                     .text();
  }
  const std::string table = options.input == "-" ? "standard input" : options.input;
  for (const std::string& remark : report::motion_remarks({.model = model,
                                   .input = input,
                                   .motion = recording,
                                   .table = options.interval ? std::string() : table,
                                   .cure = fmt::format("--interval-s {}", usual_interval),
                                   .supply_drives = driven.supply_drives}))
    std::cerr << remark << '\n';
}

}  // namespace

void add_simulate_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = add_command(app, "simulate");
  add_actuator_options(*command, options->actuator);
  CLI::Option_group* input = command->add_option_group("input", "Input of the simulation; one of");
  add_number(*input, "--step-A,--step", options->step, text::Rule::between(-1e6, 1e6),
             "Current in every coil from time 0 on, A; the actuator starts from rest without current");
  input
      ->add_option("--sine", options->sine,
                   "AMPLITUDE_A OFFSET_A FREQUENCY_Hz: current offset + amplitude sin(2 pi f t) in every coil")
      ->expected(3)
      ->check(number_rule(text::Rule::between(-1e6, 1e6)));
  input->add_option(
      "--input", options->input,
      "CSV file with time_s and one input: current_A, current1_A.., voltage_V or torque1_Nm..; values are held "
      "between samples");
  input->require_option(1);
  add_number(*command, "--duration-s", options->duration, text::positive,
             with_default("Duration of --step-A or --sine, s", usual_duration));
  add_number(*command, "--interval-s", options->interval, text::positive,
             with_default("Time between samples of --step-A or --sine, s", usual_interval) +
                 "; of --input the longest between samples, otherwise those of the file alone");
  command->add_option("--out", options->out, "CSV file to write")->required();
  add_flag(*command, "--as-written", options->as_written,
           "Take an --input also where its current is one that no coil carries, as milliamperes for amperes");
  add_flag(*command, "--force", options->force, "Replace a file that is no such table");
  add_written_json_option(*command, options->json);
  command->footer(
      "Writes time_s, the inputs, theta1_deg, .., bending_angle_deg and bending_speed_deg_s at every sample.\n"
      "bending_angle_deg includes the sensor's offset, scale and delay if the actuator declares them; joint\n"
      "angles and bending speed are the true ones. A step starts at rest without current, every other input at\n"
      "rest under its first sample, as a measured run with \"start\": \"at_rest\" does. A model without coils and\n"
      "without a stable pose starts straight. Coils and magnets are at 20 degC.\n\n"
      "Example:\n"
      "  coilwright simulate configs/actuators/paper_finger.json --sine 0.7 0.7 2 --duration-s 2 --out sine.csv");
  command->callback([options] { run_simulate(*options); });
}

}  // namespace coilwright::cli
