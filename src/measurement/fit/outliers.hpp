#pragma once

#include <optional>
#include <span>
#include <vector>

#include "measurement/fit/fit.hpp"

namespace coilwright::measurement::fit {

/// Sets samples aside that stand apart as no motion does: up to three in a row whose residual lies more than six
/// standard deviations from that of their neighbours (signals::spikes). What a wrong model leaves is smooth from sample
/// to sample, so that it does not count. Also takes the noise level of channels that have some anew without them, where
/// the run itself tells it. True if any sample was set aside that was not before.
[[nodiscard]] bool set_outliers_aside(std::span<replay::PreparedRun> runs, const Fit& fitted);

/// Takes samples back that lie within three standard deviations of the noise from the prediction of `fitted`: what
/// stood apart from a model that lacked an effect, as on the steep onset of a step that few pictures show, was no
/// outlier. True if there was any.
[[nodiscard]] bool take_back(std::span<replay::PreparedRun> runs, const Fit& fitted);

/// The runs with those samples set aside, too, that are suspected only: up to three in a row that lie more than four
/// robust standard deviations of what the fit leaves of their channel from its prediction, if they are at most the
/// fraction `most` of the channel. Outliers that pull at the few pictures of a run, and at its clock, hide themselves
/// among what is left; a fit without the suspects shows which of them stand apart. Nothing where there are none.
[[nodiscard]] std::optional<std::vector<replay::PreparedRun>> with_suspects_aside(
    std::span<const replay::PreparedRun> runs, const Fit& fitted, double most = 0.1);

/// As set_outliers_aside(), but only if what is set aside makes up much of what the fit leaves over: a fifth of its
/// squared residual above the noise. Otherwise the runs stay as they are, and it returns false.
[[nodiscard]] bool set_outliers_aside_if_much(std::span<replay::PreparedRun> runs, const Fit& fitted);

}  // namespace coilwright::measurement::fit
