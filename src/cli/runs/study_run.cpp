#include "cli/runs/study_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <atomic>
#include <chrono>
#include <iostream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/options.hpp"
#include "cli/progress_line.hpp"
#include "cli/runs/start_designs.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/document.hpp"

namespace coilwright::cli {
namespace {

std::vector<std::string_view> algorithm_names() {
  std::vector<std::string_view> names;
  for (const sizing::Algorithm algorithm : sizing::algorithms()) names.push_back(sizing::name_of(algorithm));
  return names;
}

std::string algorithm_complaint(const std::string& name) {
  try {
    (void)sizing::algorithm_named(name);
  } catch (const std::invalid_argument& mistake) {
    return mistake.what();
  }
  return {};
}

}  // namespace

void add_study_options(CLI::App& command, StudyOptions& options) {
  command.add_option("STUDY.json", options.study, "File of a study (study/1)")->required();
  command.add_option("--out", options.out, "Folder for the results; it is created if it does not exist")->required();
  command
      .add_option("--set", options.changes,
                  "NAME=VALUE: change one number of the study's actuator, for example gap_mm=1.2, or, by its JSON "
                  "pointer, of the study: /constraints/0/at_most=60; may be repeated")
      ->allow_extra_args(false);
  add_threads_option(command, options.threads, "Number of designs evaluated at the same time");
  CLI::Option* resume = command.add_flag(
      "--resume", options.resume,
      "Go on with the run in the folder: what it recorded is not evaluated again, and the results are those of a run "
      "that was never interrupted. Where nothing is recorded, begin. What another version recorded is taken where this "
      "one gives three of its designs the same numbers");
  resume->disable_flag_override();
  add_flag(command, "--force", options.force, "Replace the results and the archive that the folder holds")
      ->excludes(resume);
  command
      .add_option("--reuse", options.reuse,
                  "Folder of another run of size, sweep or pareto with the same actuator, operating point and names of "
                  "variables: designs that its archive has are not evaluated again; may be repeated")
      ->allow_extra_args(false);
  add_flag(command, "--quiet", options.quiet, "Show no progress");
  add_json_option(command, options.json);
}

void add_search_options(CLI::App& command, StudyOptions& options) {
  add_seed_option(command, options.seed, "Random seed; overrides the study's");
  add_whole_number(
      command, "--max-evaluations", options.max_evaluations, text::Rule::between(1, 1e9),
      "Largest number of designs that the search evaluates; overrides the study's. What size looks at behind "
      "the search comes on top (--answer-only)");
  command
      .add_option("--algorithm", options.algorithm,
                  fmt::format("Search algorithm; overrides the study's (default automatic). One of {}",
                              fmt::join(algorithm_names(), ", ")))
      ->check(CLI::Validator(algorithm_complaint, ""));
  command
      .add_option("--start", options.starts,
                  "Folder of a run of size, pareto or sweep with the same names of variables: the best design in its "
                  "archive or, with several objectives, each of its front is evaluated right after the study's own "
                  "actuator, as a part of the search. Only the values of variables are taken; may be repeated")
      ->allow_extra_args(false);
}

StudyInput read_study(const StudyOptions& options, const formats::ObjectiveCount& objectives) {
  require_names_once(options.changes);
  const text::InputText file = text::read_text(options.study, text::json_size_limit);
  auto [study, actuator, posterior, builds_a_system] =
      formats::parse_study_file(file.text, file.file, {.changes = options.changes});
  formats::require_objectives(study, objectives, file.file);
  study.search.threads = static_cast<unsigned>(options.threads);
  if (options.seed) study.search.seed = *options.seed;
  if (options.max_evaluations) study.search.max_evaluations = *options.max_evaluations;
  if (options.answer_only) study.search.afterwards = sizing::Afterwards::nothing;
  if (options.algorithm) study.search.algorithm = sizing::algorithm_named(*options.algorithm);
  std::vector<results::InputRecord> inputs{results::record_of(file), results::record_of(actuator)};
  if (posterior) inputs.push_back(results::record_of(*posterior));
  StudyInput input{.study = std::move(study),
                   .provenance = {.inputs = std::move(inputs), .changes = options.changes},
                   .builds_a_system = builds_a_system};
  add_starts(options.starts, input);
  return input;
}

std::optional<sizing::Yield> yield_with_progress(const sizing::Study& study, const sizing::EvaluatedDesign& design,
                                                 sizing::YieldOptions how, bool quiet, std::string_view about) {
  std::atomic<std::size_t> built = 0;
  std::atomic<std::size_t> of = how.builds;
  how.progress = [&](std::size_t done, std::size_t all) {
    built = done;
    of = all;
  };
  const ProgressLine::Place place = progress_place(quiet);
  const ProgressLine line(std::cerr, place, progress_interval(place),
                          [&] { return fmt::format("{}{} of {} builds", about, built.load(), of.load()); });
  return sizing::yield_of(study, design, how);
}

// A signal handler may not ask a stop_source; this thread looks at the handler's flag for it.
Interruption::Interruption()
    : watch_([this](const std::stop_token& over) {
        using namespace std::chrono_literals;
        while (!over.stop_requested()) {
          if (signal_.requested()) {
            source_.request_stop();
            return;
          }
          std::this_thread::sleep_for(20ms);
        }
      }) {}

}  // namespace coilwright::cli
