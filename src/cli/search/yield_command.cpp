#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/runs/part_run.hpp"
#include "cli/runs/run_files.hpp"
#include "cli/runs/study_run.hpp"
#include "cli/search/commands.hpp"
#include "cli/search/yield_study.hpp"
#include "coilwright/formats/study/part_file.hpp"
#include "coilwright/formats/study/size_json.hpp"
#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/report/yield_text.hpp"
#include "coilwright/results/provenance.hpp"
#include "coilwright/sizing/study/yield.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {
namespace {

struct YieldCommandOptions {
  std::string study;
  std::string actuator;
  std::vector<std::string> changes;
  std::optional<double> current;
  std::size_t builds = 1000;
  std::size_t worth_builds = 0;
  std::uint64_t seed = 1;
  int threads = 0;
  PartOptions part;
  std::string out;
  bool quiet = false;
  bool json = false;
  bool force = false;
};

YieldQuestion question_of(const YieldCommandOptions& options) {
  return {.study = text::read_text(options.study, text::json_size_limit),
          .actuator = text::read_text(options.actuator, text::json_size_limit),
          .changes = options.changes,
          .current = options.current};
}

// The study, the actuator and, of a spread that has one, the diagnosis.
results::Provenance yield_provenance(const YieldCommandOptions& options, const YieldQuestion& question) {
  results::Provenance out{.command = "yield",
                          .inputs = {results::record_of(question.study), results::record_of(question.actuator)},
                          .changes = options.changes,
                          .seed = options.seed};
  const formats::StudyFile file =
      formats::parse_study_file(question.study.text, question.study.file, {.actuator = &question.actuator});
  if (file.posterior) out.inputs.push_back(results::record_of(*file.posterior));
  return out;
}

ExitCode run_yield_part(const YieldCommandOptions& options, const YieldQuestion& question, const sizing::Study& study,
                        const sizing::EvaluatedDesign& design, const sizing::YieldOptions& how) {
  const std::string how_text =
      fmt::format("{} builds, --worth {}{}", options.builds, options.worth_builds,
                  options.current ? fmt::format(", --current-A {}", *options.current) : std::string());
  formats::PartFile part{.part = options.part.part.value(),
                         .whole = whole_of(yield_provenance(options, question), study.name, how_text),
                         .machine = this_machine(sizing::DesignProblem(study))};
  require_figures_of_head(options.part, part.machine);
  std::vector<std::filesystem::path> inputs;
  for (const archive::Input& input : part.whole.inputs) inputs.emplace_back(input.file);
  keep_inputs(inputs, run_files_in(options.out));
  text::OutputFolder folder(options.out);
  folder.lock();
  keep_other_run(folder.path(), "yield", options.force);
  const std::optional<std::vector<sizing::Build>> builds =
      sizing::builds_in(study, design, how, sizing::range_of(part.part, sizing::builds_of(study, how)));
  if (!builds) return ExitCode::interrupted;
  formats::write_builds(folder.open(builds_name), *builds);
  remove_other_run(folder, builds_name);
  if (options.force) remove_other_archive(folder);
  folder.commit();
  write_part(folder, std::move(part),
             formats::to_json(formats::YieldPart{
                 .builds = options.builds, .worth_builds = options.worth_builds, .current = options.current}));
  return ExitCode::done;
}

ExitCode run_yield(const YieldCommandOptions& options) {
  const YieldQuestion question = question_of(options);
  const sizing::Study study = study_of_one(question);
  const sizing::DesignResult design = sizing::DesignProblem(study).evaluate_base();
  if (const auto* none = std::get_if<sizing::NotEvaluated>(&design))
    throw text::InputError({.file = options.actuator, .rule = none->reason});
  const Interruption interruption;
  const auto& evaluated = std::get<sizing::EvaluatedDesign>(design);
  const sizing::YieldOptions how{.builds = options.builds,
                                 .worth_builds = options.worth_builds,
                                 .seed = options.seed,
                                 .threads = static_cast<unsigned>(options.threads),
                                 .stop = interruption.token()};
  if (options.part.part) return run_yield_part(options, question, study, evaluated, how);
  const std::optional<sizing::Yield> yield = yield_with_progress(study, evaluated, how, options.quiet);
  if (yield)
    std::cout << (options.json ? formats::to_json(*yield).text() : report::to_text(report::document_of(*yield)))
              << std::flush;
  if (!interruption.requested()) return ExitCode::done;
  std::string worths;
  if (options.worth_builds > 0 && (!yield || yield->worths.empty()))
    worths = ", and no scatter has its worth";
  else if (yield && yield->worths_left > 0)
    worths = fmt::format(", and {} of {} scatters have their worth", yield->worths.size(),
                         yield->worths.size() + yield->worths_left);
  std::cerr << fmt::format("coilwright: interrupted: {} of {} builds were made{}\n", yield ? yield->builds : 0,
                           options.builds, worths);
  return ExitCode::interrupted;
}

}  // namespace

