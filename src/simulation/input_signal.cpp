#include "coilwright/simulation/input_signal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace coilwright::simulation {
namespace {

constexpr double most_samples = 1e8;

std::vector<double> sample_times(double duration, double interval) {
  if (!std::isfinite(duration) || duration <= 0.0)
    throw std::invalid_argument(fmt::format("duration must be finite and > 0; got {}", duration));
  if (!std::isfinite(interval) || interval <= 0.0)
    throw std::invalid_argument(fmt::format("interval must be finite and > 0; got {}", interval));
  const double count = std::floor(duration / interval * (1.0 + 1e-12));
  if (count > most_samples)
    throw std::invalid_argument(fmt::format("duration / interval must be at most {}; got {}", most_samples, count));
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(count) + 1);
  for (std::size_t i = 0; i <= static_cast<std::size_t>(count); ++i) times.push_back(static_cast<double>(i) * interval);
  return times;
}

}  // namespace

void InputSignal::check(const actuator::Model& model) const {
  if (times.empty()) throw std::invalid_argument("input: at least one sample is needed; got 0");
  if (currents.size() != times.size())
    throw std::invalid_argument(
        fmt::format("input: one row of currents per time, {} here; got {}", times.size(), currents.size()));
  if (!joint_torques.empty() && joint_torques.size() != times.size())
    throw std::invalid_argument(
        fmt::format("input: one row of torques per time, {} here; got {}", times.size(), joint_torques.size()));
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]) || (i > 0 && times[i] <= times[i - 1]))
      throw std::invalid_argument(fmt::format("input: time must increase; sample {} is at {} s", i, times[i]));
    if (currents[i].size() != model.coils() || !currents[i].allFinite())
      throw std::invalid_argument(
          fmt::format("input: sample {} must have {} finite currents; got {}", i, model.coils(), currents[i].size()));
    if (!joint_torques.empty() && (joint_torques[i].size() != model.joints() || !joint_torques[i].allFinite()))
      throw std::invalid_argument(fmt::format("input: sample {} must have {} finite torques; got {}", i, model.joints(),
                                              joint_torques[i].size()));
  }
}

InputSignal step_input(const actuator::Model& model, const StepInput& step) {
  InputSignal signal;
  signal.times = sample_times(step.duration, step.interval);
  signal.currents.assign(signal.times.size(), model.all_coils(step.current));
  return signal;
}

InputSignal sine_input(const actuator::Model& model, const SineInput& sine) {
  InputSignal signal;
  signal.times = sample_times(sine.duration, sine.interval);
  signal.currents.reserve(signal.times.size());
  for (const double t : signal.times)
    signal.currents.push_back(
        model.all_coils(sine.offset + sine.amplitude * std::sin(2.0 * std::numbers::pi * sine.frequency * t)));
  return signal;
}

}  // namespace coilwright::simulation
