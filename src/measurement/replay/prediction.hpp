#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "coilwright/simulation/transient.hpp"
#include "measurement/replay/local_numbers.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::replay {

/// A simulated window, on the input's clock.
struct Trajectory {
  std::vector<double> times{};              ///< s, of the rows of the input
  std::vector<simulation::State> states{};  ///< one per time
  simulation::TransientSteps steps{};       ///< of the integrator
  /// The state at a time, s: cubic between the times, constant beyond them; internal states are those of the time
  /// before.
  [[nodiscard]] simulation::State at(double time) const;
};

/// The local numbers of a window with their values; refers to both.
struct LocalValues {
  const LocalNumbers* numbers{};
  std::span<const double> values{};
};

/// Where a window starts: in its local initial state, which is that of what its instruments show first (where they are
/// late, its motion begins so much earlier, under its first input), or in the equilibrium under its first input where
/// it has none. If `internal` is empty, internal states have the values with which a recorded run begins. Nothing if
/// there is no equilibrium.
[[nodiscard]] std::optional<simulation::State> start_of_window(const actuator::Model& model, const Window& window,
                                                               LocalValues local,
                                                               const actuator::InternalStates& internal);
/// Simulates a window from there. Nothing if the motion cannot be simulated, or if there is no equilibrium. `nearby`:
/// the same window of a model, or with local numbers, that hardly differ; both motions then have the same steps, and
/// their difference has no errors of them.
[[nodiscard]] std::optional<Trajectory> simulate_window(const actuator::Model& model, const Window& window,
                                                        LocalValues local, const actuator::InternalStates& internal,
                                                        const Trajectory* nearby = nullptr);

/// What the instruments show of it: channel after channel, SI: (channels * samples). Delay, shutter, scale and offset
/// of the camera, the clocks and the hum are in it.
[[nodiscard]] Eigen::VectorXd observed_values(const actuator::Model& model, const PreparedRun& prepared,
                                              const Window& window, const Trajectory& motion, LocalValues local);

/// A simulated window as the cameras would show it.
struct WindowPrediction {
  Eigen::VectorXd values{};  ///< channel after channel, SI: (channels * samples)
  simulation::State last{};  ///< of the simulated motion, at the last sample
};
/// Simulates a window from `initial`, with clocks that agree, every edge in the middle and no hum. If `initial` has no
/// internal states of the effects, they take the values with which a recorded run begins. Nothing if the motion cannot
/// be simulated.
[[nodiscard]] std::optional<WindowPrediction> predict_window(const actuator::Model& model, const PreparedRun& prepared,
                                                             const Window& window, const simulation::State& initial);

/// Predicts what a bench would show, channel after channel, SI. Nothing if the model has no answer (no equilibrium).
[[nodiscard]] std::optional<Eigen::VectorXd> predict_bench(const actuator::Model& model, const PreparedRun& prepared,
                                                           const DeclaredModel& declared);

/// The measured values of a range of samples, channel after channel, SI.
[[nodiscard]] Eigen::VectorXd measured_values(const data::Run& run, SampleRange range);
/// Differences of measured and predicted values of a range (SI, channel after channel) over their noise, white where
/// the model is right: a linear map. Samples that are set aside become 0; whatever colour makes of their neighbours, it
/// makes of a difference that is straight across them.
[[nodiscard]] Eigen::VectorXd over_noise(const PreparedRun& prepared, SampleRange range, Eigen::VectorXd differences);

}  // namespace coilwright::measurement::replay
