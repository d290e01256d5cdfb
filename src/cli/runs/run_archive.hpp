#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "cli/progress_line.hpp"
#include "cli/runs/study_run.hpp"
#include "coilwright/archive/recorded_study.hpp"
#include "coilwright/archive/writer.hpp"
#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {

/// The archive of one run of size, sweep or pareto in its folder of results, from the first design to the last word.
///
/// A folder is taken as it is where it holds nothing of a run, or a finished run of the very same question, whose
/// designs then answer it. With --resume also where that run was not finished, had another budget, or is of another
/// program, and this one gives three of its feasible designs (the first, one in the middle, the last) to the last bit.
/// With --force the run that it holds is replaced. Anything else is refused in one line, and nothing is changed.
class RunArchive {
 public:
  /// `max_evaluations` is the budget of a search. Throws InputError and text::OutputError as above, and where the
  /// archive of another run cannot be read or a file of the study would be replaced.
  RunArchive(const StudyOptions& options, const StudyInput& input, const sizing::DesignProblem& problem,
             std::optional<std::size_t> max_evaluations, text::OutputFolder& folder);

  /// What evaluations go through.
  [[nodiscard]] archive::RecordedStudy& study() noexcept { return *recorded_; }

  /// Calls what writes the results. Where the disk refuses, or the folder is gone, the answer is not lost: what it says
  /// is kept for require_written().
  void write_results(const std::function<void()>& write);
  /// Whether the disk has refused no result so far.
  [[nodiscard]] bool is_writing() const noexcept { return !unwritten_; }

  /// Ends the run: the designs of a search get their numbers, and the archive its stop reason. `records` is empty for a
  /// sweep, whose designs have theirs. An interruption is told on standard error, with how to go on.
  void end(std::string_view stop_reason, const Interruption& interruption, std::span<const sizing::Record> records);

  /// After the answer has been printed: throws std::runtime_error where results or designs are not written.
  void require_written() const;

 private:
  void open(const StudyOptions& options, const archive::Contents& asked, const sizing::DesignProblem& problem);
  [[nodiscard]] bool is_finished(const archive::Reader& found) const;
  [[nodiscard]] text::InputError unfinished(const archive::Reader& found, std::size_t designs) const;
  // What to say of another program whose designs are gone on with; else empty.
  [[nodiscard]] std::string require_same_run(const archive::Reader& found, const archive::Contents& asked,
                                             const sizing::DesignProblem& problem, bool resume) const;
  void take_others(const StudyOptions& options, const archive::Contents& asked, const sizing::DesignProblem& problem);

  text::OutputFolder& folder_;
  std::filesystem::path path_;
  std::optional<std::size_t> max_evaluations_;
  bool json_;
  archive::RecordedStudy::Sources sources_;
  std::shared_ptr<archive::Writer> writer_;
  std::unique_ptr<archive::RecordedStudy> recorded_;
  std::optional<std::string> unwritten_;   // what the disk said of the results, where it did not take them
  std::optional<std::string> unrecorded_;  // the same of designs, at the end
};

/// Tells on standard error how far a run is: designs done, rate, the best so far, time left. `all` is what the run will
/// evaluate, a search before it looks at the surroundings of its answer. `recorded` must outlive it.
[[nodiscard]] ProgressLine progress_line(const StudyOptions& options, const archive::RecordedStudy& recorded,
                                         const sizing::Study& study, std::size_t all);

}  // namespace coilwright::cli
