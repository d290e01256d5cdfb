#pragma once

#include <cstddef>
#include <span>

#include "measurement/declared_readings.hpp"

namespace coilwright::measurement {

/// How far readings are from the declared model, by their squares.
struct MissedSquares {
  double missed = 0.0;  ///< of what the model misses
  double varied = 0.0;  ///< of what the readings vary about their mean
  std::size_t count = 0;
  [[nodiscard]] double rms() const;
};

void add(MissedSquares& sums, const DeclaredReadings& readings);

/// How far readings that have a natural zero (torques, forces, rates) are from what the model declares, whatever their
/// unit: of the readings themselves and, where either vary, of their deviations from the mean, so that a bias of the
/// sensor does not pass for a factor.
struct RelativeDistance {
  double size{};   ///< logarithms of the ratios of both norms, by Pythagoras
  double shape{};  ///< rad, angles between both vectors, likewise
  [[nodiscard]] double whole() const;
};

/// Infinite where one of them is nothing but zeros.
[[nodiscard]] RelativeDistance relative_distance(const DeclaredReadings& readings);

}  // namespace coilwright::measurement
