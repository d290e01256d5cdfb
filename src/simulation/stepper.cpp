#include "stepper.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace coilwright::simulation {
namespace {

namespace odeint = boost::numeric::odeint;

PackedState pack(const State& state) {
  PackedState values(state.angles.data(), state.angles.data() + state.angles.size());
  values.insert(values.end(), state.rates.data(), state.rates.data() + state.rates.size());
  values.insert(values.end(), state.internal.data(), state.internal.data() + state.internal.size());
  return values;
}

// Of a drive's state and in its unit: nearer than this to where it ends is there. Below the error of a step.
constexpr double drive_tolerance = 1e-10;

}  // namespace

double Stepper::ErrorChecker::error(algebra_type& /*algebra*/, const PackedState& values, const PackedState& slopes,
                                    const PackedState& errors, double step) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double floor = i < internal_begin_ ? tolerance_.absolute : tolerance_.internal;
    const double allowed = floor + tolerance_.relative * (std::abs(values[i]) + std::abs(step) * std::abs(slopes[i]));
    largest = std::max(largest, std::abs(errors[i]) / allowed);
  }
  return largest;
}

Stepper::Stepper(const actuator::Model& model, const Tolerance& tolerance)
    : model_(model), controlled_(ErrorChecker(tolerance, model.joints())) {}

void Stepper::derive(const PackedState& values, PackedState& slopes) const {
  const int n = model_.joints();
  const auto count = static_cast<std::size_t>(model_.internal_states());
  const mechanics::JointVector angles = Eigen::Map<const Eigen::VectorXd>(values.data(), n);
  const mechanics::JointVector rates = Eigen::Map<const Eigen::VectorXd>(values.data() + n, n);
  mechanics::JointVector accelerations;
  std::fill_n(slopes.data() + 2 * n, count, 0.0);
  model_.derivative(angles, rates, {values.data() + 2 * n, count}, input_.currents, input_.applied, accelerations,
                    {slopes.data() + 2 * n, count});
  std::copy_n(rates.data(), n, slopes.data());
  std::copy_n(accelerations.data(), n, slopes.data() + n);
}

void Stepper::start(double time, const State& state, Input input) {
  input_ = std::move(input);
  time_ = previous_time_ = time;
  values_ = pack(state);
  if (model_.drive_states() > 0) drive_end_ = model_.settled(state.angles, input_.currents).head(model_.drive_states());
  slopes_.assign(values_.size(), 0.0);
  derive(values_, slopes_);
  previous_values_ = values_;
  previous_slopes_ = slopes_;
}

// The drive's states tend to constants while the input is held. An explicit method that takes a lag of microseconds at
// the edge of its stability never gets there: it keeps an error about its tolerance, and steps of the lag's own length
// for good. Until they have arrived no step is longer than the time in which the last of them would at its present
// speed. The last, not the first: a lag that follows a warming coil passes its own end on the way, at full speed.
void Stepper::approach_drive_end() {
  const double* states = values_.data() + 2 * model_.joints();
  const double* slopes = slopes_.data() + 2 * model_.joints();
  double arrival = 0.0;
  for (Eigen::Index i = 0; i < drive_end_.size(); ++i) {
    const double away = std::abs(drive_end_[i] - states[i]);
    if (away > drive_tolerance) arrival = std::max(arrival, slopes[i] == 0.0 ? next_step_ : away / std::abs(slopes[i]));
  }
  if (arrival > 0.0) next_step_ = std::min(next_step_, arrival);
}

// States that are set to exactly where they end do not move any more, and limit no step.
void Stepper::rest_drive() {
  Eigen::Map<Eigen::VectorXd> states(values_.data() + 2 * model_.joints(), drive_end_.size());
  if (!((states - drive_end_).lpNorm<Eigen::Infinity>() <= drive_tolerance)) return;
  states = drive_end_;
  drive_end_.resize(0);
  derive(values_, slopes_);
}

void Stepper::step() {
  if (drive_end_.size() > 0) {
    rest_drive();
    approach_drive_end();
  }
  std::swap(values_, previous_values_);
  std::swap(slopes_, previous_slopes_);
  previous_time_ = time_;
  advance();
  const double contact = first_contact();
  // A change of the faces' contact in the first or last thousandth of a step is as good as at its end.
  const double share = (contact - previous_time_) / (time_ - previous_time_);
  if (share >= 1e-3 && share <= 1.0 - 1e-3) {
    next_step_ = contact - previous_time_;
    time_ = previous_time_;
    advance();
  }
}

double Stepper::first_contact() const {
  double first = time_;
  for (int j = 0; j < model_.joints(); ++j) {
    const double closing = model_.hinges()[j].contact.closing_angle;
    const bool pressed = previous_values_[j] < closing;
    if (pressed == (values_[j] < closing)) continue;
    double before = previous_time_;
    double after = first;
    for (int i = 0; i < 30; ++i) {
      const double middle = 0.5 * (before + after);
      const bool same = (at(middle).angles[j] < closing) == pressed;
      (same ? before : after) = middle;
    }
    first = after;
  }
  return first;
}

void Stepper::advance() {
  const auto system = [this](const PackedState& values, PackedState& slopes, double /*time*/) {
    derive(values, slopes);
  };
  while (controlled_.try_step(system, previous_values_, previous_slopes_, time_, values_, slopes_, next_step_) ==
         odeint::fail) {
  }
}

State Stepper::at(double time) const {
  PackedState values(values_.size());
  controlled_.stepper().calc_state(time, values, previous_values_, previous_slopes_, previous_time_, values_, slopes_,
                                   time_);
  return unpack(values);
}

Stepper::Bending Stepper::bending() const {
  const int n = model_.joints();
  const auto sum = [n](const PackedState& values, int first) {
    return std::accumulate(values.begin() + first, values.begin() + first + n, 0.0);
  };
  return {.time = time_, .angle = sum(values_, 0), .speed = sum(values_, n), .acceleration = sum(slopes_, n)};
}

State Stepper::unpack(const PackedState& values) const {
  const int n = model_.joints();
  return {.angles = Eigen::Map<const Eigen::VectorXd>(values.data(), n),
          .rates = Eigen::Map<const Eigen::VectorXd>(values.data() + n, n),
          .internal = Eigen::Map<const Eigen::VectorXd>(values.data() + 2 * n, model_.internal_states())};
}

}  // namespace coilwright::simulation
