#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "coilwright/measurement/localise/residual_torque.hpp"
#include "measurement/localise/pooled_series.hpp"

namespace coilwright::measurement::localise {

/// The dependences of the torque of one measured series on each variable by itself: angle, rate, sign of rate,
/// acceleration, time, run; currents and their history if the model has coils; the applied torque if there is one; the
/// spectral line at `line` (Hz) if there is one.
[[nodiscard]] std::vector<Dependence> dependences_of(std::span<const MeasuredMotion> motions,
                                                     const PooledSeries& samples, const SampleBlocks& blocks,
                                                     std::size_t series, std::optional<double> line);

}  // namespace coilwright::measurement::localise
