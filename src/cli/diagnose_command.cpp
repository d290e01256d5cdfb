#include <fmt/format.h>
#include <glog/logging.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <future>
#include <iostream>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <ratio>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "coilwright/measurement/records/record_slip.hpp"
#include "coilwright/report/phase_table.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_folder.hpp"
#include "commands.hpp"
#include "diagnosis_files.hpp"
#include "options.hpp"
#include "outputs.hpp"
#include "part_run.hpp"
#include "provenance.hpp"
#include "report_option.hpp"
#include "signals.hpp"

namespace coilwright::cli {
namespace {

using measurement::Diagnosis;

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
  double minutes = std::numeric_limits<double>::infinity();
  bool as_written{false};
  bool force{false};
  bool quiet{false};
  bool json{false};
  bool report{false};
  PartOptions part{};
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
  std::vector<const char*> names(diagnosis_files.begin(), diagnosis_files.end());
  if (options.report) names.push_back(report_name);
  std::vector<std::filesystem::path> outputs;
  for (const char* name : names) outputs.push_back(std::filesystem::path(options.out) / name);
  keep_inputs(inputs, outputs);
  keep_results_of_others(options.out, names, "\"diagnosis/1\"", options.force);
  // Known before the work, whether it can be written.
  const text::OutputFolder trial(options.out);
}

// What a diagnosis knows so far.
class KnownSoFar {
 public:
  void set(Diagnosis known) {
    const std::scoped_lock lock(mutex_);
    known_ = std::move(known);
  }
  [[nodiscard]] std::optional<Diagnosis> get() {
    const std::scoped_lock lock(mutex_);
    return known_;
  }

