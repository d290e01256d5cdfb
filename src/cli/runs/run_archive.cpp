#include "cli/runs/run_archive.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/outputs.hpp"
#include "cli/report_option.hpp"
#include "cli/runs/archive_contents.hpp"
#include "cli/runs/part_run.hpp"
#include "cli/runs/run_files.hpp"
#include "coilwright/archive/reader.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_file.hpp"

namespace coilwright::cli {
namespace {

namespace fs = std::filesystem;

// Designs of an archive that are evaluated again before it is trusted.
constexpr std::size_t samples = 3;

text::InputError refusal(const fs::path& path, std::string rule) {
  return text::InputError({.file = path.string(), .place = {}, .rule = std::move(rule), .value = {}});
}

// --out . beside the study, say: its actuator.json would be taken for a result.
void keep_inputs_of(const StudyInput& input, const fs::path& folder) {
  std::vector<fs::path> inputs;
  for (const results::InputRecord& each : input.provenance.inputs) inputs.emplace_back(each.file);
  for (const results::InputRecord& each : input.provenance.starts) inputs.emplace_back(each.file);
  keep_inputs(inputs, run_files_in(folder));
}

void require_same_numbers(const archive::Reader& found, const sizing::DesignProblem& problem, std::string_view advice) {
  if (!found.has_checksums())
    throw refusal(found.path(),
                  fmt::format("was written by an earlier coilwright, without checksums, so that no design is answered "
                              "from it: {}",
                              advice));
  const std::vector<std::int64_t> differing =
      archive::designs_with_other_numbers(problem, found.contents(), found.sample(samples, "1"));
  if (differing.empty()) return;
  throw refusal(found.path(),
                fmt::format("the design of row {} gives other numbers on this machine than were recorded: {}",
                            differing.front(), advice));
}

void say(const std::string& line) {
  std::cerr << "coilwright: " + line + '\n' << std::flush;
}

std::string progress_text(const archive::Counts& counts, const Pace& pace, const std::string& objective,
                          std::size_t all) {
  const std::size_t known = counts.answered + counts.reused, done = counts.evaluated + known;
  std::string text = fmt::format("{} of {} evaluations, {} feasible", done, all, counts.feasible);
  if (known > 0) text += fmt::format(", {} known", known);
  if (!objective.empty() && counts.best) text += fmt::format(", best {} {:.5g}", objective, *counts.best);
  if (done >= all) return text + ", at the surroundings of the answer";
  if (const std::optional<double> rate = pace.rate()) text += fmt::format(", {:.3g}/s", *rate);
  if (const std::optional<double> left = pace.left(all)) text += fmt::format(", {} left", duration_text(*left));
  return text;
}

}  // namespace

RunArchive::RunArchive(const StudyOptions& options, const StudyInput& input, const sizing::DesignProblem& problem,
                       std::optional<std::size_t> max_evaluations, text::OutputFolder& folder)
    : folder_(folder), path_(folder.path() / archive_name), max_evaluations_(max_evaluations), json_(options.json) {
  folder.lock();
  keep_inputs_of(input, folder.path());
  const archive::Contents asked = contents_of(problem.study(), input.provenance, input.builds_a_system);
  take_others(options, asked, problem);
  open(options, asked, problem);
  writer_ = std::make_shared<archive::Writer>(path_, max_evaluations_, say);
  sources_.writer = writer_;
  recorded_ = std::make_unique<archive::RecordedStudy>(problem, sources_);
}

void RunArchive::open(const StudyOptions& options, const archive::Contents& asked,
                      const sizing::DesignProblem& problem) {
  std::error_code error;
  // "sweep --part 3/40" is a sweep.
  const std::string_view command = std::string_view(asked.command).substr(0, asked.command.find(' '));
  const std::vector<fs::path> results = run_files_in(folder_.path());
  keep_other_run(folder_.path(), command, true);
  if (!options.force && fs::exists(fs::symlink_status(path_, error))) {
    auto found = std::make_shared<const archive::Reader>(path_);
    const std::string other_program = require_same_run(*found, asked, problem, options.resume);
    const std::size_t designs = found->size();
    if (designs > 0 && !options.resume && !is_finished(*found)) throw unfinished(*found, designs);
    keep_other_run(folder_.path(), command, false);
    require_same_numbers(*found, problem, "--force starts anew");
    if (!other_program.empty()) say(other_program);
    if (designs > 0) sources_.known = std::move(found);
  } else {
    const bool holds_results = std::ranges::any_of(results, [](const fs::path& file) {
      std::error_code none;
      return !is_of_archive(file.filename().string()) && fs::exists(file, none);
    });
    if (holds_results && !options.force)
      throw refusal(folder_.path(),
                    "holds results without an archive: --force replaces them, another --out keeps them");
    archive::create(path_, asked);
    if (options.force) {
      // Only now: the place of an archive may be refused, and then the other run stays whole.
      remove_other_run(folder_, "");
      folder_.commit();
    }
  }
  for (const fs::path& file : results) text::remove_left_parts(file);
}

bool RunArchive::is_finished(const archive::Reader& found) const {
  const std::vector<archive::Run> runs = found.runs();
  if (runs.empty()) return false;
  const archive::Run& last = runs.back();
  return !last.ended.empty() && last.stop_reason != sizing::name_of(sizing::StopReason::interrupted) &&
         last.max_evaluations == max_evaluations_;
}

text::InputError RunArchive::unfinished(const archive::Reader& found, std::size_t designs) const {
  const std::vector<archive::Run> runs = found.runs();
  const std::optional<std::size_t> budget = runs.empty() ? max_evaluations_ : runs.back().max_evaluations;
  if (budget != max_evaluations_)
    return refusal(folder_.path(),
                   fmt::format("holds a run of this study with max_evaluations {}, not {}: --resume goes "
                               "on from its {} designs, --force starts anew",
                               budget.value_or(0), max_evaluations_.value_or(0), designs));
  return refusal(folder_.path(), fmt::format("holds a run of this study that has not ended ({} designs recorded): "
                                             "--resume goes on with it, --force starts anew",
                                             designs));
}

namespace {

// A study's text without its budget, and without what a JSON does not mind.
std::string without_budget(const std::string& study) {
  std::string text = study;
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ','; });
  constexpr std::string_view budget = R"("max_evaluations":)";
  const std::size_t key = text.find(budget);
  if (key != std::string::npos) text.erase(key, text.find_first_not_of("0123456789.eE+", key + budget.size()) - key);
  return text;
}

