#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "actuator_input.hpp"
#include "coilwright/actuator/assemble.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/simulation/input_signal.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/transient.hpp"
#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "commands.hpp"
#include "keep_inputs.hpp"
#include "number_rule.hpp"

namespace coilwright::cli {
namespace {

using simulation::InputSignal;
using simulation::State;

struct Options {
  ActuatorOptions actuator;
  std::string out;
  std::optional<double> step;
  std::vector<double> sine;  // amplitude A, offset A, frequency Hz
  std::string input;
  double duration = 1.0;
  double interval = 0.002;
};

// A model with what its drive needs to know: the resistance that turns a voltage into a current.
struct Driven {
  actuator::Model model;
  std::optional<double> coil_resistance;  // ohm
};

// The input as the model takes it, and how its columns are called and written.
struct NamedInput {
  InputSignal signal;
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;  // a vector a sample
};

Driven read_driven(const ActuatorOptions& options) {
  formats::ActuatorFile file = read_actuator(options);
  if (auto* model = std::get_if<actuator::Model>(&file.content))
    return {.model = std::move(*model), .coil_resistance = {}};
  actuator::Assembly assembly = assemble(std::get<actuator::Design>(file.content), options);
  return {.model = std::move(assembly.model), .coil_resistance = assembly.coil.resistance};
}

NamedInput common_current(InputSignal signal) {
  std::vector<std::vector<double>> values;
  values.reserve(signal.times.size());
  for (const auto& currents : signal.currents) values.push_back({currents.size() > 0 ? currents[0] : 0.0});
  return {.signal = std::move(signal), .names = {"current_A"}, .values = std::move(values)};
}

text::InputError misfit(const Options& options, std::string rule) {
  return text::InputError({.file = options.input, .place = "line 1", .rule = std::move(rule)});
}

std::vector<std::string> column_names(const formats::InputSignal& input) {
  if (input.kind == formats::InputKind::voltage) return {"voltage_V"};
  if (input.kind == formats::InputKind::current && input.addressing == formats::InputAddressing::common)
    return {"current_A"};
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= input.values.size(); ++i)
    names.push_back(input.kind == formats::InputKind::current ? fmt::format("current{}_A", i)
                                                              : fmt::format("torque{}_Nm", i));
  return names;
}

// A file's values are a vector a column.
std::vector<std::vector<double>> rows_of(const formats::InputSignal& input) {
  std::vector<std::vector<double>> rows(input.times.size());
  for (const std::vector<double>& column : input.values)
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(column[i]);
  return rows;
}

// One row of a file as currents and torques of the model.
void append(const Driven& driven, const formats::InputSignal& input, const std::vector<double>& row, InputSignal& out) {
  const actuator::Model& model = driven.model;
  const Eigen::Map<const Eigen::VectorXd> values(row.data(), static_cast<Eigen::Index>(row.size()));
  switch (input.kind) {
    case formats::InputKind::current:
      out.currents.push_back(input.addressing == formats::InputAddressing::common ? model.all_coils(row[0])
                                                                                  : actuator::CoilCurrents(values));
      return;
    case formats::InputKind::voltage:
      // Quasi-static: L / R of a coil (0.3 ms in the prototype) is far below a finger's 30 ms.
      out.currents.push_back(model.all_coils(row[0] / *driven.coil_resistance));
      return;
    case formats::InputKind::torque:
      out.currents.push_back(model.all_coils(0.0));
      out.joint_torques.push_back(values);
      return;
  }
}

NamedInput read_file_input(const Options& options, const Driven& driven) {
  const formats::InputSignal input = formats::read_input_signal(options.input);
  const std::size_t width = input.values.size();
  const bool each_coil =
      input.kind == formats::InputKind::current && input.addressing == formats::InputAddressing::each;
  if (each_coil && width != static_cast<std::size_t>(driven.model.coils()))
    throw misfit(options, fmt::format("needs a current for each of the {} coils; got {}", driven.model.coils(), width));
  if (input.kind == formats::InputKind::torque && width != static_cast<std::size_t>(driven.model.joints()))
    throw misfit(options,
                 fmt::format("needs a torque for each of the {} joints; got {}", driven.model.joints(), width));
  if (input.kind == formats::InputKind::voltage && !driven.coil_resistance)
    throw misfit(options, "has a voltage, and a lumped model has no coil resistance");
  if (input.kind != formats::InputKind::torque && driven.model.coils() == 0)
    throw misfit(options, "drives coils, and this model has none");
  NamedInput out{.signal = {.times = input.times, .currents = {}, .joint_torques = {}},
                 .names = column_names(input),
                 .values = rows_of(input)};
  for (const std::vector<double>& row : out.values) append(driven, input, row, out.signal);
  return out;
}

NamedInput make_input(const Options& options, const Driven& driven) {
  if (!options.input.empty()) return read_file_input(options, driven);
  if (driven.model.coils() == 0) throw std::runtime_error(options.actuator.file + ": has no coils to drive");
  if (options.step)
    return common_current(simulation::step_input(
        driven.model, {.current = *options.step, .duration = options.duration, .interval = options.interval}));
  return common_current(simulation::sine_input(driven.model, {.amplitude = options.sine[0],
                                                              .offset = options.sine[1],
                                                              .frequency = options.sine[2],
                                                              .duration = options.duration,
                                                              .interval = options.interval}));
}

actuator::CoilCurrents start_currents(const Options& options, const actuator::Model& model, const InputSignal& signal) {
  return options.step ? model.all_coils(0.0) : signal.currents.front();
}

// A step starts hanging without current; every other input in the equilibrium of its own first sample.
mechanics::JointVector start_angles(const Options& options, const Driven& driven, const InputSignal& signal) {
  const actuator::Model& model = driven.model;
  const actuator::CoilCurrents currents = start_currents(options, model, signal);
  const mechanics::JointVector torques =
      signal.joint_torques.empty() ? mechanics::JointVector::Zero(model.joints()) : signal.joint_torques.front();
  const auto angles = simulation::creep_to_equilibrium(
      {.residual =
           [&](const auto& at) { return mechanics::JointVector(model.static_residual(at, currents) + torques); },
       .stiffness = [&](const auto& at) { return model.tangent_stiffness(at, currents); },
       .torque_scale = simulation::torque_scale(model)},
      mechanics::JointVector::Zero(model.joints()));
  // A rig without springs or gravity stays where it is put: straight.
  if (!angles && model.coils() == 0) return mechanics::JointVector::Zero(model.joints());
  if (!angles)
    throw std::runtime_error(options.actuator.file + ": has no stable pose under the first input to start from");
  return *angles;
}

// The joints as they are, and of the bending angle what the camera shows.
struct Recording {
  std::vector<State> states;
  std::vector<double> bending;  // rad
};

Recording record(const actuator::Model& model, const InputSignal& signal, const State& start) {
  Recording out{.states = simulation::simulate(model, signal, start), .bending = {}};
  const auto show = [&](const std::vector<State>& states) {
    for (const State& state : states) out.bending.push_back(model.observed(model.bending_angle(state.angles)));
  };
  if (model.delay() > 0.0)
    show(simulation::simulate_seen(model, signal, start));
  else
    show(out.states);
  return out;
}

void write(std::ostream& stream, const NamedInput& input, const Recording& recording) {
  const std::vector<State>& states = recording.states;
  constexpr double degrees = 180.0 / std::numbers::pi;
  std::vector<std::string> columns{"time_s"};
  columns.insert(columns.end(), input.names.begin(), input.names.end());
  for (Eigen::Index j = 1; j <= states.front().angles.size(); ++j) columns.push_back(fmt::format("theta{}_deg", j));
  columns.insert(columns.end(), {"bending_angle_deg", "bending_speed_deg_s"});
  text::CsvWriter csv(stream, columns);
  std::vector<double> row;
  for (std::size_t i = 0; i < states.size(); ++i) {
    row.assign(1, input.signal.times[i]);
    row.insert(row.end(), input.values[i].begin(), input.values[i].end());
    for (const double angle : states[i].angles) row.push_back(angle * degrees);
    row.push_back(recording.bending[i] * degrees);
    row.push_back(states[i].rates.sum() * degrees);
    csv.row(row);
  }
}

// Writing the result over its own input would lose the input.
void check_output(const Options& options) {
  keep_inputs(std::array<std::filesystem::path, 2>{options.actuator.file, options.input},
              std::array<std::filesystem::path, 1>{options.out});
}

void run_simulate(const Options& options) {
  check_output(options);
  const Driven driven = read_driven(options.actuator);
  const NamedInput input = make_input(options, driven);
  text::OutputFile file(options.out);
  const actuator::Model& model = driven.model;
  State start{.angles = start_angles(options, driven, input.signal),
              .rates = mechanics::JointVector::Zero(model.joints())};
  start.internal = model.settled(start.angles, start_currents(options, model, input.signal));
  write(file.stream(), input, record(model, input.signal, start));
  file.commit();
}

}  // namespace

