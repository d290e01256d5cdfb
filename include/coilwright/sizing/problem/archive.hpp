#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "coilwright/sizing/problem/front.hpp"
#include "coilwright/sizing/problem/problem.hpp"

namespace coilwright::sizing {

/// One evaluated design.
struct Record {
  std::vector<double> point;  ///< variables, in the problem's order
  Evaluation evaluation;      ///< the evaluation of the design
  std::size_t number = 0;     ///< place in the order of evaluation, from 1; 0 without one (see Archive::number)
  /// The proposer of the design, as docs/formats-results.md lists them: "end", "gap", ...; empty for a design that no
  /// search asked for.
  std::string_view proposed_by{};

  friend bool operator==(const Record&, const Record&) = default;
};

/// Every design that a search evaluated, each once, including failed ones. Safe to use from several threads; its
/// results do not depend on the order of evaluation.
///
/// A point has the bits of its nearest legal one (`nearest_legal`): a variable with a grid takes grid values; a
/// continuous one takes its bounds, and decimals with twelve digits after the first digit of its range. So two points
/// that differ by rounding are one design.
class Archive {
 public:
  /// Keeps a copy of `problem`. Throws as `validate_problem`.
  explicit Archive(Problem problem);
  Archive(Archive&&) noexcept;
  Archive& operator=(Archive&&) noexcept;
  ~Archive();

  /// The problem of these designs.
  [[nodiscard]] const Problem& problem() const noexcept;

  /// The evaluation at `point`, made now if the point is new. Two threads that ask for the same new point make one
  /// evaluation. An exception of the problem passes through, and then nothing is recorded. Throws std::invalid_argument
  /// if the point has another number of values, lies outside the bounds or off the grid.
  Evaluation evaluate(std::span<const double> point);

  /// Evaluates those of `points` that are new in one call of the problem's `evaluate_together`, which it must have.
  /// Throws as evaluate().
  void evaluate_together(std::span<const std::vector<double>> points);

  /// Gives the design at an evaluated point the next number in the order of evaluation, unless it has one. Only the
  /// caller knows an order that is the same on any number of threads, because designs are evaluated at the same time.
  /// `proposed_by` names the proposer and must outlive the archive.
  void number(std::span<const double> point, std::string_view proposed_by = {});

  /// The evaluation at `point`; absent if there is none.
  [[nodiscard]] std::optional<Evaluation> find(std::span<const double> point) const;

  /// Whether the problem excludes the design at a point before it is evaluated. Throws as evaluate() for the point, and
  /// passes on exceptions of the problem.
  [[nodiscard]] bool excludes(std::span<const double> point) const;

  /// Number of designs for which excludes() was true.
  [[nodiscard]] std::size_t excluded() const;

  /// Number of designs evaluated.
  [[nodiscard]] std::size_t size() const;

  /// All designs, in ascending lexicographic order of their variables.
  [[nodiscard]] std::vector<Record> records() const;

  /// The feasible design with the best objective, of equal ones the lexicographically first. For one objective.
  [[nodiscard]] std::optional<Record> best_feasible() const;

  /// The design of least `violation` or, if no design was evaluated, of least `infeasibility`.
  [[nodiscard]] std::optional<Record> least_infeasible() const;

  /// Feasible designs that no other feasible design dominates, sorted by their objectives (best of the first one
  /// first), then by their variables; of designs with equal objectives only the lexicographically first.
  [[nodiscard]] std::vector<Record> front() const;

 private:
  struct Storage;
  std::unique_ptr<Storage> storage_;
};

/// Objectives of `evaluation` with the maximised ones negated, as the functions of `front.hpp` take them.
[[nodiscard]] Objectives minimised(const Problem& problem, const Evaluation& evaluation);

/// The negated objectives of each record.
[[nodiscard]] std::vector<Objectives> minimised(const Problem& problem, const std::vector<Record>& records);

}  // namespace coilwright::sizing
