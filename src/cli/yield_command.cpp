#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/formats/actuator/actuator_argument.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/study/size_json.hpp"
#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/report/yield_text.hpp"
#include "coilwright/sizing/study/yield.hpp"
#include "coilwright/text/argument.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/document.hpp"
#include "commands.hpp"
#include "options.hpp"
#include "study_run.hpp"

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
  bool quiet = false;
  bool json = false;
};

// The numbers of blocks that the study varies, of which nothing else says what the design has.
void require_settings(const sizing::Study& study, const YieldCommandOptions& options) {
  for (const sizing::StudyVariable& variable : study.variables) {
    if (!std::holds_alternative<sizing::SettingVariable>(variable)) continue;
    const std::string name = name_of(variable);
    const std::string pointer = formats::block_pointer(name).value();
    const bool is_given = std::ranges::any_of(options.changes, [&](const std::string& change) {
      return change.starts_with(name + "=") || change.starts_with(pointer + "=");
    });
    if (!is_given)
      throw text::InputError(
          {.file = options.study,
           .place = "/variables/" + name,
           .rule = fmt::format("needs --set {}=VALUE: the study varies it, and no actuator's file says "
                               "what it is",
                               name)});
  }
}

// Of a study that says itself which current flows.
std::string way_to_another_current(const sizing::Study& study) {
  if (std::holds_alternative<sizing::DrivenCurrent>(study.current))
    return "another cell drives another one: --set crawler_cell_voltage_V=VALUE";
  const bool is_share = std::holds_alternative<sizing::ShareOfLimit>(study.current);
  return fmt::format("--set /operating_point/{}=VALUE changes it", is_share ? "share_of_current_limit" : "current_A");
}

// Whatever the study varies stands still: its actuator is the one given, at the current that its file states.
sizing::Study study_of_one(const YieldCommandOptions& options) {
  require_names_once(options.changes);
  const text::InputText actuator = text::read_text(options.actuator, text::json_size_limit);
  const text::InputText file = text::read_text(options.study, text::json_size_limit);
  std::vector<std::string> of_study;
  std::vector<std::string> of_actuator;
  // What a block's variable is, no actuator's file says: "driver_voltage_V=8" is /driver/voltage_V=8 of the study.
  for (const std::string& change : options.changes)
    if (const std::optional<std::string> of_block = formats::block_pointer(change))
      of_study.push_back(*of_block);
    else
      (change.starts_with('/') ? of_study : of_actuator).push_back(change);
  sizing::Study study = formats::parse_study(file.text, file.file, {.changes = of_study, .actuator = &actuator});
  require_settings(study, options);
  for (const std::string& change : of_actuator) study.base = formats::with_assignment(std::move(study.base), change);
  if (!study.spread)
    throw text::InputError({.file = file.file,
                            .rule = "needs the block \"spread\" ({\"parts\": \"usual\"}): without one every build is "
                                    "the design"});
  if (!std::holds_alternative<sizing::VariedCurrent>(study.current)) {
    if (options.current)
      throw text::argument_error("--current-A", "must not be given: the study itself says which current flows; " +
                                                    way_to_another_current(study));
    return study;
  }
  const formats::ActuatorFile given = formats::parse_actuator(actuator.text, actuator.file);
  if (!options.current && !given.operating_point)
    throw text::InputError({.file = actuator.file,
                            .place = "/operating_point",
                            .rule = "must be there, or --current-A: the study varies the current, and does not say "
                                    "with which one"});
  std::erase_if(study.variables, [](const sizing::StudyVariable& variable) {
    return std::holds_alternative<sizing::CurrentVariable>(variable);
  });
  study.current = sizing::FixedCurrent{options.current ? *options.current : given.operating_point->current};
  return study;
}

ExitCode run_yield(const YieldCommandOptions& options) {
  const sizing::Study study = study_of_one(options);
  const sizing::DesignResult design = sizing::DesignProblem(study).evaluate_base();
  if (const auto* none = std::get_if<sizing::NotEvaluated>(&design))
    throw text::InputError({.file = options.actuator, .rule = none->reason});
  const Interruption interruption;
  const std::optional<sizing::Yield> yield = yield_with_progress(study, std::get<sizing::EvaluatedDesign>(design),
                                                                 {.builds = options.builds,
                                                                  .worth_builds = options.worth_builds,
                                                                  .seed = options.seed,
                                                                  .threads = static_cast<unsigned>(options.threads),
                                                                  .stop = interruption.token()},
                                                                 options.quiet);
  if (yield) std::cout << (options.json ? formats::to_json(*yield).text() : report::to_text(*yield)) << std::flush;
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
  CLI::App* command = app.add_subcommand("yield", "Build a design many times by dice: how many keep a study's limits");
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
  command->footer(
      "Every number of the study's spread is drawn anew for each build, by dice that know nothing of those by which a\n"
      "search has judged; a limit on a statistic (p95_mass_g <= 70) is held against each build's own "
      "figure\n"
      "(mass_g <= 70), one on a mean or a deviation against none. Prints 5, 50 and 95 % of each objective and limit, "
      "and how many builds keep each limit and "
      "all.\n"
      "With --worth also Sobol's indices, and what half of each scatter would bring. What the spread leaves out (an\n"
      "effect that nobody knows) is not in it. Ctrl-C prints what the builds made so far say, and the scatters\n"
      "whose builds are complete; the exit code is then 130.\n\n"
      "Example:\n"
      "  coilwright yield configs/studies/robust_finger.json results/robust_finger/actuator.json");
  command->callback([options, &outcome] { outcome.code = run_yield(*options); });
}

}  // namespace coilwright::cli
