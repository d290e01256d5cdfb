#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/archive/reader.hpp"
#include "coilwright/archive/writer.hpp"
#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/study/design_problem.hpp"

namespace coilwright::archive {

/// What a run has seen so far.
struct Counts {
  std::size_t evaluated{};       ///< designs that this run evaluated
  std::size_t answered{};        ///< designs that the archive of the run knew before it began
  std::size_t reused{};          ///< designs that the archive of another study knew
  std::size_t feasible{};        ///< of all these the feasible ones
  std::optional<double> best{};  ///< the best feasible value of the first objective; nothing without one
};

/// A study whose every evaluation goes through an archive: a design that an earlier run recorded is answered with its
/// bits, one that another archive knows is worked out from that one's quantities, and all others are evaluated and
/// recorded. Because a search is deterministic, one that was killed and is begun again through its archive goes the
/// same way, evaluates what is missing and ends with the same bits.
class RecordedStudy {
 public:
  /// What the evaluations go through.
  struct Sources {
    std::shared_ptr<Writer> writer{};       ///< of this run; never empty; first, to go last, when nobody reads
    std::shared_ptr<const Reader> known{};  ///< the archive as earlier runs left it; nothing where it is new
    std::vector<std::shared_ptr<const Reader>> others{};  ///< archives without `differences_for_reuse`
  };

  /// Keeps a copy of the problem.
  RecordedStudy(const sizing::DesignProblem& problem, Sources sources);

  /// The problem for search() or pareto(). It refers to this object.
  [[nodiscard]] sizing::Problem problem();

  /// The evaluation of a point, with its place in the order of a sweep if that is known. From any thread. Numbers that
  /// are not a number cannot be recorded: such a design is evaluated whenever it is asked for.
  [[nodiscard]] sizing::Evaluation evaluate(std::span<const double> point,
                                            std::optional<std::size_t> number = std::nullopt);

  /// The same of the study under another modelling choice, `other`, which counts() leaves out.
  [[nodiscard]] sizing::Evaluation evaluate_under(const std::string& choice, const sizing::DesignProblem& other,
                                                  std::span<const double> point);

  /// What an answer rests on is not believed for standing in an archive. Where an archive has answered this design
  /// (under that modelling choice, by its name; empty: the study's own), it is evaluated again. Throws text::InputError
  /// naming archive, row, both numbers and the cure where another one comes out; a search may rest on what is recorded,
  /// an answer not.
  void require_same_again(std::span<const double> point, const std::string& choice = {}) const;

  /// So far. From any thread.
  [[nodiscard]] Counts counts() const;

  /// Waits for the disk, and gives the designs of `records` their numbers in the archive `path`.
  void number(const std::filesystem::path& path, std::span<const sizing::Record> records);

 private:
  struct Answer {
    sizing::Evaluation evaluation;
    std::string origin;
  };
  [[nodiscard]] std::optional<Answer> reused(std::span<const Value> values) const;
  [[nodiscard]] sizing::Evaluation counted(sizing::Evaluation evaluation, std::size_t Counts::*source);
  // Evaluates and records; the row has all but what comes out.
  [[nodiscard]] sizing::Evaluation evaluate_anew(const sizing::DesignProblem& problem, std::span<const double> point,
                                                 Row row);
  void record(Row row);

  sizing::DesignProblem problem_;
  Sources sources_;
  mutable std::mutex guard_;
  Counts counts_;
};

/// The evaluation anew of a design of an archive of these contents; nothing where it is none of the problem's.
[[nodiscard]] std::optional<sizing::Evaluation> evaluated_again(const sizing::DesignProblem& problem,
                                                                const Contents& contents, const Row& row);

/// Of these designs of an archive the ids of those whose evaluation by `problem` has other bits than what the archive
/// says: none where it was written by this program on such a machine. Its contents have no `differences_for_reuse` from
/// those of the problem, but for the program; designs that are none of the problem's are passed over.
[[nodiscard]] std::vector<std::int64_t> designs_with_other_numbers(const sizing::DesignProblem& problem,
                                                                   const Contents& contents,
                                                                   std::span<const Row> designs);

}  // namespace coilwright::archive
