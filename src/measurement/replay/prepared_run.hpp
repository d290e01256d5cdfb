#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"
#include "coilwright/measurement/replay/known_fits.hpp"
#include "coilwright/measurement/signals/noise_level.hpp"
#include "coilwright/simulation/model_input.hpp"
#include "coilwright/simulation/state.hpp"
#include "measurement/signals/whitener.hpp"

namespace coilwright::measurement::replay {

/// Consecutive samples that are simulated from one initial state.
struct SampleRange {
  std::size_t first{};
  std::size_t last{};  ///< one past the last sample
  [[nodiscard]] std::size_t samples() const { return last - first; }
};

/// Prior of an initial state: angles and rates are normally distributed, each by itself.
struct InitialStatePrior {
  simulation::State mean{};
  simulation::State sigma{};
};

/// An edge of the input whose place between two samples is unknown. A number without bounds says where it is: it is
/// about as likely everywhere between them (within a factor of two over nine tenths of the way) if that number has the
/// standard normal distribution, and a fit meets no wall at the samples.
struct InputEdge {
  std::size_t row{};    ///< of the window's input, which begins in the middle between the two samples
  double half_width{};  ///< s, half the distance of the two samples

  /// How much later than in the middle it lies, s: 0 at 0, never as much as half_width.
  [[nodiscard]] double shift(double number) const { return half_width * number / std::sqrt(1.0 + number * number); }
  /// The slope of shift(), s; > 0.
  [[nodiscard]] double slope(double number) const { return half_width * std::pow(1.0 + number * number, -1.5); }
  /// The number of a shift; its size is below half_width.
  [[nodiscard]] double number(double shift) const {
    const double share = shift / half_width;
    return share / std::sqrt(1.0 - share * share);
  }
};

/// What noise may have left in rows of a window's input, one standard deviation of it.
struct InputRowErrors {
  std::size_t first_row{};
  std::vector<actuator::CoilCurrents> currents{};       ///< A, of that row and those after it
  std::vector<mechanics::JointVector> joint_torques{};  ///< N m, likewise; empty where the input has none
};

/// How many runs were simulated: one run of a set, with all its windows, at one set of parameters. Simulations for the
/// derivatives with respect to the initial states of windows are not counted.
using SimulationCount = std::shared_ptr<std::atomic<long>>;

class InputWhitener;

/// A part of a motion that is simulated from one initial state.
struct Window {
  SampleRange range{};
  simulation::ModelInput input{};  ///< that drives it, on the input's clock; its rows are dense enough to interpolate
                                   ///< the motion between them, and may reach beyond the samples on both sides
  std::vector<InputEdge> edges{};
  simulation::ModelInput bend{};  ///< what a smooth curve through the samples of the input adds to straight lines
                                  ///< between them, row by row; empty where that is next to nothing
  std::vector<InputRowErrors> errors{};  ///< of an input with noise
  InitialStatePrior prior{};             ///< from its first samples of the measurement; empty where it starts at rest
  /// What makes residuals white where the recorded input is not exact (weigh_input_errors()); null: they are.
  std::shared_ptr<const InputWhitener> input_whitener{};

  [[nodiscard]] std::size_t samples() const { return range.samples(); }
};

/// A run as fits use it: inputs as the model takes them, noise, windows. Refers to the run.
struct PreparedRun {
  const data::Run* run{};
  std::vector<signals::NoiseLevel> noise{};  ///< one per channel
  /// What makes the noise of a channel white, one per channel; null: it is white, or the input is not exact.
  std::vector<std::shared_ptr<const signals::Whitener>> whiteners{};
  std::vector<double> lines{};       ///< Hz, of hum that every angle shows
  std::vector<double> line_sizes{};  ///< rad, amplitude of each in the record of the noise
  std::vector<std::vector<char>>
      set_aside{};       ///< one per channel: for each sample whether no fit may use it; empty: none
  double input_noise{};  ///< standard deviation of the noise taken out of its input, SI; 0: none
  /// How many times the noise the model of a fit is expected to be wrong: priors, of declared numbers and of what only
  /// this run tells, hold so much more than against noise alone. The same in all runs of a fit.
  double model_error = 1.0;
  std::vector<Window> windows{};                  ///< of a transient; empty on a bench
  SimulationCount simulations{};                  ///< counts those of all copies; null: nobody asks
  std::shared_ptr<const KnownFits> known_fits{};  ///< of all runs of a fit; null: each fit is made

  void count_simulations(std::size_t more) const {
    if (simulations) *simulations += static_cast<long>(more);
  }
  /// The ranges of its predictions and residuals: its windows, or all samples of a bench. Predictions are ordered range
  /// after range, and channel after channel within a range.
  [[nodiscard]] std::vector<SampleRange> sample_ranges() const;
  /// Number of predictions in one range, and in all of them.
  [[nodiscard]] Eigen::Index values_in(SampleRange range) const;
  [[nodiscard]] Eigen::Index values() const;
  [[nodiscard]] bool is_set_aside(std::size_t channel, std::size_t sample) const {
    return channel < set_aside.size() && !set_aside[channel].empty() && set_aside[channel][sample] != 0;
  }
  /// The whitener of the input in the window with these samples; null where there is none.
  [[nodiscard]] const InputWhitener* input_whitener(SampleRange range) const;
  /// Number of samples that no fit may use, all channels together.
  [[nodiscard]] Eigen::Index values_set_aside() const;
  [[nodiscard]] bool is_motion() const { return run->kind == data::RunKind::transient; }
  /// Whether the initial state of one of its windows is fitted along with the parameters: of a run that starts at rest
  /// that of all but the first.
  [[nodiscard]] bool fits_initial_state(const Window& window) const {
    return is_motion() && (run->start != data::Start::at_rest || window.range.first > 0);
  }
};

/// PreparedRun::model_error of the runs of a fit; 1 where there are none.
[[nodiscard]] inline double model_error_of(std::span<const PreparedRun> runs) {
  return runs.empty() ? 1.0 : runs.front().model_error;
}

/// Whether the errors of any recorded input are weighed (weigh_input_errors()).
[[nodiscard]] bool weighs_input_errors(std::span<const PreparedRun> runs);

/// Throws std::invalid_argument naming the run if it does not fit the model: number of coils or joints, a voltage
/// without a resistance, a temperature without heat paths, a grasp beyond the tip.
void require_fits_model(const data::Run& run, const DeclaredModel& declared, const actuator::Model& nominal);
/// The noise of a run that has no record of still instruments is estimated from the run. Throws as require_fits_model()
/// does, and for a window of fewer than five samples.
[[nodiscard]] PreparedRun prepare_run(const data::Run& run, const DeclaredModel& declared,
                                      const actuator::Model& nominal);

}  // namespace coilwright::measurement::replay