// A budget is not what a run is of: the search of a larger one begins like that of a smaller one.
bool differ_in_budget_only(const archive::Contents& found, const archive::Contents& asked) {
  if (found.inputs.empty() || found.inputs.size() != asked.inputs.size()) return false;
  const auto same_rest = [](archive::Contents contents) {
    contents.inputs.front().sha256 = contents.inputs.front().text = without_budget(contents.inputs.front().text);
    contents.question.clear();
    contents.physics.systems.clear();
    return contents;
  };
  return archive::differences(same_rest(found), same_rest(asked)).empty();
}

}  // namespace

std::string RunArchive::require_same_run(const archive::Reader& found, const archive::Contents& asked,
                                         const sizing::DesignProblem& problem, bool resume) const {
  std::vector<std::string> differing = archive::differences(found.contents(), asked);
  if (differing.empty()) return {};
  archive::Contents of_its_program = asked;
  of_its_program.program = found.contents().program;
  if (found.has_checksums() && archive::differences(found.contents(), of_its_program).empty()) {
    const std::vector<archive::Row> feasible = found.sample(samples, "status = 'ok'");
    const std::vector<std::int64_t> other = archive::designs_with_other_numbers(problem, found.contents(), feasible);
    if (feasible.size() == samples && other.empty()) {
      const std::string same = fmt::format(
          "holds a run of this study by coilwright {}, whose rows {}, {} and {} have the same numbers by {}",
          archive::name_of(of_its_program.program), feasible[0].id, feasible[1].id, feasible[2].id,
          archive::name_of(asked.program));
      if (resume) return fmt::format("{}: {}: the run goes on with its designs", folder_.path().string(), same);
      throw refusal(folder_.path(), same + ": --resume goes on with its designs, --force starts anew");
    }
    if (!other.empty()) differing.push_back(fmt::format("row {} has other numbers now", other.front()));
  }
  if (max_evaluations_ && differ_in_budget_only(found.contents(), asked))
    throw refusal(asked.inputs.front().file,
                  fmt::format("has another max_evaluations than when the run in {} began, and is else the same: put it "
                              "back as it was, and give --max-evaluations {} --resume",
                              folder_.path().string(), *max_evaluations_));
  const std::string taken_over = archive::differences_for_reuse(found.contents(), asked).empty()
                                     ? fmt::format(", and --reuse {} takes its designs over", folder_.path().string())
                                     : "";
  throw refusal(folder_.path(), archive_of_another_run(differing) + taken_over);
}

