#pragma once

#include "coilwright/magnetics/wrench.hpp"

namespace coilwright::magnetics {

/// The outline of a coil or a magnet: a ring about its axis, of rectangular section.
struct Outline {
  double inner_radius{};  ///< m; 0 for a magnet
  double outer_radius{};  ///< m
  double length{};        ///< m, along the axis
};

[[nodiscard]] Outline outline_of(const ThickCoil& coil);
[[nodiscard]] Outline outline_of(const CylinderMagnet& magnet);

/// Whether two bodies are in the same place, as no two parts can be, the second one in `pose` seen from the first. By
/// points on and in each, 2.5 degrees and a 48th of a length apart: what overlaps by less than a thousandth of
/// the smaller body's size, or between such points, may not be seen. Precondition: a pose as wrench() takes it.
[[nodiscard]] bool overlap(const Outline& first, const Outline& second, const Pose& pose);

}  // namespace coilwright::magnetics
