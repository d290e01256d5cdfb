#include <glog/logging.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/formats/data/experiment_file.hpp"
#include "coilwright/formats/data/plan_json.hpp"
#include "coilwright/measurement/experiment/experiment_plan.hpp"
#include "coilwright/report/plan_text.hpp"
#include "coilwright/text/input_error.hpp"
#include "commands.hpp"
#include "end_on_signal.hpp"
#include "number_rule.hpp"
#include "threads_option.hpp"

namespace coilwright::cli {
namespace {

struct Options {
  std::string experiment;
  std::string actuator;
  std::vector<std::string> calibrate{"joint_stiffness", "joint_damping"};  // as a data set that names none
  std::vector<std::string> noise;                                          // "angle_deg=0.3"
  std::uint64_t seed = 1;
  int threads = 0;
  bool exact{false};
  bool json{false};
};

measurement::experiment::ExperimentPlan plan(const Options& options) {
  const EndOnSignal nothing_to_save;
  // A model that cannot be simulated is an answer here.
  FLAGS_minloglevel = google::GLOG_FATAL;
  const formats::DeclaredActuator rig = formats::read_declared_actuator(
      options.actuator, {.names = options.calibrate,
                         .file = "--calibrate",
                         .tolerances = options.exact ? formats::Tolerances::exact() : formats::Tolerances{}});
  measurement::experiment::Experiment experiment = formats::read_experiment(options.experiment);
  for (const std::string& argument : options.noise) formats::set_noise(experiment.instruments, argument);
  try {
    return measurement::experiment::plan_experiment(experiment, rig.model,
                                                    {.threads = options.threads, .seed = options.seed});
  } catch (const std::invalid_argument& misfit) {
    throw text::InputError({.file = options.experiment, .rule = misfit.what()});
  } catch (const std::runtime_error& lost) {
    throw text::InputError({.file = options.experiment, .rule = lost.what()});
  }
}

void print(const Options& options) {
  const measurement::experiment::ExperimentPlan planned = plan(options);
  const formats::PlanReport report{.plan = planned, .experiment = options.experiment, .actuator = options.actuator};
  std::cout << (options.json ? formats::to_json(report).text() : report::to_text(report));
}

}  // namespace

void add_plan_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("plan", "Tell what an experiment could show, before anything is recorded");
  command
      ->add_option("EXPERIMENT.json", options->experiment,
                   "Runs to record and the instruments that record them (experiment/1)")
      ->required();
  command
      ->add_option("--actuator", options->actuator,
                   "File of a design (actuator/1) or of a lumped model (lumped-model/1)")
      ->required();
  command
      ->add_option(
          "--calibrate", options->calibrate,
          "Number that the diagnosis will recalibrate, as a data set names it; may be repeated; replaces the default "
          "(default joint_stiffness and joint_damping)")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--noise", options->noise,
          "QUANTITY=VALUE: standard deviation of the noise of one instrument, for example angle_deg=0.3; overrides the "
          "experiment's; may be repeated")
      ->allow_extra_args(false);
  command->add_flag("--exact", options->exact, "Take every declared number as exact, without its default tolerance")
      ->disable_flag_override();
  command->add_option("--seed", options->seed, "Random seed for the noise (default 1)")
      ->check(number_rule(text::Rule::between(0, 9007199254740992.0)));
  add_threads_option(*command, options->threads, "Number of simulations that run at the same time");
  command->add_flag("--json", options->json, "Print JSON instead of a table")->disable_flag_override();
  command->footer(
      "Prints for each effect the smallest strength that a diagnosis of these runs would name, or have in the set of\n"
      "those that it cannot tell apart, in four of five records; the pairs of effects that it cannot separate; and "
      "the\n"
      "run that would help most if it were added. Nothing is recorded and no file is written.\n\n"
      "Example:\n"
      "  coilwright plan configs/experiments/paper.json --actuator configs/actuators/paper_finger.json");
  command->callback([options] { print(*options); });
}

}  // namespace coilwright::cli
