#pragma once

#include <optional>
#include <span>
#include <vector>

namespace coilwright::measurement::localise {

/// A torque over time with the same interval between samples; where it is not known, zero.
struct EvenSeries {
  double interval{};           ///< s
  std::vector<double> values;  ///< N m, mean removed
};

/// The frequency, Hz, of the strongest line that stands out of the spectra around it, all series taken together;
/// nothing where none does by more than chance (1 in 100 for smooth spectra). Each spectrum is measured by its median
/// within a third of the frequency to both sides; a single series counts for 50 such measures at most, so that a line
/// in many runs stands before one that a single command has made.
[[nodiscard]] std::optional<double> strongest_line(std::span<const EvenSeries> series);

}  // namespace coilwright::measurement::localise
