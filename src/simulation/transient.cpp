#include "coilwright/simulation/transient.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "stepper.hpp"

namespace coilwright::simulation {
namespace {

constexpr double most_steps = 1e6;

// More for a model whose effects have states: an explicit method follows a lag of 10 us, under a drive that never comes
// to rest, in steps of three times that.
constexpr double most_steps_per_second = 1e5;

// rad and rad/s, a step: below what a camera or an encoder resolves by four orders; keeps a finger at rest from asking
// for endless accuracy.
constexpr double smallest_error = 1e-9;

double step_limit(const actuator::Model& model, double duration) {
  return most_steps + (model.internal_states() > 0 ? most_steps_per_second * duration : 0.0);
}

State with_internal_states(const actuator::Model& model, const State& start, const actuator::CoilCurrents& currents) {
  const Eigen::Index given = start.internal.size();
  if (given == model.internal_states()) return start;
  if (given != 0)
    throw std::invalid_argument(
        fmt::format("start: {} states of the effects are needed, or none; got {}", model.internal_states(), given));
  return {.angles = start.angles,
          .rates = start.rates,
          .internal = model.settled(start.angles, currents, actuator::InitialHistory::recorded_run)};
}

Stepper::Input input_at(const actuator::Model& model, const ModelInput& signal, std::size_t sample) {
  return {.currents = signal.currents[sample],
          .applied = signal.joint_torques.empty() ? mechanics::JointVector::Zero(model.joints())
                                                  : signal.joint_torques[sample]};
}

// Its curve from one sample to another that ends its piece; nothing where it is held there.
std::optional<algebra::SmoothCurve> curve_between(const actuator::Model& model, const ModelInput& signal,
                                                  std::size_t first, std::size_t last) {
  if (!signal.goes_straight(first)) return std::nullopt;
  const bool has_torques = !signal.joint_torques.empty();
  const auto width = static_cast<std::size_t>(model.coils() + (has_torques ? model.joints() : 0));
  std::vector<double> values;
  values.reserve(width * (last + 1 - first));
  const auto add = [&](const auto& row) { values.insert(values.end(), row.data(), row.data() + row.size()); };
  for (std::size_t row = first; row <= last; ++row) {
    add(signal.currents[row]);
    if (has_torques) add(signal.joint_torques[row]);
  }
  return algebra::SmoothCurve(std::span(signal.times).subspan(first, last + 1 - first), values, width);
}

// Whether b only goes on with what is held at a.
bool same_input(const ModelInput& signal, std::size_t a, std::size_t b) {
  if (signal.goes_straight(a) || signal.goes_straight(b)) return false;
  return signal.currents[a] == signal.currents[b] &&
         (signal.joint_torques.empty() || signal.joint_torques[a] == signal.joint_torques[b]);
}

// Waits until a motion under a held input has come to rest. An explicit method that takes a stiff model at the edge of
// its stability trembles by the error of its steps for good, so that rates and slopes never vanish.
class RestWatch {
 public:
  RestWatch(const actuator::Model& model, const Stepper& stepper, double relative)
      : joints_(static_cast<std::size_t>(model.joints())), relative_(relative) {
    begin(stepper);
  }

  // Whether it has moved by no more than that for long enough; what it was before is forgotten where it has.
  [[nodiscard]] bool is_over(const Stepper& stepper) {
    constexpr double enough = 0.25;  // s: half a period of 2 Hz, the slowest that a finger of this size swings at
    if (!stays(stepper.packed())) begin(stepper);
    return stepper.time() - since_ >= enough;
  }

 private:
  void begin(const Stepper& stepper) {
    since_ = stepper.time();
    from_ = stepper.packed();
  }
  // Angles and states of effects; rates follow. A stiff state trembles by more than a joint.
  [[nodiscard]] bool stays(const PackedState& now) const {
    const auto stay = [&](std::size_t first, std::size_t last, double errors) {
      for (std::size_t i = first; i < last; ++i)
        if (!(std::abs(now[i] - from_[i]) <= errors * relative_ * std::abs(from_[i]) + smallest_move)) return false;
      return true;
    };
    return stay(0, joints_, 2.0) && stay(2 * joints_, now.size(), 10.0);
  }

  static constexpr double smallest_move = 1e-8;  // rad, or whatever the state has
  std::size_t joints_;
  double relative_;
  double since_{};
  PackedState from_{};
};

// Takes the steps of one part of a transient, those that are given as far as they go, and keeps their ends.
class Steps {
 public:
  Steps(const Accuracy& accuracy, std::size_t part, double start) : start_(start) {
    if (accuracy.steps != nullptr && part < accuracy.steps->size()) given_ = (*accuracy.steps)[part];
    if (accuracy.taken != nullptr) taken_ = &accuracy.taken->emplace_back();
  }

  void take(Stepper& stepper) {
    constexpr double nothing = 1e-12;  // s
    while (!given_.empty() && start_ + given_.front() <= stepper.time() + nothing) given_ = given_.subspan(1);
    if (given_.empty())
      stepper.step();
    else
      stepper.step_to(start_ + given_.front());
    if (taken_ != nullptr) taken_->push_back(stepper.time() - start_);
  }

