#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "cli/actuator_input.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/records/commands.hpp"
#include "cli/records/experiment_options.hpp"
#include "cli/runs/run_files.hpp"
#include "coilwright/formats/actuator/actuator_argument.hpp"
#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/formats/data/twin_answer.hpp"
#include "coilwright/measurement/planning/synthetic_data.hpp"
#include "coilwright/results/provenance.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {
namespace {

using actuator::Effect;
using measurement::data::Run;
using measurement::planning::Experiment;

struct TwinOptions {
  std::string actuator;
  ExperimentOptions experiment;
  std::vector<std::string> effects;  // "dry_friction:torque_Nmm=0.6"
  std::string out;
  bool force{false};
  bool json{false};
};

// The folder's name without a slash at its end, which would put its neighbour inside.
std::filesystem::path folder_of(const TwinOptions& options) {
  const std::filesystem::path out(options.out);
  // "." and "tw/.." have no name of their own to put an answer beside.
  const std::filesystem::path name = out.filename();
  if (name == "." || name == "..") return std::filesystem::weakly_canonical(out);
  return out.has_filename() ? out : out.parent_path();
}

std::vector<Run> act_out(const TwinOptions& options, const Experiment& experiment,
                         const measurement::replay::DeclaredModel& rig, const std::vector<Effect>& hidden) {
  return blaming_the_experiment(options.experiment, [&] {
    return measurement::planning::simulate_experiment(experiment, rig, hidden, options.experiment.seed);
  });
}

// Not in the folder: whoever gets that does not get the answer with it.
std::filesystem::path answer_file_of(const TwinOptions& options) {
  return folder_of(options) += ".answer.json";
}

// Writing over the actuator or the experiment would lose it.
void check_output(const TwinOptions& options, const Experiment& experiment) {
  const std::filesystem::path folder = folder_of(options);
  std::vector<std::filesystem::path> outputs{folder / actuator_name, folder / "dataset.json",
                                             folder / results::provenance_name, answer_file_of(options)};
  for (const auto& each : experiment.runs) {
    outputs.push_back(folder / each.plan.name);
    if (each.input_rate > 0.0) outputs.push_back(folder / formats::input_file_name(each.plan.name));
  }
  std::ranges::move(run_files_in(folder), std::back_inserter(outputs));
  keep_inputs({options.actuator, options.experiment.file}, outputs);
}

// What the clocks of the runs really were; none where they are one.
std::vector<formats::ClockOfRun> clocks_of(const TwinOptions& options, const Experiment& experiment) {
  std::vector<formats::ClockOfRun> out;
  const auto clocks = measurement::planning::true_clocks(experiment, options.experiment.seed);
  for (std::size_t i = 0; i < clocks.size(); ++i)
    if (clocks[i].shift != 0.0 || clocks[i].rate != 0.0)
      out.push_back({.run = experiment.runs[i].plan.name, .clock = clocks[i]});
  return out;
}

void write(const TwinOptions& options, const Experiment& experiment, const std::vector<Effect>& hidden,
           const std::vector<Run>& runs) {
  const std::filesystem::path out = folder_of(options);
  text::OutputFolder folder(out);
  const std::filesystem::path beside = answer_file_of(options);
  text::OutputFile answer(beside);
  answer.stream() << formats::to_json(formats::TwinAnswer{.dataset = out.filename().string(),
                                                          .actuator = options.actuator,
                                                          .experiment = options.experiment.file,
                                                          .effects = hidden,
                                                          .instruments = experiment.instruments,
                                                          .clocks = clocks_of(options, experiment),
                                                          .seed = options.experiment.seed})
                         .text();
  std::vector<formats::RunWithRole> in_roles;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    in_roles.push_back({.run = runs[i], .validate = experiment.runs[i].validate});
    formats::write_run(folder.open(runs[i].name), runs[i]);
    if (const auto input = formats::input_file_name(runs[i])) formats::write_input(folder.open(*input), runs[i]);
  }
  folder.write("dataset.json", formats::dataset_json(experiment.name, actuator_name, in_roles).text());
  folder.write(actuator_name, bytes_of(options.actuator));
  take_folder(folder, "dataset.json", options.force);
  keep_other(answer, options.force);
  keep_other_provenance(out, options.force);
  // Neither effects nor seed, by which they could be found.
  const results::Provenance provenance{
      .command = "twin", .inputs = {results::record_of(options.actuator), results::record_of(options.experiment.file)}};
  results::write_provenance(folder, provenance);
  answer.withdraw();
  folder.commit("dataset.json");
  answer.commit();
  std::size_t samples = 0;
  for (const Run& run : runs) samples += run.samples();
  if (options.json) {
    std::cout << text::Json::object({{"runs", runs.size()},
                                     {"samples", samples},
                                     {"folder", out.string()},
                                     {"answer", beside.string()}})
                     .text();
  } else {
    std::cout << fmt::format("{} runs, {} samples in {}; the answer is in {}\n", runs.size(), samples, printed(out),
                             printed(beside));
  }
}

void run_twin(const TwinOptions& options) {
  const formats::DeclaredActuator rig =
      formats::read_declared_actuator(options.actuator, {.names = {}, .file = options.actuator});
  const Experiment experiment = read_experiment(options.experiment);
  check_output(options, experiment);
  const std::vector<Effect> hidden =
      formats::parse_hidden_effects(options.effects, rig.model.build({}), options.actuator);
  const text::OutputFolder trial(folder_of(options));
  require_writable({answer_file_of(options)});
  write(options, experiment, hidden, act_out(options, experiment, rig.model, hidden));
}

}  // namespace

void add_twin_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<TwinOptions>();
  CLI::App* command = add_command(app, "twin");
  command
      ->add_option("ACTUATOR.json", options->actuator,
                   "File of a design (actuator/1) or of a lumped model (lumped-model/1)")
      ->required()
      ->check(file_rule());
  command
      ->add_option("--experiment", options->experiment.file,
                   "Runs to simulate and the instruments that record them (experiment/1)")
      ->required()
      ->check(file_rule());
  command
      ->add_option("--effect", options->effects,
                   "ID:KEY=VALUE,..: effect to simulate that is not declared in ACTUATOR.json; may be repeated")
      ->allow_extra_args(false);
  add_noise_and_seed(*command, options->experiment);
  command->add_option("--out", options->out, "Folder for the data set; it is created if it does not exist")->required();
  add_force_option(*command, options->force);
  add_json_option(*command, options->json, "text");
  command->footer(
      "Writes a data set (measured-data/1) into the folder: dataset.json, actuator.json as it was given, and one\n"
      "CSV file for each run, and provenance.json (program and files). The undeclared effects are written beside the "
      "folder, to DIR.answer.json. The same\n"
      "arguments give the same bytes.\n\n"
      "Example:\n"
      "  coilwright twin configs/actuators/paper_finger.json --experiment configs/experiments/paper.json \\\n"
      "    --effect dry_friction:torque_Nmm=0.6 --seed 7 --out results/twin");
  command->callback([options] { run_twin(*options); });
}

}  // namespace coilwright::cli
