#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "coilwright/measurement/experiment/instrument.hpp"

namespace coilwright::measurement::experiment {

/// Whose noise it is.
struct NoisePlace {
  std::uint64_t seed{};
  std::size_t run{};
  std::size_t channel{};
};

/// Turns true values into readings: adds white Gaussian noise and rounds to the resolution. Each place has a stream of
/// its own.
void read_by(const Instrument& instrument, const NoisePlace& place, std::span<double> values);

}  // namespace coilwright::measurement::experiment
