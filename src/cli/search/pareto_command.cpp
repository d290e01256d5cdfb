#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/progress_line.hpp"
#include "cli/report_option.hpp"
#include "cli/runs/part_run.hpp"
#include "cli/runs/run_archive.hpp"
#include "cli/runs/run_files.hpp"
#include "cli/runs/study_run.hpp"
#include "cli/search/commands.hpp"
#include "coilwright/formats/study/front_json.hpp"
#include "coilwright/formats/study/result_files.hpp"
#include "coilwright/report/front_text.hpp"
#include "coilwright/sizing/search/pareto.hpp"
#include "coilwright/sizing/study/after_search.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {
namespace {

ExitCode end_pareto_part(text::OutputFolder& folder, formats::PartFile part, const sizing::ParetoResult& result) {
  formats::SearchPart found{.stop_reason = std::string(sizing::name_of(result.stop_reason)),
                            .evaluations = result.evaluations};
  const auto add = [&](const sizing::Record& record) {
    found.found.push_back({.index = record.number, .point = record.point, .evaluation = record.evaluation});
  };
  for (const sizing::Record& record : result.front) add(record);
  if (result.least_infeasible) add(*result.least_infeasible);
  write_part(folder, std::move(part), formats::to_json(found));
  return ExitCode::done;
}

ExitCode run_pareto(const StudyOptions& options, const PartOptions& part_options) {
  StudyInput input = read_study(options, formats::objectives_of_pareto);
  input.provenance.command = "pareto";
  std::optional<formats::PartFile> part = begin_search_part(part_options, input.provenance, input.study);
  const sizing::DesignProblem problem(std::move(input.study));
  input.provenance.seed = problem.study().search.seed;
  const sizing::Study& study = problem.study();
  const Interruption interruption;
  text::OutputFolder folder(options.out);
  RunArchive archive(options, input, problem, study.search.max_evaluations, folder);
  const sizing::ParetoResult result = [&] {
    const ProgressLine line = progress_line(options, archive.study(), study, study.search.max_evaluations);
    sizing::ParetoOptions search = study.search;
    search.stop = interruption.token();
    return sizing::pareto(archive.study().problem(), search);
  }();
  for (const sizing::Record& design : result.front) archive.study().require_same_again(design.point);
  if (result.least_infeasible) archive.study().require_same_again(result.least_infeasible->point);
  const std::vector<sizing::BrokenPartLimit> broken =
      sizing::broken_part_limits(problem.study(), sizing::evaluated_again(problem, result.front));
  const std::vector<sizing::Record> records = result.archive.records();
  const report::Document document = report::document_of(study, result, broken);
  archive.write_results([&] {
    formats::write_pareto(folder, study, result, broken, report::to_json(document));
    results::write_provenance(folder, input.provenance);
    remove_other_run(folder, "result.json");
    folder.commit("result.json");
  });
  archive.end(sizing::name_of(result.stop_reason), interruption, records);
  if (!part)
    std::cout << (options.json
                      ? formats::to_json(study, result, broken).set("summary", report::to_json(document)).text()
                      : report::to_text(document));
  archive.require_written();
  if (interruption.requested()) return ExitCode::interrupted;
  if (part) return end_pareto_part(folder, *std::move(part), result);
  return result.front.empty() ? ExitCode::infeasible : ExitCode::done;
}

}  // namespace

void add_pareto_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<StudyOptions>();
  auto part = std::make_shared<PartOptions>();
  CLI::App* command = add_command(app, "pareto");
  add_study_options(*command, *options);
  add_search_options(*command, *options);
  command->footer(
      "Writes front.csv (one row for each design that no other design beats: variables, objectives, the margin of\n"
      "every limit, every quantity), evaluations.csv (every design that was evaluated, with every quantity), "
      "convergence.csv (the\n"
      "hypervolume after so many evaluations), result.json and provenance.json (program, files and seed). If no design "
      "keeps all limits, the least infeasible\n"
      "design is in result.json and the exit code is 3. Ctrl-C writes what was found so far; the exit code is then\n"
      "130. Every evaluation is recorded in archive.sqlite as it is made: --resume goes on from there, after Ctrl-C "
      "and\n"
      "after a crash.\n\n"
      "Example:\n"
      "  coilwright pareto configs/studies/speed_against_grip.json --out results/speed_against_grip");
  auto report = std::make_shared<std::optional<std::string>>();
  add_report_option(*command, *report);
  add_part_options(*command, *part, "Search by the K-th of N seeds, the first of which is --seed");
  command->callback([options, part, report, &outcome] {
    require_page(*report, options->out, options->force);
    outcome.code = run_pareto(*options, *part);
    write_report(*report, options->out, options->force);
  });
}

}  // namespace coilwright::cli
