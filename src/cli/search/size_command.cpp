#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "cli/options.hpp"
#include "cli/progress_line.hpp"
#include "cli/report_option.hpp"
#include "cli/runs/part_run.hpp"
#include "cli/runs/run_archive.hpp"
#include "cli/runs/run_files.hpp"
#include "cli/runs/study_run.hpp"
#include "cli/search/commands.hpp"
#include "coilwright/formats/simulation/performance_json.hpp"
#include "coilwright/formats/study/result_files.hpp"
#include "coilwright/report/size_text.hpp"
#include "coilwright/simulation/correction_reach.hpp"
#include "coilwright/sizing/search/search.hpp"
#include "coilwright/sizing/study/after_search.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {
namespace {

using sizing::DesignProblem;
using sizing::DesignResult;
using sizing::EvaluatedDesign;

// What follows the search, with a line that tells how far it is.
sizing::AfterSearch after_search(const DesignProblem& problem, const sizing::SearchResult& result,
                                 archive::RecordedStudy& recorded, const Interruption& interruption, bool quiet) {
  std::atomic<std::size_t> builds = 0, of_builds = 0, choices = 0, of_choices = 0;
  const ProgressLine::Place place = progress_place(quiet);
  const ProgressLine line(std::cerr, place, progress_interval(place), [&] {
    if (of_choices == 0 && of_builds > 0)
      return fmt::format("the design is found; {} of {} builds", builds.load(), of_builds.load());
    return fmt::format("the design is found; what it rests on: {} of {} modelling choices", choices.load(),
                       of_choices.load());
  });
  return sizing::after_search(
      problem, result,
      {.builds = formats::builds_of_answer,
       .stop = interruption.token(),
       .evaluate =
           [&](const DesignProblem& other, const actuator::OtherChoice& choice, std::span<const double> point) {
             return recorded.evaluate_under(sizing::name_of(choice), other, point);
           },
       .builds_done =
           [&](std::size_t done, std::size_t of) {
             builds = done;
             of_builds = of;
           },
       .choices_done =
           [&](std::size_t done, std::size_t of) {
             choices = done;
             of_choices = of;
           },
       .stated = [&](const std::string& choice,
                     std::span<const double> point) { recorded.require_same_again(point, choice); }});
}

// Where a nameless correction of the actuator is used by the design found; empty without one.
std::vector<simulation::CorrectionReach> reach_of(const std::optional<DesignResult>& best) {
  const auto* evaluated = best ? std::get_if<EvaluatedDesign>(&*best) : nullptr;
  if (evaluated == nullptr) return {};
  const simulation::DesignView view = evaluated->view();
  return simulation::correction_reach(view.assembly.model, view.performance.cold, view.point.current);
}

ExitCode end_size_part(text::OutputFolder& folder, formats::PartFile part, const sizing::SearchResult& result) {
  formats::SearchPart found{.stop_reason = std::string(sizing::name_of(result.stop_reason)),
                            .evaluations = result.search_evaluations};
  if (result.best)
    found.found.push_back(
        {.index = result.best->number, .point = result.best->point, .evaluation = result.best->evaluation});
  write_part(folder, std::move(part), formats::to_json(found));
  return ExitCode::done;
}

ExitCode run_size(const StudyOptions& options, const PartOptions& part_options) {
  StudyInput input = read_study(options, formats::objectives_of_size);
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
  const sizing::AfterSearch after = after_search(problem, result, archive.study(), interruption, options.quiet);
  if (interruption.requested()) result.stop_reason = sizing::StopReason::interrupted;
  const formats::SizeReport answer = formats::size_report(problem, result, after);
  const report::Document document = report::document_of(answer);
  archive.write_results([&] {
    formats::write_size(folder, problem, answer, report::to_json(document));
    results::write_provenance(folder, input.provenance);
    remove_other_run(folder, "result.json");
    folder.commit("result.json");
  });
  archive.end(sizing::name_of(result.stop_reason), interruption, result.archive.records());
  if (part) {
    // merge says what came out.
  } else if (options.json) {
    text::Json out = formats::to_json(answer).set("summary", report::to_json(document));
    if (const std::vector<simulation::CorrectionReach> reach = reach_of(after.best); !reach.empty())
      out.set("torque_correction", formats::to_json(reach));
    std::cout << out.text();
  } else {
    std::cout << report::to_text(document);
  }
  archive.require_written();
  if (interruption.requested()) return ExitCode::interrupted;
  if (part) return end_size_part(folder, *std::move(part), result);
  return result.feasible ? ExitCode::done : ExitCode::infeasible;
}

}  // namespace

void add_size_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<StudyOptions>();
  auto part = std::make_shared<PartOptions>();
  CLI::App* command = add_command(app, "size");
  add_study_options(*command, *options);
  add_search_options(*command, *options);
  add_flag(
      *command, "--answer-only", options->answer_only,
      fmt::format("End with the search: leave out what a step of each variable and a relaxed limit would bring "
                  "(up to some hundred evaluations more, among which there may be a better design), and what becomes "
                  "of the answer under each other "
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
  auto report = std::make_shared<std::optional<std::string>>();
  add_report_option(*command, *report);
  add_part_options(*command, *part, "Search by the K-th of N seeds, the first of which is --seed");
  command->callback([options, part, report, &outcome] {
    require_page(*report, options->out, options->force);
    outcome.code = run_size(*options, *part);
    write_report(*report, options->out, options->force);
  });
}

}  // namespace coilwright::cli
