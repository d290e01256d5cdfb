#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>

#include "actuator_input.hpp"
#include "coilwright/formats/simulation/linear_model_json.hpp"
#include "coilwright/simulation/linear_model.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "commands.hpp"
#include "keep_inputs.hpp"
#include "number_rule.hpp"
#include "report_stream.hpp"

namespace coilwright::cli {
namespace {

using simulation::LinearModel;

struct Options {
  ActuatorOptions actuator;
  double current{};
  std::string out;
  bool json{false};
};

// An actuator that has no such pose is an input that asks for what there is not.
LinearModel linear_model(const Options& options) {
  const actuator::Model model = read_model(options.actuator);
  try {
    return simulation::linearise(model, options.current);
  } catch (const std::invalid_argument& rule) {
    throw text::InputError({.file = options.actuator.file, .rule = rule.what()});
  } catch (const std::runtime_error& reason) {
    throw text::InputError({.file = options.actuator.file, .rule = reason.what()});
  }
}

std::string as_table(const LinearModel& model) {
  constexpr double degrees = 180.0 / std::numbers::pi;
  std::string text = fmt::format("{:<26} {:>12.5g}\n{:<26} {:>12.5g}\n", "current_A", model.current,
                                 "bending_angle_deg", model.angles.sum() * degrees);
  for (Eigen::Index j = 0; j < model.angles.size(); ++j)
    text += fmt::format("{:<26} {:>12.5g}\n", fmt::format("theta{}_deg", j + 1), model.angles[j] * degrees);
  if (model.dc_gain) text += fmt::format("{:<26} {:>12.5g}\n", "dc_gain_deg_A", (*model.dc_gain)[0] * degrees);
  for (const simulation::Mode& mode : model.modes)
    text += fmt::format("{:<26} {:>12.5g}\n{:<26} {:>12.5g}\n", "natural_frequency_Hz", mode.natural_frequency,
                        "damping_ratio", mode.damping_ratio);
  return text;
}

std::string remarks(const LinearModel& model) {
  std::string text;
  if (model.sticks)
    text +=
        "Something sticks (dry friction, hysteresis): the linear model is one of motions beyond what it holds, and has "
        "no friction.\n";
  for (const int joint : model.pressed_joints)
    text += fmt::format("The faces of joint {} are pressed: the linear model holds while they stay so.\n", joint + 1);
  if (!model.stable()) text += "Small motions about this pose grow: it is not stable.\n";
  return text;
}

void run_linearise(const Options& options) {
  keep_inputs(std::array<std::filesystem::path, 1>{options.actuator.file},
              std::array<std::filesystem::path, 1>{options.out});
  const LinearModel model = linear_model(options);
  const std::string json = formats::to_json(model).text();
  if (!options.out.empty()) {
    text::OutputFile file(options.out);
    file.stream() << json;
    file.commit();
  }
  report_stream(options.out) << (options.json ? json : as_table(model));
  std::cerr << remarks(model);
}

}  // namespace

void add_linearise_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("linearise", "Give the linear model of small motions about a steady pose");
  add_actuator_options(*command, options->actuator);
  command->add_option("--current", options->current, "Current in every coil that holds the pose, A")
      ->required()
      ->check(number_rule(text::Rule::between(-1e6, 1e6)));
  command->add_flag("--json", options->json, "Print JSON (linear-model/1) instead of a table")->disable_flag_override();
  command->add_option("--out", options->out, "JSON file to write (linear-model/1)");
  command->footer(
      "The JSON has x' = A x + B u, y = C x + D u with the names of states, input and outputs, each ending in its\n"
      "unit: deviations of joint angles and rates, of the current in every coil, of bending and joint angles. Effects\n"
      "with states that come back by themselves (a lag, creep) bring these along; camera effects are left out of the\n"
      "outputs. What sticks, and faces that are pressed, are told on standard error. Whether the parts bear the "
      "current:\n"
      "evaluate.\n\n"
      "Example:\n"
      "  coilwright linearise configs/actuators/paper_finger.json --current 1.4 --out linear.json");
  command->callback([options] { run_linearise(*options); });
}

}  // namespace coilwright::cli
