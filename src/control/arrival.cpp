#include "coilwright/control/arrival.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/initial_state.hpp"
#include "coilwright/simulation/transient.hpp"

namespace coilwright::control {
namespace {

constexpr double look = 0.5e-3;  // s
constexpr double smallest_change = 1e-6;

// Good to 1e-4 of a settling time (docs/theory/simulation.md); a search asks a thousand times.
const simulation::Accuracy accuracy{.relative = 1e-5};

}  // namespace

Arrival arrival(const actuator::Model& model, const CurrentProfile& profile, double duration) {
  const simulation::ModelInput input = input_of(model, profile, duration);
  std::optional<simulation::State> start =
      simulation::state_at_rest(model, model.all_coils(profile.before), mechanics::JointVector::Zero(model.joints()));
  if (!start) throw std::runtime_error("has no stable pose under the current at the start");
  if (model.has_slow_states()) {
    const actuator::Model held = model.with_slow_states_held(start->internal);
    return arrival(held, profile, duration);
  }
  const auto looks = static_cast<std::size_t>(std::ceil(duration / look));
  std::vector<double> times(looks + 1);
  for (std::size_t i = 0; i <= looks; ++i) times[i] = std::min(duration, static_cast<double>(i) * look);
  if (times[looks] == times[looks - 1]) times.pop_back();
  const std::vector<simulation::State> states = simulation::simulate_at(model, input, *start, times, accuracy);
  const std::optional<mechanics::JointVector> equilibrium =
      simulation::find_equilibrium(model, model.all_coils(profile.last()), states.back().angles);
  if (!equilibrium) throw std::runtime_error("has no stable pose under the current at the end");

  Arrival out{.start = start->angles.sum(), .end = equilibrium->sum()};
  const double change = out.end - out.start;
  if (std::abs(change) < smallest_change) throw std::runtime_error("does not move under the profile");
  const double band = settling_band * std::abs(change);
  double last_outside = 0.0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const double off = states[i].angles.sum() - out.end;
    const double before = i == 0 ? 0.0 : times[i] - times[i - 1];
    out.time_outside += before * off * off / (off * off + band * band);
    out.overshoot = std::max(out.overshoot, off / change);
    out.peak_speed = std::max(out.peak_speed, std::abs(states[i].rates.sum()));
    if (std::abs(off) > band) last_outside = times[i];
  }
  if (last_outside < times.back()) out.settling_time = last_outside;
  return out;
}

}  // namespace coilwright::control
