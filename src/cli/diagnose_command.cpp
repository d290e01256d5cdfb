#include <fmt/format.h>
#include <glog/logging.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "actuator_input.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/formats/data/expected_table.hpp"
#include "coilwright/formats/data/experiment_file.hpp"
#include "coilwright/formats/data/experiment_writer.hpp"
#include "coilwright/formats/data/residual_table.hpp"
#include "coilwright/measurement/corrected_model.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "coilwright/measurement/record_slip.hpp"
#include "coilwright/report/diagnosis_text.hpp"
#include "coilwright/report/phase_table.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_folder.hpp"
#include "commands.hpp"
#include "end_on_signal.hpp"
#include "file_rule.hpp"
#include "keep_inputs.hpp"
#include "number_rule.hpp"
#include "provenance.hpp"
#include "report_option.hpp"
#include "threads_option.hpp"

namespace coilwright::cli {
namespace {

using actuator::Effect;
using measurement::Diagnosis;

constexpr const char* diagnosis_name = "diagnosis.json";
constexpr const char* corrected_name = "corrected_actuator.json";
constexpr const char* residuals_name = "residuals.csv";
constexpr const char* summary_name = "summary.txt";
constexpr const char* next_name = "next_experiment.json";
constexpr const char* expected_name = "next_experiment.csv";

// The data set, the declared actuator, and every record.
Provenance provenance_of(const formats::DatasetFile& set, const std::filesystem::path& declared, std::uint64_t seed) {
  Provenance provenance{.command = "diagnose", .inputs = {record_of(set.file), record_of(declared)}, .seed = seed};
  for (const std::filesystem::path& run : set.run_files) provenance.inputs.push_back(record_of(run));
  return provenance;
}

struct DiagnoseOptions {
  std::string dataset;
  std::optional<std::string> actuator;
  std::string out;
  int threads = 0;
  std::uint64_t seed = 1;
  bool as_written{false};
  bool force{false};
  bool quiet{false};
  bool json{false};
  bool report{false};
};

std::filesystem::path declared_path(const DiagnoseOptions& options, const formats::DatasetFile& set) {
  if (options.actuator) return *options.actuator;
  if (set.actuator && std::filesystem::exists(*set.actuator)) return *set.actuator;
  if (set.actuator)
    throw text::InputError({.file = set.file,
                            .place = "/actuator",
                            .rule = "must name a file, from the folder of the data set on, or be given by --actuator",
                            .value = fmt::format("{}, which is not there", set.actuator->string())});
  throw text::InputError({.file = set.file, .rule = "names no \"actuator\"; one must be given with --actuator"});
}

// Results among the data would be taken for data, or lie over them or the actuator that they declare.
void check_output(const DiagnoseOptions& options, const formats::DatasetFile& set,
                  const std::filesystem::path& declared) {
  std::error_code none;
  const std::filesystem::path folder = std::filesystem::path(set.file).parent_path();
  if (std::filesystem::equivalent(folder.empty() ? "." : folder, options.out, none))
    throw text::OutputError(options.out, "it is the folder of the data set", text::OutputError::Stage::preparing);
  std::vector<std::filesystem::path> inputs = set.run_files;
  inputs.insert(inputs.end(), {set.file, declared});
  std::vector<const char*> names{diagnosis_name, actuator_name, corrected_name, residuals_name,
                                 summary_name,   next_name,     expected_name,  provenance_name};
  if (options.report) names.push_back(report_name);
  std::vector<std::filesystem::path> outputs;
  for (const char* name : names) outputs.push_back(std::filesystem::path(options.out) / name);
  keep_inputs(inputs, outputs);
  keep_results_of_others(options.out, names, "\"diagnosis/1\"", options.force);
  // Known before the work, whether it can be written.
  const text::OutputFolder trial(options.out);
}

// A set that does not fit its model, or a model that cannot be simulated, is bad data and not a failure of the program.
Diagnosis diagnose(const DiagnoseOptions& options, const formats::DatasetFile& set,
                   const formats::DeclaredActuator& declared, const std::filesystem::path& declared_file) {
  // Ceres tells standard error of every fit that it gives up; a hypothesis that cannot be simulated is no news here.
  FLAGS_minloglevel = google::GLOG_FATAL;
  measurement::DiagnosisOptions how{.threads = options.threads, .seed = options.seed, .as_written = options.as_written};
  // No progress: without a warning a wrong unit shows by nothing but a long wait.
  if (!options.json)
    how.warn = [](const measurement::data::Warning& each) {
      std::cerr << "warning: " << each.run << ": " << each.text << '\n';
    };
  if (!options.quiet) how.progress = [](const std::string& line) { std::cerr << line << '\n'; };
  try {
    return measurement::diagnose(set.data, declared.model, how);
  } catch (const measurement::RecordSlip& slip) {
    throw text::InputError({.file = set.file, .rule = fmt::format("{}; --as-written takes it as it is", slip.what())});
  } catch (const std::invalid_argument& misfit) {
    throw text::InputError({.file = set.file, .rule = misfit.what()});
  } catch (const std::runtime_error& lost) {
    throw text::InputError({.file = declared_file.string(), .rule = lost.what()});
  }
}

const std::vector<Effect>& effects_of(const formats::ActuatorFile& file) {
  if (const auto* design = std::get_if<actuator::Design>(&file.content)) return design->effects;
  return std::get<actuator::Model>(file.content).nominal_spec().effects;
}

// The files of actuators that were found, read back where they will be used.
struct FoundActuators {
  std::string updated;
  bool is_design{};
  std::string corrected;             // with the nameless correction; empty: none
  std::vector<std::string> refused;  // why a file is no input of other commands, a line each
};

// Whether every effect is there in an actuator that is read back.
void check_effects(const formats::ActuatorFile& back, const std::vector<Effect>& added) {
  const std::vector<Effect>& read = effects_of(back);
  for (const Effect& effect : added)
    if (std::ranges::find(read, effect.kind, &Effect::kind) == read.end())
      throw std::logic_error(fmt::format("{} is lost when the actuator is read back", effect.kind->id()));
}

FoundActuators found_actuators(const Diagnosis& diagnosis, const formats::DeclaredActuator& declared) {
  FoundActuators out;
  // A fit may go beyond what an actuator can be: its result is kept and says so, rather than being lost at the end.
  const auto read_back = [&](const std::string& text, const char* name, const std::vector<Effect>& added) {
    try {
      check_effects(formats::parse_actuator(text, name), added);
    } catch (const text::InputError& refusal) {
      out.refused.emplace_back(refusal.what());
    }
  };
  const std::vector<Effect> added = measurement::effects_of(diagnosis);
  const formats::UpdatedActuator updated = declared.updated(measurement::calibration_of(diagnosis), added);
  out.updated = formats::to_json(updated, declared.name).text();
  out.is_design = std::holds_alternative<actuator::Design>(updated);
  read_back(out.updated, actuator_name, added);
  if (const auto& found = diagnosis.correction.found) {
    formats::UpdatedActuator actuator = declared.updated(found->calibration, found->effects);
    std::visit([&](auto& content) { content.as_built.torque_correction = found->torque; }, actuator);
    out.corrected = formats::to_json(actuator, declared.name).text();
    read_back(out.corrected, corrected_name, found->effects);
  }
  return out;
}

// All that is to be written.
struct Found {
  Diagnosis diagnosis;
  std::string dataset;
  std::vector<std::string> held_out;
  FoundActuators actuators;
  std::string next_experiment;  // empty: there is none
  Provenance provenance;
};

// What is to be recorded next, checked where it will be used: its text is read back.
std::string next_experiment_text(const Diagnosis& diagnosis) {
  if (!diagnosis.next_experiment) return {};
  const measurement::experiment::NextExperiment& next = *diagnosis.next_experiment;
  const std::string description =
      fmt::format("Proposed by a diagnosis. The last runs are to be recorded: {}: {}.", next.input, next.why);
  std::string text = formats::experiment_json(next.experiment, description).text();
  (void)formats::parse_experiment(text, next_name);
  return text;
}

Found find(const DiagnoseOptions& options) {
  const EndOnSignal nothing_to_save;
  const formats::DatasetFile set = formats::read_dataset(options.dataset);
  const std::filesystem::path declared_file = declared_path(options, set);
  const formats::DeclaredActuator declared = formats::read_declared_actuator(
      declared_file, {.names = set.calibrate, .file = set.file, .tolerances = set.tolerances});
  check_output(options, set, declared_file);
  Provenance provenance = provenance_of(set, declared_file, options.seed);
  Diagnosis diagnosis = diagnose(options, set, declared, declared_file);
  if (!options.quiet) std::cerr << report::to_text(diagnosis.phases);
  FoundActuators actuators = found_actuators(diagnosis, declared);
  std::string next_experiment = next_experiment_text(diagnosis);
  return {.diagnosis = std::move(diagnosis),
          .dataset = set.data.name,
          .held_out = set.data.held_out,
          .actuators = std::move(actuators),
          .next_experiment = std::move(next_experiment),
          .provenance = std::move(provenance)};
}

void write(const DiagnoseOptions& options, const Found& found) {
  const formats::DiagnosisReport answer{.diagnosis = found.diagnosis,
                                        .dataset = found.dataset,
                                        .updated_actuator = actuator_name,
                                        .is_design = found.actuators.is_design,
                                        .corrected_actuator = found.actuators.corrected.empty() ? "" : corrected_name,
                                        .held_out = found.held_out,
                                        .seed = options.seed,
                                        .next_experiment_file = found.next_experiment.empty() ? "" : next_name,
                                        .refused = found.actuators.refused};
  text::OutputFolder folder(options.out);
  const std::string summary = report::to_text(answer);
  const std::string diagnosis = formats::to_json(answer).text();
  folder.write(diagnosis_name, diagnosis);
  folder.write(provenance_name, to_json(found.provenance).text());
  folder.write(actuator_name, found.actuators.updated);
  // One of an earlier diagnosis must not stand beside this one.
  if (found.actuators.corrected.empty())
    folder.remove(corrected_name);
  else
    folder.write(corrected_name, found.actuators.corrected);
  formats::write_residuals(folder.open(residuals_name), found.diagnosis.replays);
  folder.write(summary_name, summary);
  if (found.next_experiment.empty())
    folder.remove(next_name);
  else
    folder.write(next_name, found.next_experiment);
  // Where an explanation cannot be simulated in the proposed run, there is nothing to compare.
  if (found.diagnosis.next_experiment && !found.diagnosis.next_experiment->expected.empty())
    formats::write_expected_readings(folder.open(expected_name), *found.diagnosis.next_experiment);
  else
    folder.remove(expected_name);
  folder.commit();
  std::cout << (options.json ? diagnosis : summary);
}

}  // namespace

void add_diagnose_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<DiagnoseOptions>();
  CLI::App* command =
      app.add_subcommand("diagnose", "Identify which physical effect a model lacks, from measured data");
  command->add_option("DATASET_DIR", options->dataset, "Folder of a data set (measured-data/1)")->required();
  command
      ->add_option("--actuator", options->actuator,
                   "File of the declared model; overrides the one that the data set names")
      ->check(file_rule());
  command->add_option("--out", options->out, "Folder for the results; it is created if it does not exist")->required();
  add_threads_option(*command, options->threads, "Number of fits that run at the same time");
  command->add_option("--seed", options->seed, "Random seed for the additional fit starts (default 1)")
      ->transform(whole_number_rule(text::Rule::between(0, 9007199254740992.0)));
  command
      ->add_flag(
          "--as-written", options->as_written,
          "Fit records also where another unit or sign (radians, an exchanged lead, frame numbers) fits far better")
      ->disable_flag_override();
  add_force_option(*command, options->force);
  command->add_flag("--quiet", options->quiet, "Show no progress; warnings of the records remain")
      ->disable_flag_override();
  command->add_flag("--json", options->json, "Print diagnosis.json instead of the summary")->disable_flag_override();
  command->footer(
      "Prints a summary and writes five files: summary.txt; diagnosis.json (verdict, effects with 95 % intervals,\n"
      "errors, effects that fit as well, the next experiment); actuator.json (the corrected actuator, which the\n"
      "other commands read; crawl and a C header of reach refuse effects that act while they run); residuals.csv\n"
      "(every sample as measured, whether it was left out as an outlier, and as predicted by the declared, the\n"
      "recalibrated and the corrected model with the run's own clock and hum); provenance.json (program, files,\n"
      "seed). Where a run would separate what these data cannot, it also writes next_experiment.json (experiment/1,\n"
      "for plan and twin) and next_experiment.csv (what each explanation expects that run to show). Where no known\n"
      "effect explains all and a torque without a name explains more on runs left out, it also writes\n"
      "corrected_actuator.json with that torque. Files of an earlier diagnosis in the folder are replaced, others of\n"
      "these names only with --force. The exit code is 0 for every verdict. Ctrl-C writes nothing; the exit code is\n"
      "then 130.\n\n"
      "Example:\n"
      "  coilwright diagnose studies/undeclared_effect/data --out results/undeclared_effect");
  add_report_option(*command, options->report);
  command->callback([options] {
    write(*options, find(*options));
    if (options->report) write_report(options->out, std::filesystem::path(options->out) / report_name);
  });
}

}  // namespace coilwright::cli