 private:
  std::mutex mutex_;
  std::optional<Diagnosis> known_;
};

// A set that does not fit its model, or a model that cannot be simulated, is bad data and not a failure of the program.
Diagnosis diagnose(const DiagnoseOptions& options, const formats::DatasetFile& set,
                   const formats::DeclaredActuator& declared, const std::filesystem::path& declared_file,
                   KnownSoFar& known) {
  // Ceres tells standard error of every fit that it gives up; a hypothesis that cannot be simulated is no news here.
  FLAGS_minloglevel = google::GLOG_FATAL;
  measurement::DiagnosisOptions how{.threads = options.threads, .seed = options.seed, .as_written = options.as_written};
  // No progress: without a warning a wrong unit shows by nothing but a long wait.
  if (!options.json)
    how.warn = [](const measurement::data::Warning& each) {
      std::cerr << "warning: " << each.run << ": " << each.text << '\n';
    };
  how.beliefs = set.beliefs;
  how.known = [&known](const Diagnosis& so_far) { known.set(so_far); };
  if (!options.quiet) how.progress = [](const std::string& line) { std::cerr << line << '\n'; };
  try {
    return measurement::diagnose(set.data, declared.model, how);
  } catch (const measurement::records::RecordSlip& slip) {
    throw text::InputError({.file = set.file, .rule = fmt::format("{}; --as-written takes it as it is", slip.what())});
  } catch (const std::invalid_argument& misfit) {
    throw text::InputError({.file = set.file, .rule = misfit.what()});
  } catch (const std::runtime_error& lost) {
    throw text::InputError({.file = declared_file.string(), .rule = lost.what()});
  }
}

// The data set and what it declares, read and checked before the work.
struct AskedDiagnosis {
  formats::DatasetFile set;
  std::filesystem::path declared_file;
  formats::DeclaredActuator declared;
  Provenance provenance;
};

AskedDiagnosis read_asked(const DiagnoseOptions& options) {
  formats::DatasetFile set = formats::read_dataset(options.dataset);
  std::filesystem::path declared_file = declared_path(options, set);
  formats::DeclaredActuator declared = formats::read_declared_actuator(
      declared_file, {.names = set.calibrate, .file = set.file, .tolerances = set.tolerances});
  check_output(options, set, declared_file);
  Provenance provenance = provenance_of(set, declared_file, options.seed);
  return {.set = std::move(set),
          .declared_file = std::move(declared_file),
          .declared = std::move(declared),
          .provenance = std::move(provenance)};
}

void write(const DiagnoseOptions& options, const AskedDiagnosis& asked, const Diagnosis& diagnosis) {
  const auto print = [&](const DiagnosisTexts& texts) {
    if (!options.part.part) std::cout << (options.json ? texts.json : texts.summary) << std::flush;
  };
  try {
    write_diagnosis(diagnosis, asked.set, asked.declared, asked.provenance, options.out, print);
  } catch (const text::OutputError& refusal) {
    throw std::runtime_error(refusal.what());  // the work is done, wherever the disk refuses
  }
}

// What is known is written, and the work, which knows nothing of signals and limits, ends with the program.
[[noreturn]] void end_interrupted(const DiagnoseOptions& options, const AskedDiagnosis& asked,
                                  const std::optional<Diagnosis>& known, std::string_view why) {
  ExitCode code = ExitCode::interrupted;
  try {
    if (known) write(options, asked, *known);
    std::cerr << "coilwright: " << why << ": "
              << (known ? fmt::format("{} has what is known so far, marked as incomplete", options.out)
                        : std::string("nothing is written"))
              << '\n';
  } catch (const std::exception& reason) {
    std::cerr << "coilwright: " << reason.what() << '\n';
    code = ExitCode::failure;
  }
  std::_Exit(static_cast<int>(code));
}

// One of many sets, which have nothing in common but the program and how it is asked.
formats::PartFile part_of(const DiagnoseOptions& options) {
  const Provenance question{.command = "diagnose", .seed = options.seed};
  return {.part = options.part.part.value(),
          .whole = whole_of(question, "data sets", options.as_written ? "--as-written" : "guarded against slips"),
          .machine = this_machine(),
          .results = options.dataset};
}

void run_diagnose(const DiagnoseOptions& options) {
  const StopSignal stop;
  const AskedDiagnosis asked = read_asked(options);
  std::optional<formats::PartFile> part;
  if (options.part.part) {
    part = part_of(options);
    require_figures_of_head(options.part, part->machine);
    std::filesystem::remove(std::filesystem::path(options.out) / part_name);
  }
  KnownSoFar known;
  std::future<Diagnosis> work = std::async(
      std::launch::async, [&] { return diagnose(options, asked.set, asked.declared, asked.declared_file, known); });
  constexpr std::chrono::milliseconds soon{50};
  using Minutes = std::chrono::duration<double, std::ratio<60>>;
  const auto begun = std::chrono::steady_clock::now();
  while (work.wait_for(soon) != std::future_status::ready) {
    if (stop.requested()) end_interrupted(options, asked, known.get(), "interrupted");
    if (Minutes(std::chrono::steady_clock::now() - begun).count() > options.minutes)
      end_interrupted(options, asked, known.get(), fmt::format("stopped after {:g} minutes", options.minutes));
  }
  const Diagnosis diagnosis = work.get();
  if (!options.quiet) std::cerr << report::to_text(diagnosis.phases);
  write(options, asked, diagnosis);
  if (!part) return;
  text::OutputFolder folder(options.out);
  write_part(folder, *part);
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
  add_seed_option(*command, options->seed, "Random seed for the additional fit starts (default 1)");
  add_flag(*command, "--as-written", options->as_written,
           "Fit records also where another unit or sign (radians, an exchanged lead, frame numbers) fits far better");
  add_number(*command, "--minutes", options->minutes, up_to(1e6),
             "Stop after this time, as Ctrl-C does, and write what is known so far (default: no limit)");
  add_force_option(*command, options->force);
  add_flag(*command, "--quiet", options->quiet, "Show no progress; warnings of the records remain");
  add_flag(*command, "--json", options->json, "Print diagnosis.json instead of the summary");
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
      "these names only with --force. The exit code is 0 for every verdict. Ctrl-C, and --minutes, write what is known "
      "so far\n"
      "(the recalibrated model, the odds of what was compared) with the verdict \"incomplete\"; the exit code is then "
      "130.\n\n"
      "Example:\n"
      "  coilwright diagnose studies/undeclared_effect/data --out results/undeclared_effect");
  add_report_option(*command, options->report);
  add_part_options(*command, options->part, "The data set is the K-th of N");
  command->callback([options] {
    run_diagnose(*options);
    if (options->report)
      write_report(options->out, std::filesystem::path(options->out) / report_name, {.force = options->force});
  });
}

}  // namespace coilwright::cli
