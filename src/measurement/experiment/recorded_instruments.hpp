#pragma once

#include <span>

#include "coilwright/measurement/experiment/instrument.hpp"
#include "measurement/fit/fit.hpp"

namespace coilwright::measurement::experiment {

/// The instruments that made these records. The noise of each is the median of what its runs have; its colour the
/// nearest that an experiment can say: white, behind a low pass of first order, or 1 / f. What rounds readings is part
/// of the noise.
[[nodiscard]] Instruments recorded_instruments(std::span<const replay::PreparedRun> runs, const fit::Fit& fit);

/// The colour nearest to a spectrum, by least squares of the logarithms of its bands' densities.
[[nodiscard]] NoiseColour nearest_colour(const noise::NoiseColour& recorded);

}  // namespace coilwright::measurement::experiment
