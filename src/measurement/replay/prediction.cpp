#include "measurement/replay/prediction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "coilwright/simulation/blocked_grasp.hpp"
#include "coilwright/simulation/initial_state.hpp"
#include "coilwright/simulation/transient.hpp"
#include "coilwright/thermal/transient.hpp"
#include "measurement/replay/if_possible.hpp"
#include "measurement/replay/input_rows.hpp"
#include "measurement/replay/input_whitener.hpp"
#include "measurement/replay/window_input.hpp"

namespace coilwright::measurement::replay {
namespace {

using actuator::CoilCurrents;
using actuator::Model;
using mechanics::JointVector;
using simulation::ModelInput;
using simulation::State;

// A thousand times below the noise, and smooth enough for derivatives by finite differences.
constexpr double relative_accuracy = 1e-6;
// A model that needs more integration steps per sample (a finger needs one to three, a pressed stop seven) is too stiff
// to explain the record of a camera.
constexpr double most_steps_per_sample = 30.0;
constexpr double most_steps_per_window = 20'000.0;

// Where a time lies on a trajectory.
struct Place {
  std::size_t before{};  // index of the state at or before it
  double share{};        // of the interval to the next one, 0 to 1
};

// `guess` is looked at first, and the interval after it: samples are asked for in their order.
Place place_of(const std::vector<double>& times, double time, std::size_t guess = 0) {
  if (time <= times.front()) return {};
  if (time >= times.back()) return {.before = times.size() - 1};
  const auto is_in = [&](std::size_t i) { return i + 1 < times.size() && times[i] <= time && time < times[i + 1]; };
  std::size_t i = is_in(guess) ? guess : guess + 1;
  if (!is_in(i)) i = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin()) - 1;
  return {.before = i, .share = (time - times[i]) / (times[i + 1] - times[i])};
}

// Weights of both values and of both slopes (times the interval) of the cubic through values and slopes at both ends.
struct CubicWeights {
  double a, b, slope_a, slope_b;
};

CubicWeights cubic(double s) {
  const double s2 = s * s;
  const double s3 = s2 * s;
  return {.a = 2.0 * s3 - 3.0 * s2 + 1.0, .b = 3.0 * s2 - 2.0 * s3, .slope_a = s3 - 2.0 * s2 + s, .slope_b = s3 - s2};
}

double angle_of(const State& state, const data::Channel& channel) {
  return channel.kind == data::ChannelKind::bending_angle ? state.angles.sum() : state.angles[channel.joint];
}

double rate_of(const State& state, const data::Channel& channel) {
  return channel.kind == data::ChannelKind::bending_angle ? state.rates.sum() : state.rates[channel.joint];
}

// A channel's angle between two states: the cubic's error is 4e-7 of the amplitude at 10 Hz and 500 rows a second.
double angle_at(const Trajectory& trajectory, const data::Channel& channel, const Place& place) {
  const State& a = trajectory.states[place.before];
  if (place.share == 0.0) return angle_of(a, channel);
  const State& b = trajectory.states[place.before + 1];
  const double h = trajectory.times[place.before + 1] - trajectory.times[place.before];
  const CubicWeights w = cubic(place.share);
  return w.a * angle_of(a, channel) + w.b * angle_of(b, channel) +
         h * (w.slope_a * rate_of(a, channel) + w.slope_b * rate_of(b, channel));
}

double rate_at(const Trajectory& trajectory, const data::Channel& channel, const Place& place) {
  const double rate = rate_of(trajectory.states[place.before], channel);
  if (place.share == 0.0) return rate;
  return (1.0 - place.share) * rate + place.share * rate_of(trajectory.states[place.before + 1], channel);
}

// The mean over a shutter that is open for `exposure` around `time`: Gauss's rule of three points, exact for a cubic.
template <class Value>
double mean_over(double time, double exposure, const Value& value) {
  if (exposure == 0.0) return value(time);
  static const double reach = 0.5 * std::sqrt(0.6);
  return (5.0 * value(time - reach * exposure) + 8.0 * value(time) + 5.0 * value(time + reach * exposure)) / 18.0;
}

// Adds the hum that one angle channel shows: each line's cosine and sine, and both growing over the window.
void add_lines(const PreparedRun& prepared, const Window& window, std::span<const double> amplitudes,
               Eigen::Ref<Eigen::VectorXd> values) {
  const std::vector<double>& times = prepared.run->times;
  const double first = times[window.range.first];
  const double duration = times[window.range.last - 1] - first;
  for (std::size_t l = 0; l < prepared.lines.size(); ++l) {
    const std::span<const double> of_line = amplitudes.subspan(4 * l, 4);
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const double time = times[window.range.first + static_cast<std::size_t>(i)] - first;
      const double phase = 2.0 * std::numbers::pi * prepared.lines[l] * time;
      const double grown = 2.0 * time / duration - 1.0;
      values[i] +=
          (of_line[0] + grown * of_line[2]) * std::cos(phase) + (of_line[1] + grown * of_line[3]) * std::sin(phase);
    }
  }
}

