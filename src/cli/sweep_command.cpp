#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/report/sweep_text.hpp"
#include "coilwright/sizing/study/leaders.hpp"
#include "coilwright/sizing/study/sweep.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_folder.hpp"
#include "commands.hpp"
#include "found_designs.hpp"
#include "options.hpp"
#include "progress_line.hpp"
#include "report_option.hpp"
#include "run_archive.hpp"
#include "study_run.hpp"

namespace coilwright::cli {
namespace {

// What point_count() throws, in terms of the file.
void require_grid(const sizing::DesignProblem& problem, const StudyOptions& options) {
  for (const sizing::StudyVariable& variable : problem.study().variables)
    if (!value_count(variable))
      throw text::InputError({.file = options.study,
                              .place = "/variables/" + name_of(variable),
                              .rule = R"(needs "step" or "values" in a sweep, or --sample N)"});
  try {
    (void)problem.point_count();
  } catch (const std::invalid_argument& too_many) {
    throw text::InputError({.file = options.study, .place = "/variables", .rule = too_many.what()});
  }
}

struct SweepCommandOptions {
  StudyOptions study;
  std::size_t sample = 0;
  std::string sampling{sizing::name_of(sizing::DesignSample{}.sampling)};
};

ExitCode run_sweep(const SweepCommandOptions& sweep_options) {
  const StudyOptions& options = sweep_options.study;
  StudyInput input = read_study(options, {.least = 1, .most = 3, .rule = "must be one to three for sweep"});
  const sizing::DesignProblem problem(std::move(input.study));
  input.provenance.command = "sweep";
  std::vector<std::vector<double>> points;
  std::optional<sizing::DesignSample> sample;
  if (sweep_options.sample > 0) {
    using Word = std::pair<std::string_view, sizing::Sampling>;
    sample = {
        .sampling =
            std::ranges::find(sizing::sampling_words, std::string_view(sweep_options.sampling), &Word::first)->second,
        .drawn = sweep_options.sample,
        .seed = problem.study().search.seed};
    points = sizing::sampled_points(problem, *sample);
    input.provenance.seed = sample->seed;
    input.provenance.sample = fmt::format("{} of {} designs", sweep_options.sampling, sample->drawn);
  } else {
    require_grid(problem, options);
  }
  const sizing::Study& study = problem.study();
  const Interruption interruption;
  text::OutputFolder folder(options.out);
  const std::size_t count = points.empty() ? problem.point_count() : points.size();
  RunArchive archive(options, input, problem, std::nullopt, folder);
  formats::SweepRow write_row;
  archive.write_results([&] { write_row = formats::write_sweep(folder.open("designs.csv"), study); });
  sizing::Leaders leaders(problem);
  std::size_t ok = 0;
  const std::size_t made = [&] {
    const ProgressLine line = progress_line(options, archive.study(), study, count);
    const auto recorded = [&](std::size_t index, std::span<const double> point) {
      return archive.study().evaluate(point, index + 1);
    };
    return sizing::sweep(
        problem,
        {.threads = study.search.threads, .points = points, .stop = interruption.token(), .evaluate = recorded},
        [&](const sizing::SweptDesign& design) {
          if (archive.is_writing()) archive.write_results([&] { write_row(design); });
          leaders.consider(design);
          ok += sizing::is_feasible(design.evaluation) ? 1 : 0;
        });
  }();
  const std::vector<sizing::Leader> best = leaders.all();
  const std::vector<sizing::BrokenPartLimit> broken =
      sizing::broken_part_limits(problem.study(), evaluated_again(problem, sizing::feasible_designs(best)));
  const formats::SweepReport answer{.study = study,
                                    .designs = count,
                                    .evaluated = made,
                                    .ok = ok,
                                    .leaders = best,
                                    .broken = broken,
                                    .sample = sample};
  if (archive.is_writing())
    archive.write_results([&] {
      formats::write_leaders(folder.open("best.csv"), study, best);
      folder.write("result.json", formats::to_json(answer).text());
      folder.write(provenance_name, to_json(input.provenance).text());
      folder.commit("result.json");
    });
  archive.end(made < count ? sizing::name_of(sizing::StopReason::interrupted) : "complete", interruption, {});
  std::cout << (options.json ? formats::to_json(answer).text() : report::to_text(answer));
  archive.require_written();
  if (made < count) return ExitCode::interrupted;
  return leaders.any_feasible() ? ExitCode::done : ExitCode::infeasible;
}

}  // namespace

void add_sweep_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<SweepCommandOptions>();
  CLI::App* command =
      app.add_subcommand("sweep", "Evaluate every design of a study whose variables are lists or grids, or a sample");
  add_study_options(*command, options->study);
  auto* sample = add_whole_number(
      *command, "--sample", options->sample, text::Rule::between(2, 1e8),
      "So many designs from the whole range in place of the grid, whatever the variables are; one that is drawn "
      "again is evaluated once");
  std::vector<std::string> words;
  for (const auto& [word, sampling] : sizing::sampling_words) words.emplace_back(word);
  add_word(*command, "--sampling", options->sampling, std::move(words),
           "How they are drawn (default latin_hypercube); another /search/seed draws others")
      ->needs(sample);
  command->footer(
      "Writes designs.csv (one row for each design: variables, every quantity, the margin of every limit), best.csv\n"
      "(the best design of each configuration in each objective), result.json (what --json prints) and\n"
      "provenance.json (program and files). Without --sample every variable needs a list of values, a step or whole "
      "numbers; what is\n"
      "not a variable keeps the value of the study's actuator. If no design keeps all limits, the exit code is 3.\n"
      "Ctrl-C writes what was evaluated so far; the exit code is then 130. Every evaluation is recorded in\n"
      "archive.sqlite as it is made: --resume goes on from there, after Ctrl-C and after a crash.\n\n"
      "Example:\n"
      "  coilwright sweep configs/studies/configurations.json --out results/configurations\n"
      "  coilwright sweep configs/studies/fastest_finger.json --out results/sample --sample 1000");
  auto report = std::make_shared<bool>(false);
  add_report_option(*command, *report);
  command->callback([options, report, &outcome] {
    outcome.code = run_sweep(*options);
    if (*report)
      write_report(options->study.out, std::filesystem::path(options->study.out) / report_name,
                   {.force = options->study.force});
  });
}

}  // namespace coilwright::cli
