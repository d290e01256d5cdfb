#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "coilwright/measurement/planning/instrument.hpp"

namespace coilwright::measurement::planning {

/// What the noise of a channel depends on: each triple has a random stream of its own.
struct NoiseStream {
  std::uint64_t seed{};
  std::size_t run{};
  std::size_t channel{};
};

/// The readings of an instrument for true values at `times` (s; empty on a bench, where noise is white and does not
/// hum): noise of its colour, hum at a random phase and outliers are added, and the sum is rounded to the resolution.
/// A noise of 0 leaves all other random numbers as they are.
[[nodiscard]] std::vector<double> apply_instrument(const Instrument& instrument, const NoiseStream& stream,
                                                   std::span<const double> times, std::vector<double> values);

/// Standard normal numbers of a stream, for what is drawn once a run.
[[nodiscard]] std::vector<double> normal_numbers(const NoiseStream& stream, std::size_t count);

}  // namespace coilwright::measurement::planning
