#include "measurement/replay/input_whitener.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "coilwright/algebra/minimum_norm.hpp"
#include "measurement/replay/input_rows.hpp"
#include "measurement/replay/linear_motion.hpp"
#include "measurement/replay/rig_change.hpp"

namespace coilwright::measurement::replay {
namespace {

using actuator::Model;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using simulation::State;

// One unit of each column of the input.
std::vector<DrivingInput> units_of(const Model& model, const data::Run& run) {
  simulation::CommandedInput command = run.command();
  const std::size_t columns = run.input_uncertainty.sigma.size();
  command.times.clear();
  command.rows.assign(columns, std::vector<double>(columns, 0.0));
  for (std::size_t c = 0; c < columns; ++c) {
    command.times.push_back(static_cast<double>(c));
    command.rows[c][c] = 1.0;
  }
  const simulation::ModelInput input = simulation::model_input(model, command);
  std::vector<DrivingInput> out;
  for (std::size_t c = 0; c < columns; ++c)
    out.push_back({.currents = input.currents[c],
                   .torques = input.joint_torques.empty() ? mechanics::JointVector::Zero(model.joints())
                                                          : input.joint_torques[c]});
  return out;
}

// What a camera shows of a state in one channel, rad or rad/s.
double shown_of(const Model& model, const data::Channel& channel, const State& state) {
  const auto seen =
      model.shown(state.angles, state.rates, {state.internal.data(), static_cast<std::size_t>(state.internal.size())});
  if (channel.kind == data::ChannelKind::joint_rate) return seen.rates[channel.joint];
  return model.observed(channel.kind == data::ChannelKind::bending_angle ? seen.angles.sum()
                                                                         : seen.angles[channel.joint]);
}

// How that changes with the state, and not with the errors of the input, of which there are so many.
VectorXd shown_by(const Model& model, const data::Channel& channel, const State& state, Eigen::Index errors) {
  constexpr double step = 1e-6;
  const Eigen::Index size = size_of_changes(model);
  VectorXd out = VectorXd::Zero(size + errors);
  VectorXd change = VectorXd::Zero(size);
  const double here = shown_of(model, channel, state);
  for (Eigen::Index i = 0; i < size; ++i) {
    change[i] = step;
    out[i] = (shown_of(model, channel, displaced(state, change)) - here) / step;
    change[i] = 0.0;
  }
  return out;
}

// Covariances of the changes of a window's state and of the errors of its input, along a motion.
class Covariance {
 public:
  Covariance(const Model& model, const PreparedRun& prepared, const Window& window, const Trajectory& motion)
      : model_(model), window_(window), motion_(motion), units_(units_of(model, *prepared.run)) {
    const data::InputUncertainty& uncertainty = prepared.run->input_uncertainty;
    inputs_ = prepared.run->times_of_inputs();
    const double interval = (inputs_.back() - inputs_.front()) / static_cast<double>(inputs_.size() - 1);
    correlation_ = uncertainty.correlation < 0.5 * interval ? 0.0 : uncertainty.correlation;
    variances_ = Eigen::Map<const VectorXd>(uncertainty.sigma.data(), errors()).cwiseAbs2();
    free = MatrixXd::Zero(states() + errors(), states() + errors());
    free.bottomRightCorner(errors(), errors()) = variances_.asDiagonal();
    const double first = prepared.run->times[window.range.first];
    begin = std::max(window.input.times.front(), first - ringing_time);
    if (!prepared.fits_initial_state(window)) rest();
    known = free;
  }

  [[nodiscard]] Eigen::Index states() const { return size_of_changes(model_); }
  [[nodiscard]] Eigen::Index errors() const { return static_cast<Eigen::Index>(units_.size()); }

  // Moves both from one time to another; returns the transition of state and errors. Errors that have a correlation
  // fade in steps that are short against it; others end where a sample of the input does.
  MatrixXd move(double from, double to) {
    const double longest = correlation_ > 0.0 ? std::min(densest_needed, 0.25 * correlation_) : densest_needed;
    MatrixXd whole = MatrixXd::Identity(free.rows(), free.cols());
    for (double time = from; time < to;) {
      double end = std::min(to, time + longest);
      double kept = 1.0;
      if (correlation_ > 0.0) {
        kept = std::exp((time - end) / correlation_);
      } else {
        const auto next = std::ranges::upper_bound(inputs_, time);
        const bool is_new = next != inputs_.end() && *next <= end;
        if (is_new) end = *next;
        if (is_new) kept = 0.0;
      }
      const MatrixXd step = step_over(time, end, kept);
      for (MatrixXd* each : {&known, &free}) {
        *each = step * *each * step.transpose();
        each->bottomRightCorner(errors(), errors()).diagonal() += (1.0 - kept * kept) * variances_;
      }
      whole = step * whole;
      time = end;
    }
    return whole;
  }

  double begin{};  // s, from when on it follows the errors: what they did long before the first sample has died away
  MatrixXd known;  // with what readings have told
  MatrixXd free;   // without

