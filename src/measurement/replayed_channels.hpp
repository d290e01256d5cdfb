#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "coilwright/measurement/error_comparison.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement {

/// One series for each channel of a run, SI, over the samples that are simulated.
using Channels = std::vector<std::vector<double>>;

/// The values of a run by its channels. `values` are in the order of PreparedRun::sample_ranges().
[[nodiscard]] Channels by_channel(const replay::PreparedRun& prepared, const Eigen::VectorXd& values);

/// The question what a finished model shows of one run. It refers to both.
[[nodiscard]] fit::FitRequest request_for(const replay::PreparedRun& prepared,
                                          const identification::FittedHypothesis& model);

/// What the instruments of a run show of a finished model: only the local numbers of the run are fitted. Nothing if the
/// model cannot be simulated there.
[[nodiscard]] std::optional<Channels> shown_of(const replay::PreparedRun& prepared,
                                               const identification::FittedHypothesis& model);

/// One channel of a run as it was measured, with its outliers and without predictions.
[[nodiscard]] Replay measured_channel(const replay::PreparedRun& prepared, std::size_t channel, bool validate);

}  // namespace coilwright::measurement
