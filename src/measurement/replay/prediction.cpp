#include "measurement/replay/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "coilwright/simulation/blocked_grasp.hpp"
#include "coilwright/simulation/transient.hpp"
#include "coilwright/thermal/transient.hpp"

namespace coilwright::measurement::replay {
namespace {

using actuator::CoilCurrents;
using actuator::Model;
using mechanics::JointVector;
using simulation::State;

// A thousand times below the noise, and smooth enough for derivatives by finite differences.
constexpr double relative_accuracy = 1e-6;
// A model that needs more integration steps per sample (a finger needs one to three, a pressed stop seven) is too stiff
// to explain the record of a camera.
constexpr double most_steps_per_sample = 30.0;
constexpr double most_steps_per_window = 20'000.0;

// Angle and rate of a channel at one sample of a simulated motion.
struct AngleAndRate {
  double value{};
  double rate{};
};

AngleAndRate angle_and_rate(const State& state, const data::Channel& channel) {
  if (channel.kind == data::ChannelKind::bending_angle) return {.value = state.angles.sum(), .rate = state.rates.sum()};
  return {.value = state.angles[channel.joint], .rate = state.rates[channel.joint]};
}

// The cubic through angles and rates at both ends of an interval; its error is 4e-7 of the amplitude at 10 Hz and 500
// samples per second. Before the first sample the angle is the first one.
double angle_at(const std::vector<State>& states, const std::vector<double>& times, const data::Channel& channel,
                double time) {
  if (time <= times.front()) return angle_and_rate(states.front(), channel).value;
  const auto after = std::lower_bound(times.begin(), times.end(), time);
  const auto i = static_cast<std::size_t>(after - times.begin());
  if (*after == time) return angle_and_rate(states[i], channel).value;
  const AngleAndRate a = angle_and_rate(states[i - 1], channel);
  const AngleAndRate b = angle_and_rate(states[i], channel);
  const double h = times[i] - times[i - 1];
  const double s = (time - times[i - 1]) / h;
  const double s2 = s * s;
  const double s3 = s2 * s;
  return (2.0 * s3 - 3.0 * s2 + 1.0) * a.value + (s3 - 2.0 * s2 + s) * h * a.rate + (3.0 * s2 - 2.0 * s3) * b.value +
         (s3 - s2) * h * b.rate;
}

double rate_at(const std::vector<State>& states, const std::vector<double>& times, const data::Channel& channel,
               double time) {
  if (time <= times.front()) return states.front().rates[channel.joint];
  const auto i = static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
  const double share = (time - times[i - 1]) / (times[i] - times[i - 1]);
  return (1.0 - share) * states[i - 1].rates[channel.joint] + share * states[i].rates[channel.joint];
}

CoilCurrents currents_of(const Model& model, const data::Run& run, std::size_t sample) {
  const std::vector<double>& row = run.inputs[sample];
  if (row.size() == 1) return model.all_coils(row[0]);
  return Eigen::Map<const Eigen::VectorXd>(row.data(), static_cast<Eigen::Index>(row.size()));
}

JointVector first_joint_at(const Model& model, double angle) {
  JointVector angles = JointVector::Zero(model.joints());
  angles[0] = angle;
  return angles;
}

// Temperature of the first coil, degC; exact between samples, because the current is held there.
Eigen::VectorXd coil_temperatures(const thermal::Network& network, const data::Run& run) {
  const auto n = static_cast<Eigen::Index>(run.samples());
  Eigen::VectorXd out(n);
  Eigen::Index coil = 0;
  while (network.nodes()[static_cast<std::size_t>(coil)].kind != thermal::NodeKind::coil) ++coil;
  thermal::NodeVector now = thermal::NodeVector::Constant(network.size(), network.ambient());
  for (Eigen::Index i = 0; i < n; ++i) {
    out[i] = now[coil];
    if (i + 1 == n) break;
    const auto sample = static_cast<std::size_t>(i);
    const double current = run.inputs[sample].front();
    const thermal::Transient transient(
        network, {.mean_square_currents = thermal::same_in_every_coil(network, current * current), .initial = now});
    now = transient.temperatures(run.times[sample + 1] - run.times[sample]);
  }
  return out;
}

}  // namespace

std::optional<WindowPrediction> predict_window(const Model& model, const PreparedRun& prepared, const Window& window,
                                               const State& initial) {
  std::vector<State> states;
  try {
    const double most_steps = most_steps_per_window + most_steps_per_sample * static_cast<double>(window.samples());
    states =
        simulation::simulate(model, window.input, initial, {.relative = relative_accuracy, .most_steps = most_steps});
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
  const auto samples = static_cast<Eigen::Index>(window.samples());
  const std::vector<data::Channel>& channels = prepared.run->channels;
  WindowPrediction out{.values = Eigen::VectorXd(prepared.values_in(window.range))};
  const double delay = model.delay();
  Eigen::Index at = 0;
  for (const data::Channel& channel : channels) {
    for (Eigen::Index i = 0; i < samples; ++i) {
      const double time = window.input.times[static_cast<std::size_t>(i)] - delay;
      out.values[at++] = channel.kind == data::ChannelKind::joint_rate
                             ? rate_at(states, window.input.times, channel, time)
                             : model.observed(angle_at(states, window.input.times, channel, time));
    }
  }
  out.states = std::move(states);
  return out;
}

std::optional<Eigen::VectorXd> predict_bench(const Model& model, const PreparedRun& prepared,
                                             const DeclaredModel& declared) {
  const data::Run& run = *prepared.run;
  const auto samples = static_cast<Eigen::Index>(run.samples());
  Eigen::VectorXd one(samples);
  if (run.kind == data::RunKind::temperature) one = coil_temperatures(*declared.heat, run);
  for (Eigen::Index i = 0; i < samples && run.kind != data::RunKind::temperature; ++i) {
    const auto sample = static_cast<std::size_t>(i);
    switch (run.kind) {
      case data::RunKind::static_torque:
        one[i] = model.magnetic_torques(first_joint_at(model, run.angles[sample]), currents_of(model, run, sample))[0];
        break;
      case data::RunKind::joint_stiffness:
        one[i] = -model.hinge_torques(first_joint_at(model, run.angles[sample]))[0];
        break;
      case data::RunKind::blocked_force: {
        const auto grasp = simulation::blocked_grasp(model, currents_of(model, run, sample));
        if (!grasp) return std::nullopt;
        one[i] = grasp->force;
        break;
      }
      case data::RunKind::transient:
      case data::RunKind::temperature:
      case data::RunKind::still:
        break;
    }
  }
  return one.replicate(static_cast<Eigen::Index>(run.channels.size()), 1);
}

Eigen::VectorXd measured_values(const data::Run& run, SampleRange range) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(range.samples() * run.channels.size()));
  Eigen::Index at = 0;
  for (const data::Channel& channel : run.channels)
    for (std::size_t i = range.first; i < range.last; ++i) out[at++] = channel.values[i];
  return out;
}

Eigen::VectorXd noise_sigmas(const PreparedRun& prepared, std::size_t samples) {
  const auto n = static_cast<Eigen::Index>(samples);
  Eigen::VectorXd out(n * static_cast<Eigen::Index>(prepared.noise.size()));
  for (std::size_t c = 0; c < prepared.noise.size(); ++c)
    out.segment(static_cast<Eigen::Index>(c) * n, n).setConstant(prepared.noise[c].sigma);
  return out;
}

}  // namespace coilwright::measurement::replay
