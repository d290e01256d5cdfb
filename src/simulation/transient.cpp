#include "coilwright/simulation/transient.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "stepper.hpp"

namespace coilwright::simulation {
namespace {

constexpr int most_steps = 1'000'000;

// rad and rad/s, a step: below what a camera or an encoder resolves by four orders; keeps a finger at rest from asking
// for endless accuracy.
constexpr double smallest_error = 1e-9;

Stepper::Input input_at(const actuator::Model& model, const InputSignal& signal, std::size_t sample) {
  return {.currents = signal.currents[sample],
          .applied = signal.joint_torques.empty() ? mechanics::JointVector::Zero(model.joints())
                                                  : signal.joint_torques[sample]};
}

bool same_input(const InputSignal& signal, std::size_t a, std::size_t b) {
  return signal.currents[a] == signal.currents[b] &&
         (signal.joint_torques.empty() || signal.joint_torques[a] == signal.joint_torques[b]);
}

// A finger whose joint turns by half a turn has left its torque curves behind; a rig without magnetics may turn freely.
void check_motion(const actuator::Model& model, const State& state, double time) {
  if (!state.angles.allFinite())
    throw std::runtime_error(fmt::format("the motion leaves the model at {:.6g} s: it is not finite", time));
  if (!model.magnetics().hinge_pairs().empty() && state.angles.lpNorm<Eigen::Infinity>() > std::numbers::pi)
    throw std::runtime_error(
        fmt::format("the motion leaves the model at {:.6g} s: a joint turns beyond 180 degrees", time));
}

}  // namespace

std::vector<State> simulate(const actuator::Model& model, const InputSignal& input, const State& start,
                            const Accuracy& accuracy) {
  input.check(model);
  std::vector<State> out;
  out.reserve(input.times.size());
  out.push_back(start);
  Stepper stepper(model, {.relative = accuracy.relative, .absolute = smallest_error});
  std::size_t sample = 0;
  while (sample + 1 < input.times.size()) {
    // One run of the integrator covers all samples up to the next change of the input.
    std::size_t last = sample + 1;
    while (last + 1 < input.times.size() && same_input(input, sample, last)) ++last;
    stepper.start(input.times[sample], out.back(), input_at(model, input, sample));
    int steps = 0;
    for (std::size_t next = sample + 1; next <= last; ++next) {
      while (stepper.time() < input.times[next]) {
        stepper.step();
        check_motion(model, stepper.now(), stepper.time());
        if (++steps > most_steps)
          throw std::runtime_error(fmt::format("the motion cannot be followed beyond {:.6g} s", stepper.time()));
      }
      out.push_back(stepper.at(input.times[next]));
    }
    sample = last;
  }
  return out;
}

}  // namespace coilwright::simulation
