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
#include <new>
#include <optional>
#include <ratio>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/records/commands.hpp"
#include "cli/records/fit_record.hpp"
#include "cli/report_option.hpp"
#include "cli/runs/part_run.hpp"
#include "cli/runs/run_files.hpp"
#include "cli/signals.hpp"
#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "coilwright/report/diagnosis/phase_table.hpp"
#include "coilwright/results/diagnosis/asked_diagnosis.hpp"
#include "coilwright/results/diagnosis/diagnosis_files.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {
namespace {

using measurement::Diagnosis;

struct DiagnoseOptions {
  std::string dataset;
  std::optional<std::string> actuator;
  std::string out;
  int threads = 0;
  std::uint64_t seed = 1;
  double minutes = std::numeric_limits<double>::infinity();
  bool as_written{false};
  bool force{false};
  bool resume{false};
  bool quiet{false};
  bool json{false};
  std::optional<std::string> report{};
  PartOptions part{};
};

// Results among the data would be taken for data, or lie over them or the actuator that they declare.
void check_output(const DiagnoseOptions& options, const formats::DatasetFile& set,
                  const std::filesystem::path& declared) {
  std::error_code none;
  const std::filesystem::path folder = std::filesystem::path(set.file).parent_path();
  if (std::filesystem::equivalent(folder.empty() ? "." : folder, options.out, none))
    throw text::OutputError(options.out, "it is the folder of the data set", text::OutputError::Stage::preparing);
  std::vector<std::filesystem::path> inputs = set.run_files;
  inputs.insert(inputs.end(), {set.file, declared});
  keep_inputs(inputs, run_files_in(options.out));
  const bool goes_on = has_mark(std::filesystem::path(options.out) / "diagnosis.json", "\"diagnosis/1\"");
  // Whose an archive is, is told when it is opened; a page is in the way only where one is asked for.
  const bool in_folder = options.report && options.report->empty();
  const auto own = [&](std::string_view name) {
    return is_of_archive(name) || (goes_on && is_left_by("diagnose", name)) || (name == report_name && !in_folder);
  };
  keep_other_run(options.out, own, options.force);
  const std::filesystem::path page = std::filesystem::path(options.out) / report_name;
  if (in_folder && !options.force && !goes_on && exists(symlink_status(page, none))) throw other_content(page);
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

Diagnosis diagnose(const DiagnoseOptions& options, const results::AskedDiagnosis& asked, KnownSoFar& known,
                   std::shared_ptr<const measurement::replay::KnownFits> fits) {
  // Ceres tells standard error of every fit that it gives up; a hypothesis that cannot be simulated is no news here.
  FLAGS_minloglevel = google::GLOG_FATAL;
  measurement::DiagnosisOptions how{.threads = options.threads, .as_written = options.as_written};
  // No progress: without a warning a wrong unit shows by nothing but a long wait.
  if (!options.json)
    how.warn = [](const measurement::data::Warning& each) {
      std::cerr << "warning: " << each.run << ": " << each.text << '\n';
    };
  how.known_fits = std::move(fits);
  how.known = [&known](const Diagnosis& so_far) { known.set(so_far); };
  if (!options.quiet) how.progress = [](const std::string& line) { std::cerr << line << '\n'; };
  return results::diagnose(asked, std::move(how));
}

results::AskedDiagnosis read_asked(const DiagnoseOptions& options) {
  results::AskedDiagnosis asked = results::read_asked(options.dataset, options.actuator, options.seed);
  check_output(options, asked.set, asked.declared_file);
  return asked;
}

void write(const DiagnoseOptions& options, const results::AskedDiagnosis& asked, const Diagnosis& diagnosis,
           const FitRecord& record) {
  const results::DiagnosisAnswer answer = results::answer_of(diagnosis, asked);
  // Before anything is written, so that no disk can lose it.
  if (!options.part.part) std::cout << (options.json ? answer.json : answer.summary) << std::flush;
  try {
    text::OutputFolder folder(options.out);
    remove_other_run(folder, "");
    if (record.path.empty()) remove_other_archive(folder);
    results::write_diagnosis(diagnosis, asked, answer, folder);
  } catch (const text::OutputError& refusal) {
    throw std::runtime_error(refusal.what());  // the work is done, wherever the disk refuses
  }
}

// Writes what is known, if anything is, before an error of the work ends the command by what this says of both.
std::string with_what_is_known(const DiagnoseOptions& options, const results::AskedDiagnosis& asked,
                               const std::optional<Diagnosis>& known, const FitRecord& record, std::string_view why) {
  if (known) write(options, asked, *known, record);
  return fmt::format("{}: {}{}", why,
                     known ? fmt::format("{} has what is known so far, marked as incomplete", options.out)
                           : std::string("nothing is known yet"),
                     record.known_fits ? "; --resume goes on from the fits that had ended" : "");
}

// What is known is written, and the work, which knows nothing of signals and limits, ends with the program.
[[noreturn]] void end_interrupted(const DiagnoseOptions& options, const results::AskedDiagnosis& asked,
                                  const std::optional<Diagnosis>& known, const FitRecord& record,
                                  std::string_view why) {
  ExitCode code = ExitCode::interrupted;
  try {
    std::cerr << "coilwright: " << with_what_is_known(options, asked, known, record, why) << '\n';
  } catch (const std::exception& reason) {
    std::cerr << "coilwright: " << reason.what() << '\n';
    code = ExitCode::failure;
  }
  std::_Exit(static_cast<int>(code));
}

// What the answer depends on beside files and seed.
std::string way_of(const DiagnoseOptions& options) {
  return options.as_written ? "--as-written" : "guarded against slips";
}

// One of many sets, which have nothing in common but the program and how it is asked.
formats::PartFile part_of(const DiagnoseOptions& options) {
  const results::Provenance question{.command = "diagnose", .seed = options.seed};
  return {.part = options.part.part.value(),
          .whole = whole_of(question, "data sets", way_of(options)),
          .machine = this_machine()};
}

void run_diagnose(const DiagnoseOptions& options) {
  const StopSignal stop;
  const results::AskedDiagnosis asked = read_asked(options);
  std::optional<formats::PartFile> part;
  if (options.part.part) {
    part = part_of(options);
    require_figures_of_head(options.part, part->machine);
  }
  FitRecord record = open_fit_record(options.out, asked.provenance, way_of(options),
                                     options.force    ? Begin::force
                                     : options.resume ? Begin::resume
                                                      : Begin::anew);
  KnownSoFar known;
  std::future<Diagnosis> work =
      std::async(std::launch::async, [&, fits = record.known_fits] { return diagnose(options, asked, known, fits); });
  const auto end = [&](std::string_view why) {
    record.unlock();
    end_interrupted(options, asked, known.get(), record, why);
  };
  const auto failure = [&](std::string_view why) {
    record.unlock();
    return std::runtime_error(with_what_is_known(options, asked, known.get(), record, why));
  };
  constexpr std::chrono::milliseconds soon{50};
  using Minutes = std::chrono::duration<double, std::ratio<60>>;
  const auto begun = std::chrono::steady_clock::now();
  while (work.wait_for(soon) != std::future_status::ready) {
    if (stop.requested()) end("interrupted");
    if (Minutes(std::chrono::steady_clock::now() - begun).count() > options.minutes)
      end(fmt::format("stopped after {:g} minutes", options.minutes));
  }
  const Diagnosis diagnosis = [&] {
    try {
      return work.get();
    } catch (const text::InputError& fault) {
      if (known.get()) throw failure(fault.what());
      record.discard();
      throw;
    } catch (const std::bad_alloc&) {
      throw;  // what is known could be written only in part
    } catch (const std::exception& reason) {
      if (known.get()) throw failure(reason.what());
      throw;
    }
  }();
  if (!options.quiet) std::cerr << report::to_text(diagnosis.phases);
  record.unlock();
  write(options, asked, diagnosis, record);
  record.remove();
  if (!part) return;
  text::OutputFolder folder(options.out);
  write_part(folder, *std::move(part));
}

}  // namespace

void add_diagnose_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<DiagnoseOptions>();
  CLI::App* command = add_command(app, "diagnose");
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
  add_flag(
      *command, "--resume", options->resume,
      "Go on from the fits that are recorded in the folder of a diagnosis that was cut short; begin where it holds "
      "none")
      ->excludes("--force");
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
      "corrected_actuator.json with that torque. Files of an earlier diagnosis in the folder are replaced, those of\n"
      "another run only with --force. The exit code is 0 for every verdict. Ctrl-C, and --minutes, write what is known "
      "so far\n"
      "(the recalibrated model, the odds of what was compared) with the verdict \"incomplete\"; the exit code is then "
      "130, and --resume goes on from the fits that had ended.\n\n"
      "Example:\n"
      "  coilwright diagnose studies/undeclared_effect/data --out results/undeclared_effect");
  add_report_option(*command, options->report);
  add_part_options(*command, options->part, "The data set is the K-th of N");
  command->callback([options] {
    require_page(options->report, options->out, options->force);
    run_diagnose(*options);
    write_report(options->report, options->out, options->force);
  });
}

}  // namespace coilwright::cli
