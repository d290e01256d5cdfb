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

/// Counts of a run up to now.
struct Counts {
  std::size_t evaluated{};       ///< designs that this run evaluated
  std::size_t answered{};        ///< designs that the archive of the run knew before it began
  std::size_t reused{};          ///< designs that the archive of another study knew
  std::size_t feasible{};        ///< feasible ones among all these
  std::optional<double> best{};  ///< the best feasible value of the first objective; absent without one
};

/// A study whose every evaluation goes through an archive. A design that an earlier run recorded is answered with its
/// bits, a design that another archive has is computed from that archive's quantities, and all others are evaluated and
/// recorded. Because a search is deterministic, one that was killed and is started again through its archive takes the
/// same course and ends with the same bits.
class RecordedStudy {
 public:
  /// The archives that answer evaluations.
  struct Sources {
    std::shared_ptr<Writer> writer{};       ///< of this run; never empty; first, so that it is destroyed last
    std::shared_ptr<const Reader> known{};  ///< the archive as earlier runs left it; null if it is new
    std::vector<std::shared_ptr<const Reader>> others{};  ///< other archives, without `differences_for_reuse`
  };

  /// Copies the problem.
  RecordedStudy(const sizing::DesignProblem& problem, Sources sources);

  /// The problem for search() or pareto(). It refers to this object.
  [[nodiscard]] sizing::Problem problem();

  /// Evaluates a point, whose index in the order of a sweep may be given. Callable from any thread. A design with NaN
  /// cannot be recorded and is evaluated at each request.
  [[nodiscard]] sizing::Evaluation evaluate(std::span<const double> point,
                                            std::optional<std::size_t> number = std::nullopt);

  /// Evaluates a point of the study under another modelling choice, `other`. counts() does not include it.
  [[nodiscard]] sizing::Evaluation evaluate_under(const std::string& choice, const sizing::DesignProblem& other,
                                                  std::span<const double> point);

  /// Checks a design on which an answer rests. If an archive has answered it (under that modelling choice, by its name;
  /// empty: the study's own), it is evaluated again. Throws text::InputError naming archive, row, both numbers and the
  /// cure if another number comes out.
  void require_same_again(std::span<const double> point, const std::string& choice = {}) const;

  /// The counts up to now. Callable from any thread.
  [[nodiscard]] Counts counts() const;

  /// Waits for the disk and writes the numbers of the designs of `records` into the archive `path`.
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

/// Evaluates a design of an archive with these contents again; absent if it is no design of the problem.
[[nodiscard]] std::optional<sizing::Evaluation> evaluated_again(const sizing::DesignProblem& problem,
                                                                const Contents& contents, const Row& row);

/// Returns the ids of those designs whose evaluation by `problem` has other bits than the archive; none if this program
/// wrote it on such a machine. The archive must have no `differences_for_reuse` from the problem except the program.
/// Designs that are none of the problem's are skipped.
[[nodiscard]] std::vector<std::int64_t> designs_with_other_numbers(const sizing::DesignProblem& problem,
                                                                   const Contents& contents,
                                                                   std::span<const Row> designs);

}  // namespace coilwright::archive
