#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "coilwright/sizing/problem/problem.hpp"

namespace coilwright::sizing {

/// The variables of a problem as the search moves in them: the free ordered ones as coordinates of a unit cube, the
/// free categorical ones as one index over all their combinations, fixed ones left out.
class DesignSpace {
 public:
  explicit DesignSpace(const std::vector<Variable>& variables);

  /// Number of unit coordinates: free continuous and integer variables.
  [[nodiscard]] std::size_t dimension() const { return ordered_.size(); }
  /// Number of combinations of the free categorical variables; 1 if there is none.
  [[nodiscard]] std::uint64_t combinations() const { return combinations_; }
  /// Levels of each free categorical variable; the first one runs fastest in a combination.
  [[nodiscard]] const std::vector<std::uint64_t>& level_counts() const { return level_counts_; }
  /// Number of designs if every free variable has a grid, otherwise (or if it overflows) 0.
  [[nodiscard]] std::uint64_t design_count() const { return design_count_; }
  /// Grid spacing of unit coordinate `axis`; 0: no grid.
  [[nodiscard]] double spacing(std::size_t axis) const { return axes_[axis].spacing; }
  /// Largest legal value of unit coordinate `axis`: 1, or less where the grid does not meet the upper bound.
  [[nodiscard]] double ceiling(std::size_t axis) const { return axes_[axis].ceiling; }
  /// Index of the variable that is unit coordinate `axis`.
  [[nodiscard]] std::size_t variable_of(std::size_t axis) const { return ordered_[axis]; }
  /// True if any unit coordinate has a grid.
  [[nodiscard]] bool has_grid() const { return has_grid_; }

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

/// Grid step of a variable: its own, 1 for whole numbers, 0 for none.
[[nodiscard]] double grid_step(const Variable& variable);

/// Index of the last grid value of a variable with a grid.
[[nodiscard]] double last_grid_index(const Variable& variable);

/// The legal value nearest to `value`, always the same bits for the same grid index.
[[nodiscard]] double nearest_legal(const Variable& variable, double value);

}  // namespace coilwright::sizing
