#include "coilwright/simulation/recorded_motion.hpp"

#include <cstddef>
#include <span>

namespace coilwright::simulation {
namespace {

std::vector<double> shown_angles(const actuator::Model& model, const std::vector<State>& states) {
  std::vector<double> out;
  out.reserve(states.size());
  for (const State& state : states) {
    const std::span<const double> internal(state.internal.data(), static_cast<std::size_t>(state.internal.size()));
    const mechanics::JointVector angles = model.shown(state.angles, state.rates, internal).angles;
    out.push_back(model.observed(model.bending_angle(angles)));
  }
  return out;
}

}  // namespace

RecordedMotion record_motion(const actuator::Model& model, const ModelInput& input, const State& start,
                             const Accuracy& accuracy) {
  RecordedMotion out;
  // First, so that the states of two motions are never held at once.
  if (model.delay() != 0.0)
    out.bending_angles = shown_angles(model, simulate_as_observed(model, input, start, accuracy));
  out.states = simulate(model, input, start, accuracy);
  if (model.delay() == 0.0) out.bending_angles = shown_angles(model, out.states);
  return out;
}

}  // namespace coilwright::simulation
