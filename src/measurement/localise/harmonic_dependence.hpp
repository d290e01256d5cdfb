#pragma once

#include <cstddef>

#include "coilwright/measurement/localise/dependence.hpp"
#include "measurement/localise/pooled_series.hpp"

namespace coilwright::measurement::localise {

/// How much of the torque's variance a sine of `frequency` (Hz) explains whose phase and amplitude are free in each
/// run: fitted to even blocks and tested on odd ones, and the reverse. Its `residual` is the mean amplitude.
[[nodiscard]] Dependence harmonic_dependence(double frequency, const PooledSeries& samples, const SampleBlocks& blocks,
                                             std::size_t motions);

}  // namespace coilwright::measurement::localise