 private:
  [[nodiscard]] LinearMotion about(double time) const {
    return linear_motion(model_, motion_.at(time), input_at(model_, window_.input, time), units_);
  }

  [[nodiscard]] MatrixXd step_over(double from, double to, double kept) const {
    const double middle = 0.5 * (from + to);
    LinearMotion motion = about(middle);
    hold_joints(model_, motion_.at(middle), motion);
    const LinearStep step = step_of(motion, to - from);
    MatrixXd out = MatrixXd::Zero(free.rows(), free.cols());
    out.topLeftCorner(states(), states()) = step.transition;
    out.topRightCorner(states(), errors()) = step.response;
    out.bottomRightCorner(errors(), errors()).diagonal().setConstant(kept);
    return out;
  }

  // A run that starts at rest is simulated from the equilibrium under its first input as it was recorded.
  void rest() {
    const Eigen::Index joints = model_.joints();
    const LinearMotion first = about(begin);
    MatrixXd both = MatrixXd::Zero(free.rows(), errors());
    both.topRows(joints) = -algebra::minimum_norm_columns(first.by_state.block(joints, 0, joints, joints),
                                                          first.by_input.middleRows(joints, joints));
    both.bottomRows(errors()).setIdentity();
    free = both * variances_.asDiagonal() * both.transpose();
  }

  const Model& model_;
  const Window& window_;
  const Trajectory& motion_;
  std::vector<DrivingInput> units_;
  std::vector<double> inputs_;  // s, of the samples
  VectorXd variances_;
  double correlation_{};  // s; 0: none
};

}  // namespace

InputWhitener::InputWhitener(const Model& model, const PreparedRun& prepared, const Window& window,
                             const Trajectory& motion, LocalValues local)
    : range_(window.range), channels_(prepared.run->channels.size()), deviations_(prepared.values_in(window.range)) {
  const data::Run& run = *prepared.run;
  Covariance covariance(model, prepared, window, motion);
  const double first = run.times[range_.first];
  double before = covariance.begin;
  for (std::size_t i = 0; i < range_.samples(); ++i) {
    const double stamp = run.times[range_.first + i];
    const double time = stamp + local.numbers->clock_rate(local.values) * (stamp - first) +
                        local.numbers->clock_offset(local.values) - model.delay();
    const MatrixXd transition = covariance.move(before, time);
    if (i > 0) transitions_.push_back(transition);
    before = time;
    const State state = motion.at(time);
    for (std::size_t c = 0; c < channels_; ++c) {
      Reading reading{.shown = shown_by(model, run.channels[c], state, covariance.errors())};
      deviations_[static_cast<Eigen::Index>(c * range_.samples() + i)] =
          std::sqrt(reading.shown.dot(covariance.free * reading.shown));
      const VectorXd seen = covariance.known * reading.shown;
      const double variance = reading.shown.dot(seen) + prepared.noise[c].sigma * prepared.noise[c].sigma;
      reading.gain = seen / variance;
      reading.deviation = std::sqrt(variance);
      if (!prepared.is_set_aside(c, range_.first + i)) covariance.known -= reading.gain * seen.transpose();
      readings_.push_back(std::move(reading));
    }
  }
}

VectorXd InputWhitener::innovations(const PreparedRun& prepared, const VectorXd& differences) const {
  VectorXd out = VectorXd::Zero(differences.size());
  VectorXd state = VectorXd::Zero(readings_.front().shown.size());
  VectorXd moved(state.size());
  for (std::size_t i = 0; i < range_.samples(); ++i) {
    if (i > 0) {
      moved.noalias() = transitions_[i - 1] * state;
      state.swap(moved);
    }
    for (std::size_t c = 0; c < channels_; ++c) {
      if (prepared.is_set_aside(c, range_.first + i)) continue;
      const Reading& reading = readings_[i * channels_ + c];
      const auto at = static_cast<Eigen::Index>(c * range_.samples() + i);
      const double innovation = differences[at] - reading.shown.dot(state);
      out[at] = innovation / reading.deviation;
      state += innovation * reading.gain;
    }
  }
  return out;
}

void weigh_input_errors(PreparedRun& prepared, const Model& model, const std::vector<std::vector<double>>& local) {
  if (prepared.run->input_uncertainty.sigma.empty() || !current_flows(prepared.run->rig)) return;
  actuator::InternalStates internal;
  for (std::size_t w = 0; w < prepared.windows.size(); ++w) {
    Window& window = prepared.windows[w];
    const LocalNumbers numbers(prepared, window);
    const bool is_of_these = w < local.size() && local[w].size() == numbers.size();
    const LocalValues values{.numbers = &numbers, .values = is_of_these ? local[w] : numbers.mean()};
    const std::optional<Trajectory> motion = simulate_window(model, window, values, internal);
    if (!motion) return;
    window.input_whitener = std::make_shared<const InputWhitener>(model, prepared, window, *motion, values);
    internal = motion->at(prepared.run->times[window.range.last - 1]).internal;
  }
}

}  // namespace coilwright::measurement::replay
