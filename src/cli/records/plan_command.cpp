#include <glog/logging.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "cli/records/commands.hpp"
#include "cli/records/experiment_options.hpp"
#include "cli/signals.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/formats/data/plan_json.hpp"
#include "coilwright/measurement/planning/experiment_plan.hpp"
#include "coilwright/report/diagnosis/plan_text.hpp"

namespace coilwright::cli {
namespace {

struct PlanOptions {
  ExperimentOptions experiment;
  std::string actuator;
  std::vector<std::string> calibrate{"joint_stiffness", "joint_damping"};  // as a data set that names none
  int threads = 0;
  bool exact{false};
  bool json{false};
};

measurement::planning::ExperimentPlan plan(const PlanOptions& options) {
  const EndOnSignal nothing_to_save;
  // A model that cannot be simulated is an answer here.
  FLAGS_minloglevel = google::GLOG_FATAL;
  const formats::DeclaredActuator rig = formats::read_declared_actuator(
      options.actuator,
      {.names = options.calibrate,
       .file = "--calibrate",
       .tolerances = options.exact ? measurement::replay::Tolerances::exact() : measurement::replay::Tolerances{}});
  const measurement::planning::Experiment experiment = read_experiment(options.experiment);
  return blaming_the_experiment(options.experiment, [&] {
    return measurement::planning::plan_experiment(experiment, rig.model,
                                                  {.threads = options.threads, .seed = options.experiment.seed});
  });
}

void print(const PlanOptions& options) {
  const measurement::planning::ExperimentPlan planned = plan(options);
  const formats::PlanReport report{
      .plan = planned, .experiment = options.experiment.file, .actuator = options.actuator};
  std::cout << (options.json ? formats::to_json(report).text() : report::to_text(report));
}

}  // namespace

void add_plan_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<PlanOptions>();
  CLI::App* command = add_command(app, "plan");
  command
      ->add_option("EXPERIMENT.json", options->experiment.file,
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
  add_flag(*command, "--exact", options->exact, "Take every declared number as exact, without its default tolerance");
  add_noise_and_seed(*command, options->experiment);
  add_threads_option(*command, options->threads, "Number of simulations that run at the same time");
  add_json_option(*command, options->json);
  command->footer(
      "Prints for each effect the smallest strength that stands out of the noise of these runs in four of five "
      "records\n"
      "(a diagnosis needs up to twice that), the pairs of effects that a diagnosis could not separate, and the run "
      "that\n"
      "would help most if it were added. Nothing is recorded and no file is written.\n\n"
      "Example:\n"
      "  coilwright plan configs/experiments/paper.json --actuator configs/actuators/paper_finger.json");
  command->callback([options] { print(*options); });
}

}  // namespace coilwright::cli
