#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <variant>

#include "actuator_input.hpp"
#include "coilwright/formats/simulation/performance_json.hpp"
#include "coilwright/report/simulation/performance_text.hpp"
#include "coilwright/simulation/performance.hpp"
#include "commands.hpp"
#include "number_rule.hpp"

namespace coilwright::cli {
namespace {

struct Options {
  ActuatorOptions actuator;
  double current{};
  double duty = 1.0;
  bool json{false};
};

std::runtime_error no_performance(const std::string& file, const simulation::NoPerformance& why) {
  return std::runtime_error(fmt::format("{}: {}", file, why.reason));
}

void evaluate(const actuator::Design& design, const Options& options) {
  const actuator::Assembly assembly = assemble(design, options.actuator);
  const simulation::OperatingPoint point{.current = options.current, .duty = options.duty};
  const auto result = simulation::performance_of(design, assembly, point);
  if (const auto* why = std::get_if<simulation::NoPerformance>(&result))
    throw no_performance(options.actuator.file, *why);
  const simulation::DesignView view{
      .design = design, .assembly = assembly, .point = point, .performance = std::get<simulation::Performance>(result)};
  std::cout << (options.json ? formats::to_json(view).text() : report::to_text(view));
}

void evaluate(const actuator::Model& model, const Options& options) {
  const auto result = simulation::motion_of(model, options.current);
  if (const auto* why = std::get_if<simulation::NoPerformance>(&result))
    throw no_performance(options.actuator.file, *why);
  const simulation::MotionSummary& motion = std::get<simulation::MotionSummary>(result);
  std::cout << (options.json ? formats::to_json(motion, options.current).text()
                             : report::to_text(motion, options.current));
}

}  // namespace

void add_evaluate_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("evaluate", "Compute what an actuator does at one current");
  add_actuator_options(*command, options->actuator);
  command->add_option("--current", options->current, "Current in every coil, A; a positive current bends the actuator")
      ->required()
      ->check(number_rule(text::Rule::between(-1e6, 1e6)));
  command
      ->add_option("--duty", options->duty,
                   "Fraction of the time for which the current is on, 0 to 1; affects only heat (default 1)")
      ->check(number_rule(text::Rule::between(0.0, 1.0)));
  command->add_flag("--json", options->json, "Print JSON instead of a table")->disable_flag_override();
  command->footer(
      "Angles, speed, overshoot and settling time describe a step of the current from rest. Temperatures are\n"
      "steady-state values for this current and duty.\n\n"
      "Examples:\n"
      "  coilwright evaluate configs/actuators/paper_finger.json --current 1.4 --json\n"
      "  coilwright evaluate configs/actuators/paper_finger.json --current 1.4 --set gap_mm=1.2 --set turns_axial=26");
  command->callback([options] {
    const formats::ActuatorFile file = read_actuator(options->actuator);
    std::visit([&](const auto& content) { evaluate(content, *options); }, file.content);
  });
}

}  // namespace coilwright::cli