void add_simulate_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("simulate", "How an actuator moves under an input over time");
  add_actuator_options(*command, options->actuator);
  CLI::Option_group* input = command->add_option_group("input", "What drives it; one of");
  input->add_option("--step", options->step, "This current in every coil from time 0 on, from rest without current, A")
      ->check(number_rule(text::Rule::between(-1e6, 1e6)));
  input->add_option("--sine", options->sine, "AMPLITUDE_A OFFSET_A FREQUENCY_Hz: offset + amplitude sin(2 pi f t)")
      ->expected(3)
      ->check(number_rule(text::Rule::between(-1e6, 1e6)));
  input->add_option("--input", options->input,
                    "CSV: time_s and current_A, current1_A.., voltage_V or torque1_Nm.., held between samples");
  input->require_option(1);
  command->add_option("--duration-s", options->duration, "Of --step and --sine; 1")->check(number_rule(text::positive));
  command->add_option("--interval-s", options->interval, "Between samples of --step and --sine; 0.002")
      ->check(number_rule(text::positive));
  command->add_option("--out", options->out, "CSV to write")->required();
  command->footer(
      "Writes time_s, the inputs, theta1_deg, .., bending_angle_deg and bending_speed_deg_s at every sample: the "
      "bending\n"
      "angle as the camera shows it, where an effect says that it shows another one or late, the rest as it is. A "
      "step\n"
      "starts from rest without current, every other input from the equilibrium under its first sample (a rig without\n"
      "magnetics that has none: straight).\n\n"
      "Example:\n"
      "  coilwright simulate configs/actuators/paper_finger.json --sine 0.7 0.7 2 --duration-s 2 --out sine.csv");
  command->callback([options] { run_simulate(*options); });
}

}  // namespace coilwright::cli
