#include "stepper.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace coilwright::simulation {
namespace {

namespace odeint = boost::numeric::odeint;

PackedState pack(const State& state) {
  PackedState values(state.angles.data(), state.angles.data() + state.angles.size());
  values.insert(values.end(), state.rates.data(), state.rates.data() + state.rates.size());
  return values;
}

}  // namespace

Stepper::Stepper(const actuator::Model& model, const Tolerance& tolerance)
    : model_(model), controlled_(Controlled::error_checker_type(tolerance.absolute, tolerance.relative)) {}

void Stepper::derive(const PackedState& values, PackedState& slopes) const {
  const State state = unpack(values);
  const mechanics::JointVector accelerations =
      model_.accelerations(state.angles, state.rates, input_.currents, input_.applied);
  std::copy_n(state.rates.data(), state.rates.size(), slopes.data());
  std::copy_n(accelerations.data(), accelerations.size(), slopes.data() + state.rates.size());
}

void Stepper::start(double time, const State& state, Input input) {
  input_ = std::move(input);
  time_ = previous_time_ = time;
  values_ = pack(state);
  slopes_.resize(values_.size());
  derive(values_, slopes_);
  previous_values_ = values_;
  previous_slopes_ = slopes_;
}

void Stepper::step() {
  std::swap(values_, previous_values_);
  std::swap(slopes_, previous_slopes_);
  previous_time_ = time_;
  advance();
  const double contact = first_contact();
  // A change of the faces' contact in the first or last thousandth of a step is as good as at its end.
  const double share = (contact - previous_time_) / (time_ - previous_time_);
  if (share < 1e-3 || share > 1.0 - 1e-3) return;
  next_step_ = contact - previous_time_;
  time_ = previous_time_;
  advance();
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
  const auto middle = values_.begin() + model_.joints();
  return {.time = time_,
          .angle = std::accumulate(values_.begin(), middle, 0.0),
          .speed = std::accumulate(middle, values_.end(), 0.0),
          .acceleration = std::accumulate(slopes_.begin() + model_.joints(), slopes_.end(), 0.0)};
}

State Stepper::unpack(const PackedState& values) const {
  const int n = model_.joints();
  return {.angles = Eigen::Map<const Eigen::VectorXd>(values.data(), n),
          .rates = Eigen::Map<const Eigen::VectorXd>(values.data() + n, n)};
}

}  // namespace coilwright::simulation
