#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "coilwright/sizing/problem/front.hpp"
#include "coilwright/sizing/problem/problem.hpp"

namespace coilwright::sizing {

/// One evaluated design.
struct Record {
  std::vector<double> point;  ///< variables, in the problem's order
  Evaluation evaluation;      ///< what came out

  friend bool operator==(const Record&, const Record&) = default;
};

/// Every design a search evaluated, each once, failed ones included. Safe to use from several threads; what it returns
/// does not depend on the order in which designs arrived.
class Archive {
 public:
  /// Keeps a copy of `problem`. Throws as `check(problem)`.
  explicit Archive(Problem problem);
  Archive(Archive&&) noexcept;
  Archive& operator=(Archive&&) noexcept;
  ~Archive();

  /// The problem whose designs these are.
  [[nodiscard]] const Problem& problem() const noexcept;

  /// The evaluation at `point`: made now if the point is new, otherwise remembered. Two threads asking for the same new
  /// point make one evaluation. Throws what the problem throws (nothing is recorded then), and std::invalid_argument if
  /// the point has the wrong length, leaves the bounds or is off the grid.
  Evaluation evaluate(std::span<const double> point);

  /// The evaluation at `point`, if it was made.
  [[nodiscard]] std::optional<Evaluation> find(std::span<const double> point) const;

  /// Number of designs evaluated.
  [[nodiscard]] std::size_t size() const;

  /// All designs, by their variables in ascending lexicographic order.
  [[nodiscard]] std::vector<Record> records() const;

  /// The feasible design with the best objective (ties: the lexicographically first point). For one objective.
  [[nodiscard]] std::optional<Record> best_feasible() const;

  /// The design nearest to feasible: evaluated ones by `violation`, then failed ones by `infeasibility`.
  [[nodiscard]] std::optional<Record> least_infeasible() const;

  /// Feasible designs no other feasible design dominates, sorted by objectives (best of the first one first), then by
  /// variables; of designs with equal objectives the lexicographically first point.
  [[nodiscard]] std::vector<Record> front() const;

 private:
  struct Storage;
  std::unique_ptr<Storage> storage_;
};

/// Objectives of `evaluation` with the maximised ones negated: what `front.hpp` takes.
[[nodiscard]] Objectives minimised(const Problem& problem, const Evaluation& evaluation);

/// The same for each record.
[[nodiscard]] std::vector<Objectives> minimised(const Problem& problem, const std::vector<Record>& records);

}  // namespace coilwright::sizing
