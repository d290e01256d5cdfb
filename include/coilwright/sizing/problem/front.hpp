#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace coilwright::sizing {

/// One point in objective space; every objective is minimised.
using Objectives = std::vector<double>;

/// True if `a` is nowhere above `b` and somewhere below it. Both have the same length.
[[nodiscard]] bool dominates(std::span<const double> a, std::span<const double> b);

/// Indices of the points that no other point dominates, ascending. Of equal points the first one is kept. O(n log n)
/// for two objectives, otherwise O(n times size of the front).
[[nodiscard]] std::vector<std::size_t> non_dominated(const std::vector<Objectives>& points);

/// Exact volume that `points` dominate below `reference`, in the product of the objectives' units, for one, two or
/// three objectives. Points that are not below the reference in every objective add nothing. With two objectives it
/// takes a sweep; with three a sweep along the third one over the two-dimensional front of the first two (Beume,
/// Fonseca, Lopez-Ibanez, Paquete, Vahrenhold, IEEE Trans. Evol. Comput. 13 (2009) 1075). Throws std::invalid_argument
/// for another number of objectives or points of another length.
[[nodiscard]] double hypervolume(const std::vector<Objectives>& points, std::span<const double> reference);

/// The ideal and nadir points of a front, between which hypervolumes are normalised.
struct FrontFrame {
  Objectives ideal;  ///< smallest value of each objective
  Objectives nadir;  ///< largest value of each objective
};

/// Frame of the points that no other point dominates. Throws std::invalid_argument if there are none.
[[nodiscard]] FrontFrame frame_of(const std::vector<Objectives>& points);

/// Hypervolume of `points` in coordinates in which the ideal point is 0 and the nadir point 1 in every objective, below
/// the reference 1.1. An objective that does not vary over the frame is only shifted. Dimensionless.
[[nodiscard]] double normalised_hypervolume(const std::vector<Objectives>& points, const FrontFrame& frame);

}  // namespace coilwright::sizing
