#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/options.hpp"
#include "cli/progress_line.hpp"
#include "cli/report_option.hpp"
#include "cli/runs/part_run.hpp"
#include "cli/runs/run_archive.hpp"
#include "cli/runs/run_files.hpp"
#include "cli/runs/study_run.hpp"
#include "cli/search/commands.hpp"
#include "cli/search/sweep_answer.hpp"
#include "coilwright/formats/study/part_file.hpp"
#include "coilwright/sizing/study/sweep_summary.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {
namespace {

struct SweepCommandOptions {
  StudyOptions study;
  PartOptions part;
  std::size_t sample = 0;
  std::string sampling{sizing::name_of(sizing::DesignSample{}.sampling)};
  std::string keep{sizing::name_of(sizing::Keep::all)};
};

template <class Value>
Value value_of(const auto& words, std::string_view word) {
  return std::ranges::find(words, word, &std::pair<std::string_view, Value>::first)->second;
}

// The designs, and of a sample their points.
struct SweptDesigns {
  SweepRequest request;
  std::vector<std::vector<double>> points{};  // empty: the grid
};

SweptDesigns designs_of(const SweepCommandOptions& options, const sizing::DesignProblem& problem) {
  SweptDesigns out{.request = {.keep = value_of<sizing::Keep>(sizing::keep_words, options.keep)}};
  if (options.sample == 0) {
    require_grid(problem, options.study.study);
    out.request.count = problem.point_count();
    return out;
  }
  out.request.sample = {.sampling = value_of<sizing::Sampling>(sizing::sampling_words, options.sampling),
                        .drawn = options.sample,
                        .seed = problem.study().search.seed};
  out.points = sizing::sampled_points(problem, *out.request.sample);
  out.request.count = out.points.size();
  return out;
}

void end_sweep_part(text::OutputFolder& folder, const SweepRequest& request, formats::PartFile part,
                    const sizing::SweepSummary& summary) {
  write_part(folder, std::move(part),
             formats::to_json(formats::SweepPart{.count = request.count,
                                                 .keep = request.keep,
                                                 .sample = request.sample,
                                                 .totals = summary.totals(),
                                                 .kept = summary.kept()}));
}

ExitCode run_sweep(const SweepCommandOptions& sweep_options) {
  const StudyOptions& options = sweep_options.study;
  StudyInput input = read_study(options, formats::objectives_of_sweep);
  const sizing::DesignProblem problem(std::move(input.study));
  input.provenance.command = "sweep";
  SweptDesigns designs = designs_of(sweep_options, problem);
  const SweepRequest& request = designs.request;
  if (request.sample) {
    input.provenance.seed = request.sample->seed;
    input.provenance.sample = fmt::format("{} of {} designs", sweep_options.sampling, request.sample->drawn);
  }
  const sizing::Part part = sweep_options.part.part.value_or(sizing::Part{});
  const bool is_part = sweep_options.part.part.has_value();
  formats::PartFile part_file{.part = part};
  if (is_part) {
    part_file.whole = whole_of(
        input.provenance, problem.study().name,
        fmt::format("{}, --keep {}", request.sample ? input.provenance.sample : "the grid", sweep_options.keep));
    part_file.machine = this_machine(problem);
    require_figures_of_head(sweep_options.part, part_file.machine);
    input.provenance.command += part_text(sweep_options.part);
  }
  const sizing::Study& study = problem.study();
  const sizing::IndexRange range = sizing::range_of(part, request.count);
  const std::size_t count = range.end - range.first;
  const Interruption interruption;
  text::OutputFolder folder(options.out);
  RunArchive archive(options, input, problem, std::nullopt, folder);
  sizing::SweepSummary summary(problem, request.keep);
  std::function<void(const sizing::SweptDesign&)> write_row;
  archive.write_results([&] { write_row = write_rows(folder, problem, request, summary); });
  const std::size_t made = [&] {
    const ProgressLine line = progress_line(options, archive.study(), study, count);
    const auto recorded = [&](std::size_t index, std::span<const double> point) {
      return archive.study().evaluate(point, index + 1);
    };
    return sizing::sweep(problem,
                         {.threads = study.search.threads,
                          .points = std::move(designs.points),
                          .only = range,
                          .stop = interruption.token(),
                          .evaluate = recorded},
                         [&](const sizing::SweptDesign& design) {
                           if (archive.is_writing()) archive.write_results([&] { write_row(design); });
                           summary.consider(design);
                         });
  }();
  for (const sizing::Leader& leader : summary.leaders().all()) archive.study().require_same_again(leader.design.point);
  if (request.keep == sizing::Keep::front)
    for (const sizing::SweptDesign& design : summary.front()) archive.study().require_same_again(design.point);
  std::optional<SweepAnswer> answer;
  if (!is_part) answer.emplace(problem, request, summary);
  if (archive.is_writing())
    archive.write_results([&] {
      if (answer) answer->write(folder, input.provenance);
      remove_other_run(folder, "result.json");
      folder.commit("result.json");
    });
  archive.end(made < count ? sizing::name_of(sizing::StopReason::interrupted) : "complete", interruption, {});
  if (answer) answer->print(options.json);
  archive.require_written();
  if (made < count) return ExitCode::interrupted;
  if (answer) return answer->code();
  end_sweep_part(folder, request, std::move(part_file), summary);
  return ExitCode::done;
}

}  // namespace

void add_sweep_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<SweepCommandOptions>();
  CLI::App* command = add_command(app, "sweep");
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
  words.clear();
  for (const auto& [word, keep] : sizing::keep_words) words.emplace_back(word);
  add_word(*command, "--keep", options->keep, std::move(words),
           "Which designs are rows of designs.csv (default all); of the others result.json has counts, and mean, least "
           "and greatest of each quantity");
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
  auto report = std::make_shared<std::optional<std::string>>();
  add_report_option(*command, *report);
  add_part_options(*command, options->part, "Evaluate the K-th of N equal shares of the designs");
  command->callback([options, report, &outcome] {
    require_page(*report, options->study.out, options->study.force);
    outcome.code = run_sweep(*options);
    write_report(*report, options->study.out, options->study.force);
  });
}

}  // namespace coilwright::cli
