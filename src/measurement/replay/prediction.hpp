#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::replay {

/// What the cameras would have shown over a window from `start`. A start without states of the effects finds them as a
/// recorded run does. Nothing where the motion cannot be followed.
struct WindowPrediction {
  Eigen::VectorXd values{};                 ///< channel after channel, SI: (channels * samples)
  std::vector<simulation::State> states{};  ///< the motion itself, a state a sample
};
[[nodiscard]] std::optional<WindowPrediction> predict_window(const actuator::Model& model, const Record& record,
                                                             const Window& window, const simulation::State& start);

/// What a bench would have shown, channel after channel, SI. Nothing where the model has no answer (no equilibrium).
[[nodiscard]] std::optional<Eigen::VectorXd> predict_bench(const actuator::Model& model, const Record& record,
                                                           const DeclaredModel& declared);

/// The measured values in the same order, of the samples from `first` to `last`.
[[nodiscard]] Eigen::VectorXd measured_values(const data::Run& run, std::size_t first, std::size_t last);
/// The standard deviation of each of them.
[[nodiscard]] Eigen::VectorXd sigmas(const Record& record, std::size_t samples);

}  // namespace coilwright::measurement::replay