void RunArchive::take_others(const StudyOptions& options, const archive::Contents& asked,
                             const sizing::DesignProblem& problem) {
  for (const std::string& folder : options.reuse) {
    std::error_code error;
    if (fs::equivalent(folder, folder_.path(), error))
      throw refusal(folder, "is the folder of this run, which --resume goes on with");
    auto other = std::make_shared<const archive::Reader>(archive_of("--reuse", folder));
    const std::vector<std::string> differing = archive::differences_for_reuse(other->contents(), asked);
    if (!differing.empty())
      throw refusal(folder, fmt::format("cannot answer designs of this study ({})", fmt::join(differing, "; ")));
    require_same_numbers(*other, problem, "leave out --reuse");
    sources_.others.push_back(std::move(other));
  }
}

void RunArchive::write_results(const std::function<void()>& write) {
  try {
    write();
  } catch (const std::runtime_error& reason) {
    if (!unwritten_) unwritten_ = reason.what();
  }
}

void RunArchive::end(std::string_view stop_reason, const Interruption& interruption,
                     std::span<const sizing::Record> records) {
  writer_->flush();
  unrecorded_ = writer_->failure();
  if (!records.empty() && !unrecorded_) write_results([&] { recorded_->number(path_, records); });
  // Who took its name away is not told by the system to one that writes to it.
  if (std::error_code error; !fs::exists(path_, error))
    write_results([&] { throw text::OutputError(path_, "it is gone", text::OutputError::Stage::writing); });
  const archive::Counts counts = recorded_->counts();
  // A run whose results or designs are not written has not ended: --resume writes them.
  if (!unwritten_ && !unrecorded_)
    writer_->end({.stop_reason = std::string(stop_reason),
                  .evaluated = counts.evaluated,
                  .answered = counts.answered,
                  .reused = counts.reused});
  if (!unrecorded_) unrecorded_ = writer_->failure();
  if (interruption.requested() && !json_ && !unwritten_ && !unrecorded_)
    std::cerr << fmt::format("coilwright: interrupted: what was evaluated is in {}; --resume goes on from there\n",
                             printed(path_));
}

void RunArchive::require_written() const {
  if (unwritten_ && unrecorded_) throw std::runtime_error(*unwritten_ + "; " + *unrecorded_);
  if (unwritten_ || unrecorded_) throw std::runtime_error(unwritten_ ? *unwritten_ : *unrecorded_);
}

ProgressLine progress_line(const StudyOptions& options, const archive::RecordedStudy& recorded,
                           const sizing::Study& study, std::size_t all) {
  const ProgressLine::Place place = progress_place(options.quiet);
  const std::string objective = study.objectives.size() == 1 ? study.objectives.front().quantity.name : "";
  return {std::cerr, place, progress_interval(place), [&recorded, objective, all, pace = Pace{}]() mutable {
            const archive::Counts counts = recorded.counts();
            pace.learn(std::chrono::steady_clock::now(), counts.evaluated + counts.answered + counts.reused);
            return progress_text(counts, pace, objective, all);
          }};
}

}  // namespace coilwright::cli
