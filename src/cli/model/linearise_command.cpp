#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cli/actuator_input.hpp"
#include "cli/model/commands.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "coilwright/formats/simulation/linear_model_json.hpp"
#include "coilwright/simulation/linear_model.hpp"
#include "coilwright/simulation/supply.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "coilwright/units/angle.hpp"

namespace coilwright::cli {
namespace {

using simulation::LinearModel;

struct LineariseOptions {
  ActuatorOptions actuator;
  std::vector<double> currents;
  std::string out;
  bool force{false};
  bool json{false};
};

// An actuator that has no such pose is an input that asks for what there is not.
LinearModel linear_model(const LineariseOptions& options, const actuator::Model& model) {
  try {
    if (options.currents.size() == 1) return simulation::linearise(model, options.currents.front());
    if (options.currents.size() > static_cast<std::size_t>(mechanics::max_joints) + 1)
      throw std::invalid_argument(
          fmt::format("has {} coils; a current for each is needed, got {}", model.coils(), options.currents.size()));
    const auto count = static_cast<Eigen::Index>(options.currents.size());
    return simulation::linearise(
        model, actuator::CoilCurrents(Eigen::Map<const Eigen::VectorXd>(options.currents.data(), count)));
  } catch (const std::invalid_argument& rule) {
    throw text::InputError({.file = options.actuator.file, .rule = rule.what()});
  } catch (const std::runtime_error& reason) {
    throw text::InputError({.file = options.actuator.file, .rule = reason.what()});
  }
}

std::string as_table(const LinearModel& model) {
  const bool one_input = model.b.cols() == 1;
  const auto row = [](std::string_view name, double value) { return fmt::format("{:<26} {:>12.5g}\n", name, value); };
  std::string text;
  for (Eigen::Index i = 0; i < model.b.cols(); ++i)
    text += row(one_input ? "current_A" : fmt::format("current{}_A", i + 1), model.currents[i]);
  text += row("bending_angle_deg", model.angles.sum() * units::degrees_per_radian);
  for (Eigen::Index j = 0; j < model.angles.size(); ++j)
    text += row(fmt::format("theta{}_deg", j + 1), model.angles[j] * units::degrees_per_radian);
  for (Eigen::Index i = 0; model.dc_gain && i < model.b.cols(); ++i)
    text += row(one_input ? "dc_gain_deg_A" : fmt::format("dc_gain{}_deg_A", i + 1),
                (*model.dc_gain)(0, i) * units::degrees_per_radian);
  for (std::size_t i = 0; i < model.modes.size(); ++i)
    text += row(fmt::format("natural_frequency{}_Hz", i + 1), model.modes[i].natural_frequency) +
            row(fmt::format("damping_ratio{}", i + 1), model.modes[i].damping_ratio);
  return text;
}

std::string remarks(const LinearModel& model, const DrivenModel& driven) {
  std::string text;
  if (driven.supply_drives) {
    const double share = driven.model.current_shares().cwiseAbs().maxCoeff();
    const std::string of_supply =
        simulation::supply_text(driven.supply_drives, model.currents.cwiseAbs().maxCoeff() / share);
    if (!of_supply.empty()) text += "MIND: " + of_supply + ".\n";
  }
  if (model.sticks)
    text +=
        "Something sticks (dry friction, hysteresis): the linear model is one of motions beyond what it holds, and has "
        "no friction.\n";
  for (const int joint : model.pressed_joints)
    text += fmt::format("The faces of joint {} are pressed: the linear model holds while they stay so.\n", joint + 1);
  if (!model.stable()) text += "Small motions about this pose grow: it is not stable.\n";
  return text;
}

void run_linearise(const LineariseOptions& options) {
  keep_inputs({options.actuator.file}, {options.out});
  require_writable({options.out});
  const DrivenModel driven = read_driven_model(options.actuator);
  const LinearModel model = linear_model(options, driven.model);
  const std::string json = formats::to_json(model).text();
  if (!options.out.empty()) write_file(options.out, json_mark, options.force, [&](std::ostream& out) { out << json; });
  report_stream(options.out) << (options.json ? json : as_table(model) + "\n" + std::string(cold_note));
  std::cerr << remarks(model, driven);
}

}  // namespace

void add_linearise_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<LineariseOptions>();
  CLI::App* command = add_command(app, "linearise");
  add_actuator_options(*command, options->actuator);
  command
      ->add_option("--current-A,--current", options->currents,
                   "Current that holds the pose, A: one in every coil, or one for each, base to tip")
      ->required()
      ->expected(1, static_cast<int>(mechanics::max_joints) + 1)
      ->check(number_rule(text::Rule::between(-1e6, 1e6)));
  add_flag(*command, "--json", options->json, "Print JSON (linear-model/1) instead of a table");
  command->add_option("--out", options->out, "JSON file to write (linear-model/1)");
  add_force_option(*command, options->force);
  command->footer(
      "The JSON has x' = A x + B u, y = C x + D u with the names of states, input and outputs, each ending in its\n"
      "unit: deviations of joint angles and rates, of the current in every coil (or, where each has its own, of "
      "each),\n"
      "of bending and joint angles. Effects\n"
      "with states that come back by themselves (a lag, creep) bring these along; camera effects are left out of the\n"
      "outputs. What sticks, and faces that are pressed, are told on standard error. Whether the parts bear the "
      "current:\n"
      "evaluate. Coils and magnets are at 20 degC.\n\n"
      "Example:\n"
      "  coilwright linearise configs/actuators/paper_finger.json --current-A 1.4 --out linear.json\n"
      "  coilwright linearise configs/actuators/paper_finger.json --current-A 1.4 -0.3");
  command->callback([options] { run_linearise(*options); });
}

}  // namespace coilwright::cli
