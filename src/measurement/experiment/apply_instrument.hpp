#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "coilwright/measurement/experiment/instrument.hpp"

namespace coilwright::measurement::experiment {

/// What the noise of a channel depends on: each triple has a random stream of its own.
struct NoiseStream {
  std::uint64_t seed{};
  std::size_t run{};
  std::size_t channel{};
};

/// The readings of an instrument for true values: white Gaussian noise is added, and the sum is rounded to the
/// resolution.
[[nodiscard]] std::vector<double> apply_instrument(const Instrument& instrument, const NoiseStream& stream,
                                                   std::vector<double> values);

}  // namespace coilwright::measurement::experiment
