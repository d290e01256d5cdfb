#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "coilwright/actuator/modelling_choices.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/simulation/performance_json.hpp"
#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/report/simulation/correction_text.hpp"
#include "coilwright/report/size_text.hpp"
#include "coilwright/simulation/correction_reach.hpp"
#include "coilwright/sizing/search/search.hpp"
#include "coilwright/sizing/study/yield.hpp"
#include "coilwright/text/output/output_folder.hpp"
#include "commands.hpp"
#include "found_designs.hpp"
#include "options.hpp"
#include "part_run.hpp"
#include "progress_line.hpp"
#include "report_option.hpp"
#include "run_archive.hpp"
#include "study_run.hpp"

namespace coilwright::cli {
namespace {

using sizing::DesignProblem;
using sizing::DesignResult;
using sizing::EvaluatedDesign;

// The answer is checked where it will be used: the text of actuator.json is read back, evaluated at the operating point
// found, and held against every limit.
void check_written_design(const std::string& text, const sizing::Study& study, const EvaluatedDesign& found) {
  const formats::ActuatorFile file = formats::parse_actuator(text, "actuator.json");
  EvaluatedDesign again = simulation::evaluate(std::get<actuator::Design>(file.content), file.operating_point.value());
  again.settings = found.settings;  // no part of an actuator's file
  for (const sizing::Limit& limit : study.limits) {
    const std::optional<double> value = limit.quantity.value(again.view());
    if (!value || !(margin(limit, *value) >= 0.0))
      throw std::logic_error(
          fmt::format("the design found does not keep {} when it is read back and evaluated again", name_of(limit)));
  }
}

void write_results(text::OutputFolder& folder, const DesignProblem& problem, const formats::SizeReport& answer) {
  folder.write("result.json", formats::to_json(answer).text());
  formats::write_evaluations(folder.open("evaluations.csv"), problem.study(), answer.result.archive.records());
  formats::write_convergence(folder.open("convergence.csv"), answer.result.archive);
  if (!answer.result.best) {
    folder.remove("actuator.json");
  } else {
    const std::string& study = problem.study().name;
    const std::string text = design_text(problem, answer.result.best->point, *answer.best,
                                         answer.result.feasible ? study : study + " (least infeasible)");
    if (answer.result.feasible) check_written_design(text, problem.study(), std::get<EvaluatedDesign>(*answer.best));
    folder.write("actuator.json", text);
  }
  folder.commit("result.json");
}

struct Assumptions {
  std::vector<sizing::AssumptionEffect> effects{};
  std::size_t left{};  // choices that were not looked at
};

// Only of an answer: what keeps no limit anyway rests on more than a choice.
Assumptions assumptions_of(const DesignProblem& problem, const sizing::SearchResult& result,
                           archive::RecordedStudy& recorded, const Interruption& interruption, bool quiet) {
  if (!result.feasible) return {};
  const std::size_t choices = actuator::other_choices(problem.study().base).size();
  const bool wanted = problem.study().search.afterwards != sizing::Afterwards::nothing;
  if (!wanted || interruption.requested()) return {.left = choices};
  std::atomic<std::size_t> looked_at = 0;
  const ProgressLine::Place place = progress_place(quiet);
  const ProgressLine line(std::cerr, place, progress_interval(place), [&] {
    return fmt::format("the design is found; what it rests on: {} of {} modelling choices", looked_at.load(), choices);
  });
  sizing::AssumptionOptions options{
      .search = problem.study().search,
      .evaluate =
          [&](const DesignProblem& other, const actuator::OtherChoice& choice, std::span<const double> point) {
            return recorded.evaluate_under(sizing::name_of(choice), other, point);
          },
      .progress = [&](std::size_t done, std::size_t) { looked_at = done; }};
  // A search that may take few evaluations is not followed by ones of many. One of builds is not searched again: that
  // would cost three times the search, and the choices may stand in the spread itself.
  options.evaluations = problem.study().spread ? 0 : std::min(options.evaluations, options.search.max_evaluations);
  options.search.stop = interruption.token();
  Assumptions out{.effects = sizing::assumption_effects(problem, *result.best, options)};
  out.left = choices - out.effects.size();
  return out;
}

// Of an answer, what builds make of it that the search has not seen.
std::optional<sizing::Yield> built_of(const DesignProblem& problem, const sizing::SearchResult& result,
                                      const std::optional<DesignResult>& best, const Interruption& interruption,
                                      bool quiet) {
  const sizing::Study& study = problem.study();
  if (!study.spread || !result.feasible || study.search.afterwards == sizing::Afterwards::nothing) return std::nullopt;
  return yield_with_progress(study, std::get<EvaluatedDesign>(*best),
                             {.builds = formats::builds_of_answer,
                              .seed = study.search.seed,
                              .threads = study.search.threads,
                              .stop = interruption.token()},
                             quiet, "the design is found; ");
}

// Where a nameless correction of the actuator is used by the design found; empty without one.
std::vector<simulation::CorrectionReach> reach_of(const std::optional<DesignResult>& best) {
  const auto* evaluated = best ? std::get_if<EvaluatedDesign>(&*best) : nullptr;
  if (evaluated == nullptr) return {};
  const simulation::DesignView view = evaluated->view();
  return simulation::correction_reach(view.assembly.model, view.performance.cold, view.point.current);
}

ExitCode end_size_part(text::OutputFolder& folder, formats::PartFile part, const sizing::SearchResult& result,
                       std::uint64_t seed) {
  formats::SearchPart found{.seed = seed,
                            .stop_reason = std::string(sizing::name_of(result.stop_reason)),
                            .evaluations = result.search_evaluations,
                            .feasible = result.feasible};
  if (result.best)
    found.found.push_back(
        {.index = result.best->number, .point = result.best->point, .evaluation = result.best->evaluation});
  part.results = formats::to_json(found);
  write_part(folder, part);
  return ExitCode::done;
}

ExitCode run_size(const StudyOptions& options, const PartOptions& part_options) {
  StudyInput input =
      read_study(options, {.least = 1, .most = 1, .rule = "must be one for size (pareto takes two or three)"});
  input.provenance.command = "size";
  std::optional<formats::PartFile> part = begin_search_part(part_options, input.provenance, input.study);
  const DesignProblem problem(std::move(input.study));
  input.provenance.seed = problem.study().search.seed;
  const Interruption interruption;
  text::OutputFolder folder(options.out);
  RunArchive archive(options, input, problem, problem.study().search.max_evaluations, folder);
  sizing::SearchResult result = [&] {
    const ProgressLine line =
        progress_line(options, archive.study(), problem.study(), problem.study().search.max_evaluations);
    sizing::SearchOptions search = problem.study().search;
    search.stop = interruption.token();
    return sizing::search(archive.study().problem(), search);
  }();
  const std::optional<DesignResult> best =
      result.best ? std::optional(evaluated_again(problem, result.best->point, result.best->evaluation)) : std::nullopt;
  const DesignResult base = problem.evaluate_base();
  const sizing::Evaluation base_seen = problem.assess(base);
  std::optional<sizing::Yield> built = built_of(problem, result, best, interruption, options.quiet);
  const Assumptions assumptions = assumptions_of(problem, result, archive.study(), interruption, options.quiet);
  if (interruption.requested()) result.stop_reason = sizing::StopReason::interrupted;
  const formats::SizeReport answer{.study = problem.study(),
                                   .result = result,
                                   .best = best ? &*best : nullptr,
                                   .base = base,
                                   .base_seen = base_seen,
                                   .assumptions = assumptions.effects,
                                   .assumptions_left = assumptions.left,
                                   .built = std::move(built)};
  archive.write_results([&] {
    folder.write(provenance_name, to_json(input.provenance).text());
    folder.remove(part_name);
    write_results(folder, problem, answer);
  });
  archive.end(sizing::name_of(result.stop_reason), interruption, result.archive.records());
  const std::vector<simulation::CorrectionReach> reach = reach_of(best);
  if (part) {
    // merge says what came out.
  } else if (options.json) {
    text::Json out = formats::to_json(answer);
    if (!reach.empty()) out.set("torque_correction", formats::to_json(reach));
    std::cout << out.text();
  } else {
    std::cout << report::to_text(answer) << report::to_text(reach);
  }
  archive.require_written();
  if (interruption.requested()) return ExitCode::interrupted;
  if (part) return end_size_part(folder, *std::move(part), result, problem.study().search.seed);
  return result.feasible ? ExitCode::done : ExitCode::infeasible;
}

}  // namespace

void add_size_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<StudyOptions>();
  auto part = std::make_shared<PartOptions>();
  CLI::App* command =
      app.add_subcommand("size", "Find the best design of a study with one objective, and what limits it");
  add_study_options(*command, *options);
  add_search_options(*command, *options);
  add_flag(
      *command, "--answer-only", options->answer_only,
      fmt::format("End with the search: leave out what a step of each variable and a relaxed limit would bring "
                  "(up to some hundred evaluations more), and what becomes of the answer under each other "
                  "modelling choice (up to {} each; of a study with a spread one each), and what {} builds make of the "
                  "answer to a study with a spread",
                  sizing::AssumptionOptions().evaluations, formats::builds_of_answer));
  command->footer(
      "Writes result.json (everything that is printed, and more), actuator.json (the design, an input of\n"
      "evaluate and simulate), evaluations.csv (every design that was evaluated, with every quantity) and\n"
      "convergence.csv (the best value after so many evaluations) and provenance.json (program, files and seed). If no "
      "design keeps all limits, the least\n"
      "infeasible design is written and the exit code is 3. Ctrl-C writes what was found so far; the exit code\n"
      "is then 130. Every evaluation is recorded in archive.sqlite as it is made: --resume goes on from there, after\n"
      "Ctrl-C and after a crash.\n\n"
      "Example:\n"
      "  coilwright size configs/studies/fastest_finger.json --out results/fastest_finger");
  auto report = std::make_shared<bool>(false);
  add_report_option(*command, *report);
  add_part_options(*command, *part, "Search by the K-th of N seeds, the first of which is --seed");
  command->callback([options, part, report, &outcome] {
    outcome.code = run_size(*options, *part);
    if (*report)
      write_report(options->out, std::filesystem::path(options->out) / report_name, {.force = options->force});
  });
}

}  // namespace coilwright::cli
