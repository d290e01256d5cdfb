#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::replay {

/// A simulated window as the cameras would show it.
struct WindowPrediction {
  Eigen::VectorXd values{};                 ///< channel after channel, SI: (channels * samples)
  std::vector<simulation::State> states{};  ///< the simulated motion, one state per sample
};
/// Simulates a window from `initial`. If `initial` has no internal states of the effects, they take the values with
/// which a recorded run begins. Nothing if the motion cannot be simulated.
[[nodiscard]] std::optional<WindowPrediction> predict_window(const actuator::Model& model, const PreparedRun& prepared,
                                                             const Window& window, const simulation::State& initial);

/// Predicts what a bench would show, channel after channel, SI. Nothing if the model has no answer (no equilibrium).
[[nodiscard]] std::optional<Eigen::VectorXd> predict_bench(const actuator::Model& model, const PreparedRun& prepared,
                                                           const DeclaredModel& declared);

/// The measured values of a range of samples, channel after channel, SI.
[[nodiscard]] Eigen::VectorXd measured_values(const data::Run& run, SampleRange range);
/// The standard deviation of each of so many samples of every channel, in the same order.
[[nodiscard]] Eigen::VectorXd noise_sigmas(const PreparedRun& prepared, std::size_t samples);

}  // namespace coilwright::measurement::replay