 private:
  double start_;  // s
  std::span<const double> given_{};
  std::vector<double>* taken_ = nullptr;
};

// A finger whose joint turns by half a turn has left its torque curves behind; a rig without magnetics may turn freely.
void check_motion(const actuator::Model& model, const PackedState& state, double time) {
  const auto joints = static_cast<std::size_t>(model.joints());
  double largest = 0.0;
  bool finite = true;
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (i >= joints && i < 2 * joints) continue;  // rates
    finite = finite && std::isfinite(state[i]);
    if (i < joints) largest = std::max(largest, std::abs(state[i]));
  }
  if (!finite) throw std::runtime_error(fmt::format("the motion leaves the model at {:.6g} s: it is not finite", time));
  if (largest > std::numbers::pi && !model.magnetics().hinge_pairs().empty())
    throw std::runtime_error(
        fmt::format("the motion leaves the model at {:.6g} s: a joint turns beyond 180 degrees", time));
}

void check_times(const ModelInput& input, std::span<const double> times) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!(times[i] >= input.times.front() && times[i] <= input.times.back()))
      throw std::invalid_argument(fmt::format("times: must be from {} to {} s, the input's; got {}",
                                              input.times.front(), input.times.back(), times[i]));
    if (i > 0 && times[i] <= times[i - 1])
      throw std::invalid_argument(fmt::format("times: must increase; got {} after {} s", times[i], times[i - 1]));
  }
}

}  // namespace

std::vector<State> simulate(const actuator::Model& model, const ModelInput& input, const State& start,
                            const Accuracy& accuracy) {
  return simulate_at(model, input, start, input.times, accuracy);
}

std::vector<State> simulate_at(const actuator::Model& model, const ModelInput& input, const State& start,
                               std::span<const double> times, const Accuracy& accuracy) {
  input.require_fits(model);
  check_times(input, times);
  std::vector<State> out;
  out.reserve(times.size());
  Stepper stepper(model, {.relative = accuracy.relative, .absolute = smallest_error, .internal = smallest_error});
  State now = with_internal_states(model, start, input.currents.front());
  std::size_t sample = 0;
  std::size_t next = 0;
  std::size_t part = 0;
  double all_steps = 0.0;
  if (accuracy.taken != nullptr) accuracy.taken->clear();
  for (; next < times.size() && times[next] <= input.times.front(); ++next) out.push_back(now);
  while (next < times.size()) {
    // One run of the integrator covers all samples up to the next change or corner of the input.
    std::size_t last = sample + 1;
    while (last + 1 < input.times.size() && (same_input(input, sample, last) || input.passes(last))) ++last;
    const double end = input.times[last];
    stepper.start(input.times[sample], now, input_at(model, input, sample), curve_between(model, input, sample, last));
    RestWatch rest(model, stepper, accuracy.relative);
    const bool may_rest = accuracy.ends_at_rest && !input.goes_straight(sample) && !model.has_slow_states();
    const double limit = std::min(all_steps + step_limit(model, end - input.times[sample]), accuracy.most_steps);
    Steps steps(accuracy, part++, input.times[sample]);
    const auto state_at = [&](double time) {
      while (stepper.time() < time) {
        if (may_rest && rest.is_over(stepper)) return stepper.now();
        steps.take(stepper);
        check_motion(model, stepper.packed(), stepper.time());
        if (accuracy.progress) accuracy.progress(stepper.time());
        if (++all_steps > limit)
          throw std::runtime_error(fmt::format("the motion cannot be followed beyond {:.6g} s", stepper.time()));
      }
      return stepper.at(time);
    };
    for (; next < times.size() && times[next] <= end; ++next) out.push_back(state_at(times[next]));
    if (next < times.size()) now = state_at(end);
    sample = last;
  }
  return out;
}

std::vector<State> simulate_as_observed(const actuator::Model& model, const ModelInput& input, const State& start,
                                        const Accuracy& accuracy) {
  input.require_fits(model);
  const double delay = model.delay();
  std::vector<double> times;
  times.reserve(input.times.size());
  for (const double time : input.times)
    if (time - delay > input.times.front()) times.push_back(time - delay);
  const State first = with_internal_states(model, start, input.currents.front());
  // Records stamped too early show what comes after the last sample: the input is held there.
  ModelInput held = input;
  if (delay < 0.0) {
    held.times.push_back(input.times.back() - delay);
    held.currents.push_back(input.currents.back());
    if (!input.joint_torques.empty()) held.joint_torques.push_back(input.joint_torques.back());
    if (!input.straight.empty()) held.straight.push_back(0);
    if (!input.passed.empty()) held.passed.push_back(0);
  }
  std::vector<State> out(input.times.size() - times.size(), first);
  std::vector<State> later = simulate_at(model, held, first, times, accuracy);
  out.insert(out.end(), std::move_iterator(later.begin()), std::move_iterator(later.end()));
  return out;
}

}  // namespace coilwright::simulation