void add_yield_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<YieldCommandOptions>();
  CLI::App* command = add_command(app, "yield");
  command->add_option("STUDY.json", options->study, "File of a study (study/1) with a spread")->required();
  command->add_option("ACTUATOR.json", options->actuator, "The design, as size writes it (actuator/1)")->required();
  command
      ->add_option(
          "--set", options->changes,
          "NAME=VALUE: change one number of the actuator, for example ambient_degC=30, or, by its JSON pointer, of the "
          "study: /spread/current_A/relative_uniform/1=0.05; may be repeated")
      ->allow_extra_args(false);
  add_number(
      *command, "--current-A", options->current, text::Rule::between(-1e6, 1e6),
      "Current in every coil, A, where the study varies it. Default: that of the operating_point of ACTUATOR.json");
  add_whole_number(*command, "--builds", options->builds, text::Rule::between(10, 1e7), "How many (default 1000)");
  add_whole_number(*command, "--worth", options->worth_builds, text::Rule::between(16, 1e6),
                   "Also say which scatter matters: builds of each of 2 N + 2 sums for N scatters; fewer than some "
                   "hundred leave wide intervals "
                   "(default: leave it out)");
  add_seed_option(*command, options->seed, "Random seed of the dice (default 1)");
  add_threads_option(*command, options->threads, "Number of builds evaluated at the same time");
  add_flag(*command, "--quiet", options->quiet, "Show no progress");
  add_json_option(*command, options->json);
  add_part_options(*command, options->part, "Make the K-th of N equal shares of the builds, those of --worth too");
  CLI::Option* out =
      command->add_option("--out", options->out, "Folder of the part; it is created if it does not exist")
          ->needs(command->get_option("--part"));
  add_force_option(*command, options->force);
  command->get_option("--force")->needs(out);
  command->get_option("--part")->needs(out);
  command->footer(
      "Every number of the study's spread is drawn anew for each build, by dice that know nothing of those by which a\n"
      "search has judged; a limit on a statistic (p95_mass_g <= 70) is held against each build's own "
      "figure\n"
      "(mass_g <= 70), one on a mean or a deviation against none. What lasts, as heat and lost magnetisation, is the\n"
      "worst of all uses of a build (rooms, walls, objects, charges of the spread); all else is of one use, by dice.\n"
      "Prints 5, 50 and 95 % of each objective and limit, and how many builds keep each limit and all.\n"
      "With --worth also Sobol's indices, and what half of each scatter would bring. What the spread leaves out (an\n"
      "effect that nobody knows) is not in it. Ctrl-C prints what the builds made so far say, and the scatters\n"
      "whose builds are complete; the exit code is then 130.\n\n"
      "Example:\n"
      "  coilwright yield configs/studies/robust_finger.json results/robust_finger/actuator.json");
  command->callback([options, &outcome] { outcome.code = run_yield(*options); });
}

}  // namespace coilwright::cli
