#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "cli/actuator_input.hpp"
#include "cli/model/evaluate_command.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/programs.hpp"
#include "cli/report_option.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/simulation/performance_json.hpp"
#include "coilwright/report/simulation/performance_text.hpp"
#include "coilwright/simulation/choice_effects.hpp"
#include "coilwright/simulation/correction_reach.hpp"
#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/simulation/performance.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::cli {
namespace {

struct EvaluateOptions {
  ActuatorOptions actuator;
  formats::OperatingWords said;
  std::optional<std::string> wiring{};
  bool json{false};
  std::optional<std::string> page{};
  bool force{false};
};

std::runtime_error no_performance(const std::string& file, const simulation::NoPerformance& why) {
  return std::runtime_error(fmt::format("{}: {}", file, why.reason));
}

simulation::OperatingPoint operating_point(const formats::ActuatorFile& file, const EvaluateOptions& options) {
  formats::OperatingWords said = options.said;
  if (options.wiring) said.wiring = *options.wiring == "series" ? actuator::Wiring::series : actuator::Wiring::parallel;
  return formats::operating_point_of(file, said, options.actuator.file, "give a current with --current-A");
}

void evaluate(const actuator::Design& design, const formats::ActuatorFile& file, const EvaluateOptions& options,
              const WriteEvaluationPage& write_page) {
  const simulation::OperatingPoint point = operating_point(file, options);
  const actuator::Assembly assembly = assemble(design, options.actuator);
  const auto result = [&] {
    try {
      return simulation::performance_of(design, assembly, point);
    } catch (const std::invalid_argument& mistake) {
      throw text::InputError({.file = options.actuator.file, .rule = mistake.what()});
    }
  }();
  if (const auto* why = std::get_if<simulation::NoPerformance>(&result))
    throw no_performance(options.actuator.file, *why);
  const simulation::DesignView view{
      .design = design, .assembly = assembly, .point = point, .performance = std::get<simulation::Performance>(result)};
  const std::vector<simulation::ChoiceEffect> effects = simulation::choice_effects(view);
  if (options.page || !options.json) {
    const report::Document document = report::document_of(view, effects);
    if (options.page)
      write_page({.design = design, .assembly = assembly, .point = point, .performance = view.performance}, document,
                 file.name, *options.page, options.force);
    if (!options.json) std::cout << report::to_text(document);
  }
  if (options.json) std::cout << evaluation_json(view, effects).text();
}

void evaluate(const actuator::Model& model, const formats::ActuatorFile& file, const EvaluateOptions& options,
              const WriteEvaluationPage&) {
  if (options.page)
    throw text::InputError({.file = options.actuator.file,
                            .rule = "is a lumped model: --report draws a design with its dimensions (actuator/1)"});
  const simulation::OperatingPoint point = operating_point(file, options);
  const auto result = simulation::motion_of(model, point.current, point.grasp);
  if (const auto* why = std::get_if<simulation::NoPerformance>(&result))
    throw no_performance(options.actuator.file, *why);
  const simulation::MotionSummary& motion = std::get<simulation::MotionSummary>(result);
  if (!options.json) {
    std::cout << report::to_text(report::document_of(model, motion, point.current));
    return;
  }
  const std::vector<simulation::CorrectionReach> reach = simulation::correction_reach(model, motion, point.current);
  text::Json out = formats::to_json(motion, point.current);
  if (!reach.empty()) out.set("torque_correction", formats::to_json(reach));
  std::cout << out.text();
}

}  // namespace

text::Json evaluation_json(const simulation::DesignView& view, std::span<const simulation::ChoiceEffect> effects) {
  text::Json out = formats::to_json(view);
  out.set("operating_point", formats::to_json(view.point));
  out.set("part_limits", formats::to_json(simulation::told_part_limits(view)));
  if (!effects.empty()) out.set("assumptions", formats::to_json(effects));
  const std::vector<simulation::CorrectionReach> reach =
      simulation::correction_reach(view.assembly.model, view.performance.cold, view.point.current);
  if (!reach.empty()) out.set("torque_correction", formats::to_json(reach));
  return out;
}

void add_evaluate(CLI::App& app, const Outcome& outcome, const WriteEvaluationPage& write_page) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* command = add_command(app, "evaluate");
  add_actuator_options(*command, options->actuator);
  add_number(*command, "--current-A,--current", options->said.current, text::Rule::between(-1e6, 1e6),
             "Current in every coil, A; a positive current bends the actuator. Default: that of the\n"
             "operating_point of ACTUATOR.json, which size writes");
  add_number(*command, "--duty", options->said.duty, text::Rule::between(0.0, 1.0),
             "Fraction of the time for which the current is on, 0 to 1; affects only heat. Default: likewise, or 1");
  add_number(*command, "--grasp-opening-deg", options->said.grasp_opening, text::Rule::between(0.0, 360.0),
             "Bending angle at which the free actuator would just touch the wall that grasp forces are taken at.\n"
             "Default: likewise, or 0: the straight actuator touches it");
  add_number(*command, "--grasp-height-mm", options->said.grasp_height, text::Rule::between(0.0, 1e6),
             "Where on the last segment it touches the wall, from that segment's joint. Default: likewise, or\n"
             "the tip");
  add_word(*command, "--wiring", options->wiring, {"parallel", "series"},
           "How the coils hang on the supply: parallel or series. Default: likewise, or parallel");
  add_number(*command, "--supply-resistance-Ohm,--supply-resistance", options->said.supply_resistance,
             text::Rule::between(0.0, 1e6), "Resistance inside the supply and its leads, Ohm. Default: likewise, or 0");
  add_number(*command, "--supply-voltage-V,--supply-voltage", options->said.supply_voltage,
             text::Rule::between(1e-6, 1e6),
             "Voltage of the supply without load, V; says whether it drives the current, and which at most");
  add_json_option(*command, options->json);
  add_report_file_option(*command, options->page, options->force);
  command->footer(
      "Angles, speed, overshoot and settling time describe a step of the current from rest. Temperatures are\n"
      "steady-state values for this current and duty.\n\n"
      "Examples:\n"
      "  coilwright evaluate configs/actuators/paper_finger.json --current-A 1.4 --json\n"
      "  coilwright evaluate configs/actuators/paper_finger.json --current-A 1.4 --set gap_mm=1.2 --set "
      "turns_axial=26");
  command->callback([options, &outcome, write_page] {
    if (options->page && !write_page) go_on_in("page", outcome.arguments);
    const std::string drawn = options->page.value_or("");
    keep_inputs({options->actuator.file}, {drawn});
    require_writable({drawn});
    const formats::ActuatorFile file = read_actuator(options->actuator);
    std::visit([&](const auto& content) { evaluate(content, file, *options, write_page); }, file.content);
  });
}

}  // namespace coilwright::cli
