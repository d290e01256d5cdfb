#pragma once

#include <optional>
#include <span>
#include <vector>

namespace coilwright::measurement::localise {

/// A torque over time at equal intervals; zero at samples where it is not known.
struct EvenSeries {
  double interval{};           ///< s
  std::vector<double> values;  ///< N m, mean removed
};

/// The frequency, Hz, of the strongest spectral line of all series together; nothing if no line exceeds its
/// surroundings by more than chance (1 in 100 for smooth spectra). Each spectrum is normalised by its median within a
/// third of the frequency to both sides. The normalised power of a single series counts as 50 at most, so that a line
/// in many runs precedes one that a single command has caused.
[[nodiscard]] std::optional<double> strongest_spectral_line(std::span<const EvenSeries> series);

}  // namespace coilwright::measurement::localise