// Values of samples that are set aside, straight between those beside them.
void bridge(const std::vector<char>& set_aside, std::size_t first, Eigen::Ref<Eigen::VectorXd> values) {
  const Eigen::Index n = values.size();
  const auto aside = [&](Eigen::Index i) { return set_aside[first + static_cast<std::size_t>(i)] != 0; };
  for (Eigen::Index i = 0; i < n; ++i) {
    if (!aside(i)) continue;
    Eigen::Index end = i;
    while (end < n && aside(end)) ++end;
    const double left = i > 0 ? values[i - 1] : (end < n ? values[end] : 0.0);
    const double right = end < n ? values[end] : left;
    for (Eigen::Index k = i; k < end; ++k)
      values[k] = left + (right - left) * static_cast<double>(k - i + 1) / static_cast<double>(end - i + 1);
    i = end;
  }
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

// Where the grasp was measured: closed and at the tip where the run does not say. A fit that shortens the last segment
// takes the contact along.
actuator::GraspPoint grasp_point(const Model& model, const data::Run& run, std::size_t sample) {
  actuator::GraspPoint out;
  if (!run.openings.empty()) out.opening = run.openings[sample];
  if (!run.heights.empty()) out.height = std::min(run.heights[sample], model.tip().along);
  return out;
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

std::optional<Trajectory> simulated(const Model& model, const ModelInput& input, const State& start,
                                    const Trajectory* nearby = nullptr) {
  return if_possible<Trajectory>([&] {
    Trajectory out{.times = input.times};
    const double most_steps = most_steps_per_window + most_steps_per_sample * static_cast<double>(input.times.size());
    out.states = simulation::simulate(model, input, start,
                                      {.relative = relative_accuracy,
                                       .most_steps = most_steps,
                                       .ends_at_rest = true,
                                       .steps = nearby != nullptr ? &nearby->steps : nullptr,
                                       .taken = nearby == nullptr ? &out.steps : nullptr});
    return out;
  });
}

// The first row of an input is held for so long before it, with rows that are dense enough.
void begin_earlier(ModelInput& input, double by) {
  const double first = input.times.front();
  const auto rows = static_cast<std::size_t>(std::ceil(by / densest_needed));
  const auto prepend = [rows](auto& values, const auto& value) { values.insert(values.begin(), rows, value); };
  prepend(input.times, first);
  for (std::size_t i = 0; i < rows; ++i)
    input.times[i] -= by * static_cast<double>(rows - i) / static_cast<double>(rows);
  prepend(input.currents, CoilCurrents(input.currents.front()));
  if (!input.joint_torques.empty()) prepend(input.joint_torques, JointVector(input.joint_torques.front()));
  if (!input.straight.empty()) prepend(input.straight, char{0});
  if (!input.passed.empty()) prepend(input.passed, char{0});
}

std::optional<State> start_under(const Model& model, const ModelInput& input, LocalValues local,
                                 const actuator::InternalStates& internal) {
  if (!local.numbers->has_initial_state()) return simulation::equilibrium_at_first_input(model, input);
  State start = local.numbers->initial_state(local.values, internal);
  if (internal.size() == 0)
    start.internal = model.settled(start.angles, input.currents.front(), actuator::InitialHistory::recorded_run);
  return start;
}

// The motion as a camera with states of its own shows it.
Trajectory as_shown(const Model& model, const Trajectory& motion) {
  Trajectory out{.times = motion.times};
  out.states.reserve(motion.states.size());
  for (const State& state : motion.states) {
    const auto shown = model.shown(state.angles, state.rates,
                                   {state.internal.data(), static_cast<std::size_t>(state.internal.size())});
    out.states.push_back({.angles = shown.angles, .rates = shown.rates, .internal = {}});
  }
  return out;
}

}  // namespace

State Trajectory::at(double time) const {
  const Place place = place_of(times, time);
  const State& a = states[place.before];
  if (place.share == 0.0) return a;
  const State& b = states[place.before + 1];
  const double h = times[place.before + 1] - times[place.before];
  const CubicWeights w = cubic(place.share);
  return {.angles = w.a * a.angles + w.b * b.angles + h * (w.slope_a * a.rates + w.slope_b * b.rates),
          .rates = (1.0 - place.share) * a.rates + place.share * b.rates,
          .internal = a.internal};
}

std::optional<Trajectory> simulate_window(const Model& model, const Window& window, LocalValues local,
                                          const actuator::InternalStates& internal, const Trajectory* nearby) {
  // An initial state is of what is shown first, which is the motion a delay earlier.
  const double earlier = local.numbers->has_initial_state() ? std::max(model.delay(), 0.0) : 0.0;
  const bool as_planned = earlier == 0.0 && window.edges.empty() && window.bend.times.empty() && window.errors.empty();
  ModelInput driven = as_planned ? ModelInput{}
                                 : as_driven(window, {.edges = local.numbers->edge_numbers(local.values),
                                                      .bend = local.numbers->bend(local.values),
                                                      .errors = local.numbers->input_errors(local.values)});
  if (earlier > 0.0) begin_earlier(driven, earlier);
  const ModelInput& input = as_planned ? window.input : driven;
  const auto start = if_possible<State>([&] { return start_under(model, input, local, internal); });
  return start ? simulated(model, input, *start, nearby) : std::nullopt;
}

std::optional<State> start_of_window(const Model& model, const Window& window, LocalValues local,
                                     const actuator::InternalStates& internal) {
  return start_under(model, window.input, local, internal);
}

Eigen::VectorXd observed_values(const Model& model, const PreparedRun& prepared, const Window& window,
                                const Trajectory& motion, LocalValues local) {
  const data::Run& run = *prepared.run;
  const Trajectory filtered = model.camera_filters() ? as_shown(model, motion) : Trajectory{};
  const Trajectory& trajectory = model.camera_filters() ? filtered : motion;
  const auto samples = static_cast<Eigen::Index>(window.samples());
  Eigen::VectorXd out(prepared.values_in(window.range));
  const double first = run.times[window.range.first];
  const double rate = local.numbers->clock_rate(local.values);
  const double shift = local.numbers->clock_offset(local.values) - model.delay();
  const std::span<const double> amplitudes = local.numbers->line_amplitudes(local.values);
  const std::size_t per_channel = 4 * prepared.lines.size();
  std::size_t angle_channels = 0;
  Eigen::Index at = 0;
  for (const data::Channel& channel : run.channels) {
    const bool is_rate = channel.kind == data::ChannelKind::joint_rate;
    Place place;
    for (Eigen::Index i = 0; i < samples; ++i) {
      const double stamp = run.times[window.range.first + static_cast<std::size_t>(i)];
      const double time = stamp + rate * (stamp - first) + shift;
      const double value = mean_over(time, run.clock.exposure, [&](double when) {
        place = place_of(trajectory.times, when, place.before);
        return is_rate ? rate_at(trajectory, channel, place) : angle_at(trajectory, channel, place);
      });
      out[at + i] = is_rate ? value : model.observed(value);
    }
    if (!is_rate && per_channel > 0)
      add_lines(prepared, window, amplitudes.subspan(per_channel * angle_channels++, per_channel),
                out.segment(at, samples));
    at += samples;
  }
  return out;
}

std::optional<WindowPrediction> predict_window(const Model& model, const PreparedRun& prepared, const Window& window,
                                               const State& initial) {
  const std::optional<Trajectory> motion = simulated(model, window.input, initial);
  if (!motion) return std::nullopt;
  // The clocks of the run agree, and its readings have no hum: local numbers of a run without either.
  data::Run plain{.kind = prepared.run->kind, .clock = {.exposure = prepared.run->clock.exposure}};
  plain.times = prepared.run->times;
  plain.channels = prepared.run->channels;
  PreparedRun as_planned{.run = &plain};
  const LocalNumbers none(as_planned, {.range = window.range});
  return WindowPrediction{
      .values = observed_values(model, as_planned, window, *motion, {.numbers = &none, .values = none.mean()}),
      .last = motion->at(prepared.run->times[window.range.last - 1])};
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
        const auto grasp =
            simulation::blocked_grasp(model, currents_of(model, run, sample), grasp_point(model, run, sample));
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

Eigen::VectorXd over_noise(const PreparedRun& prepared, SampleRange range, Eigen::VectorXd differences) {
  if (const InputWhitener* whitener = prepared.input_whitener(range))
    return whitener->innovations(prepared, differences);
  const auto n = static_cast<Eigen::Index>(range.samples());
  for (std::size_t c = 0; c < prepared.noise.size(); ++c) {
    auto of_channel = differences.segment(static_cast<Eigen::Index>(c) * n, n);
    of_channel /= prepared.noise[c].sigma;
    const bool any_aside = c < prepared.set_aside.size() && !prepared.set_aside[c].empty();
    const bool coloured = c < prepared.whiteners.size() && prepared.whiteners[c] != nullptr;
    if (any_aside && coloured) bridge(prepared.set_aside[c], range.first, of_channel);
    if (coloured) prepared.whiteners[c]->apply(of_channel);
    if (!any_aside) continue;
    for (Eigen::Index i = 0; i < n; ++i)
      if (prepared.is_set_aside(c, range.first + static_cast<std::size_t>(i))) of_channel[i] = 0.0;
  }
  return differences;
}

}  // namespace coilwright::measurement::replay
