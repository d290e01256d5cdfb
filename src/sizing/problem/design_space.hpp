#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "coilwright/sizing/problem/problem.hpp"

namespace coilwright::sizing {

/// Coordinates of a search for the variables of a problem: each free ordered variable is a coordinate of the unit cube,
/// all free categorical ones together are one index over their combinations, and fixed variables are left out.
class DesignSpace {
 public:
  explicit DesignSpace(const std::vector<Variable>& variables);

  /// Number of unit coordinates: free continuous and integer variables.
  [[nodiscard]] std::size_t dimension() const { return ordered_.size(); }
  /// Number of combinations of the free categorical variables; 1 if there is none.
  [[nodiscard]] std::uint64_t combinations() const { return combinations_; }
  /// Number of levels of each free categorical variable; in a combination the first one changes fastest.
  [[nodiscard]] const std::vector<std::uint64_t>& level_counts() const { return level_counts_; }
  /// Number of designs if every free variable has a grid; 0 otherwise, and if the number overflows.
  [[nodiscard]] std::uint64_t design_count() const { return design_count_; }
  /// Spacing of the grid of unit coordinate `axis`; 0 without a grid.
  [[nodiscard]] double spacing(std::size_t axis) const { return axes_[axis].spacing; }
  /// Largest legal value of unit coordinate `axis`: 1, or less where the upper bound is no grid value.
  [[nodiscard]] double ceiling(std::size_t axis) const { return axes_[axis].ceiling; }
  /// Index of the variable that is unit coordinate `axis`.
  [[nodiscard]] std::size_t variable_of(std::size_t axis) const { return ordered_[axis]; }
  /// Whether any unit coordinate has a grid.
  [[nodiscard]] bool has_grid() const { return has_grid_; }
  /// Whether no unit coordinate has a grid and there are at least `least_wide_dimension`: the nodes of a local model do
  /// not determine a quadratic there, and it takes other means to find what each coordinate does.
  [[nodiscard]] bool is_wide() const { return !has_grid_ && dimension() >= least_wide_dimension; }
  /// From here on a quadratic has more coefficients (66) than a model has nodes to spare.
  static constexpr std::size_t least_wide_dimension = 10;

  /// Nearest legal unit coordinates: clamped to the bounds and on the grid.
  [[nodiscard]] std::vector<double> snapped(std::span<const double> unit) const;
  /// The design at legal unit coordinates and a combination of levels.
  [[nodiscard]] std::vector<double> point(std::span<const double> unit, std::uint64_t combination) const;
  /// Unit coordinates of a design.
  [[nodiscard]] std::vector<double> unit(std::span<const double> point) const;
  /// Combination of levels of a design.
  [[nodiscard]] std::uint64_t combination(std::span<const double> point) const;

 private:
  struct Axis {
    double spacing{};
    double ceiling = 1;
  };
  std::vector<Variable> variables_;
  std::vector<std::size_t> ordered_, categorical_;
  std::vector<Axis> axes_;
  std::vector<std::uint64_t> level_counts_;
  std::uint64_t combinations_ = 1, design_count_ = 1;
  bool has_grid_ = false;
};

/// Grid step of a variable: its own; without one 1 for integer and categorical variables and 0 for continuous ones.
[[nodiscard]] double grid_step(const Variable& variable);

/// Index of the last grid value of a variable with a grid.
[[nodiscard]] double last_grid_index(const Variable& variable);

/// The legal value nearest to `value`: within the bounds, and on the grid. A variable without a grid takes its
/// bounds and decimals with twelve digits after the first digit of its range, so that values that differ by rounding
/// are one. The same bits whenever the index, or the decimal, is the same.
[[nodiscard]] double nearest_legal(const Variable& variable, double value);

/// The same for each variable; `point` has one value for each.
[[nodiscard]] std::vector<double> nearest_legal_point(const std::vector<Variable>& variables,
                                                      std::span<const double> point);

}  // namespace coilwright::sizing
