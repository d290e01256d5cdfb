#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "measurement/fit/fit.hpp"

namespace coilwright::measurement::fit {

/// Sets samples aside that no motion can show: up to three in a row whose residual lies more than six standard
/// deviations from that of their neighbours (noise::spikes). What a wrong model leaves is smooth from sample to sample,
/// so that it does not count. Also takes the noise level of channels that have some anew without them, where the run
/// itself tells it. True if any sample was set aside that was not before.
[[nodiscard]] bool set_outliers_aside(std::span<replay::PreparedRun> runs, const Fit& fitted);

/// The same, but only if what is set aside makes up much of what the fit leaves over: a fifth of its squared residual
/// above the noise. Otherwise the runs stay as they are, and it returns false.
[[nodiscard]] bool set_outliers_aside_if_much(std::span<replay::PreparedRun> runs, const Fit& fitted);

}  // namespace coilwright::measurement::fit
