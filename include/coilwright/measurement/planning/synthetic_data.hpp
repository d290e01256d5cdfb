#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/measurement/planning/experiment.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement::planning {

/// What a clock of a run really was: a sample stamped t was taken at t + shift + rate * t on the clock of the input.
struct TrueClock {
  double shift{};  ///< s
  double rate{};   ///< relative
};

/// The clocks of the planned runs, drawn from normal distributions with the deviations that their plans give. Equal
/// seeds give the same bits, and a run that is added at the end changes no other.
[[nodiscard]] std::vector<TrueClock> true_clocks(const Experiment& experiment, std::uint64_t seed);

/// Synthetic records of `rig` with the additional effects `hidden`: one simulated, noisy, quantised run per planned
/// run, in order. The noise of a channel depends only on `seed` and on the indices of run and channel, so a run that is
/// added at the end changes no other. The same input gives the same bits.
///
/// Clocks are as true_clocks() draws them; a sample is the mean over the exposure. Where an input has a clock of its
/// own or is not held between samples, the shape itself drives the rig, its edges at their own times, and the recorded
/// input is a sample of it; it goes on before and after the run as far as the clocks may shift. It is off from what
/// acted as the plan's input_uncertainty says. Rigs are changed as their plans say. Throws std::invalid_argument naming
/// the run if it does not fit the rig (number of coils or joints, a voltage without a resistance, an effect that the
/// rig cannot have) or has too many samples (simulation::most_samples, as all runs together), std::runtime_error naming
/// it if its motion cannot be simulated.
[[nodiscard]] std::vector<data::Run> simulate_experiment(const Experiment& experiment, const replay::DeclaredModel& rig,
                                                         std::span<const actuator::Effect> hidden, std::uint64_t seed);

}  // namespace coilwright::measurement::planning
