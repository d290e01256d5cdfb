#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace coilwright::sizing {

/// One point in objective space, every objective minimised.
using Objectives = std::vector<double>;

/// True if `a` is nowhere worse than `b` and somewhere better (all minimised; same length).
[[nodiscard]] bool dominates(std::span<const double> a, std::span<const double> b);

/// Indices of the points no other point dominates, ascending. Of equal points the first is kept.
/// O(n log n) for two objectives, O(n times size of the front) otherwise.
[[nodiscard]] std::vector<std::size_t> non_dominated(const std::vector<Objectives>& points);

/// Exact volume dominated by `points` below `reference`, all minimised, in the product of the objectives' units. Points
/// not strictly better than the reference in every objective add nothing. One, two or three objectives.
/// 2-D: sweep. 3-D: sweep along the third objective over a 2-D staircase (Beume, Fonseca, Lopez-Ibanez, Paquete,
/// Vahrenhold, IEEE Trans. Evol. Comput. 13 (2009) 1075, whose staircase is a tree; a sorted vector here).
/// Throws std::invalid_argument on another number of objectives or points of another length.
[[nodiscard]] double hypervolume(const std::vector<Objectives>& points, std::span<const double> reference);

/// The frame in which hypervolumes are compared: ideal and nadir (best and worst of each objective on a front).
struct FrontFrame {
  Objectives ideal;  ///< smallest of each objective
  Objectives nadir;  ///< largest of each objective
};

/// Frame of the non-dominated ones of `points`. Throws std::invalid_argument if there is none.
[[nodiscard]] FrontFrame frame_of(const std::vector<Objectives>& points);

/// Hypervolume of `points` after ideal -> 0 and nadir -> 1, against 1.1 in each objective. An objective that does not
/// vary over the frame keeps its unit scale. Dimensionless.
[[nodiscard]] double normalised_hypervolume(const std::vector<Objectives>& points, const FrontFrame& frame);

}  // namespace coilwright::sizing
