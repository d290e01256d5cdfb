#include "stepper.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "crossing.hpp"

namespace coilwright::simulation {
namespace {

namespace odeint = boost::numeric::odeint;

PackedState pack(const State& state) {
  PackedState values(state.angles.data(), state.angles.data() + state.angles.size());
  values.insert(values.end(), state.rates.data(), state.rates.data() + state.rates.size());
  values.insert(values.end(), state.internal.data(), state.internal.data() + state.internal.size());
  return values;
}

// The currents, then the torques of one row.
constexpr std::size_t largest_input = std::size_t{actuator::CoilCurrents::MaxRowsAtCompileTime} +
                                      std::size_t{mechanics::JointVector::MaxRowsAtCompileTime};

}  // namespace

Stepper::Stepper(const actuator::Model& model, const StepTolerance& tolerance)
    : model_(model),
      error_checker_(tolerance, model.joints()),
      controlled_(error_checker_),
      stiff_(model, tolerance),
      drive_(model),
      held_joints_(model) {}

void Stepper::derive(const PackedState& values, PackedState& slopes, double time) const {
  if (!drive_.knows_something()) {
    derive_whole(values, slopes, time);
    return;
  }
  derive_whole(drive_.whole(values, time), slopes, time);
  drive_.leave_what_is_integrated(slopes, time);
}

Stepper::Input Stepper::input_at(double time) const {
  Input out{.currents = actuator::CoilCurrents(model_.coils()), .applied = mechanics::JointVector(model_.joints())};
  std::array<double, largest_input> row;
  const std::span<double> used = std::span(row).first(curve_->width());
  curve_->at(time, used);
  std::copy_n(used.begin(), model_.coils(), out.currents.data());
  if (static_cast<int>(used.size()) > model_.coils())
    std::copy_n(used.begin() + model_.coils(), model_.joints(), out.applied.data());
  else
    out.applied.setZero();
  return out;
}

// What the drive's states tend to along the input's curve: a curve through what they tend to at its rows. The terms
// before them in the drive may bend it.
algebra::SmoothCurve Stepper::drive_ends() const {
  const int states = model_.drive_states();
  const std::span<const double> times = curve_->times();
  std::vector<double> ends;
  ends.reserve(times.size() * static_cast<std::size_t>(states));
  for (std::size_t row = 0; row < times.size(); ++row) {
    const actuator::InternalStates settled = model_.settled_drive(input_at(times[row]).currents);
    ends.insert(ends.end(), settled.begin(), settled.end());
  }
  return algebra::SmoothCurve(times, ends, static_cast<std::size_t>(states));
}

PackedDerivative Stepper::derivative_at(double time) const {
  return [this, time](const PackedState& values, PackedState& slopes) { derive_held(values, slopes, time, {}); };
}

void Stepper::derive_held(const PackedState& values, PackedState& slopes, double time,
                          std::span<const int> held) const {
  const int n = model_.joints();
  const auto count = static_cast<std::size_t>(model_.internal_states());
  const mechanics::JointVector angles = Eigen::Map<const Eigen::VectorXd>(values.data(), n);
  mechanics::JointVector rates = Eigen::Map<const Eigen::VectorXd>(values.data() + n, n);
  for (const int joint : held) rates[joint] = 0.0;
  mechanics::JointVector accelerations;
  std::fill_n(slopes.data() + 2 * n, count, 0.0);
  const auto under = [&](const actuator::CoilCurrents& currents, const mechanics::JointVector& applied) {
    model_.derivative(angles, rates, {values.data() + 2 * n, count}, currents, applied, accelerations,
                      {slopes.data() + 2 * n, count}, held);
  };
  if (curve_) {
    const Input now = input_at(time);
    under(now.currents, now.applied);
  } else {
    under(input_.currents, input_.applied);
  }
  std::copy_n(rates.data(), n, slopes.data());
  std::copy_n(accelerations.data(), n, slopes.data() + n);
}

void Stepper::start(double time, const State& state, Input input, std::optional<algebra::SmoothCurve> curve) {
  input_ = std::move(input);
  curve_ = std::move(curve);
  drive_.forget();
  time_ = previous_time_ = time;
  values_ = pack(state);
  slopes_.assign(values_.size(), 0.0);
  friction_change_.reset();
  change_friction(values_, -1);
  derive_whole(values_, slopes_, time_);
  if (model_.drive_states() > 0 && !curve_)
    drive_.hold(time, model_.settled_drive(input_.currents), values_, slopes_,
                [&](const PackedState& values, PackedState& slopes) { derive_whole(values, slopes, time); });
  if (curve_ && drive_.knows_along_curves()) drive_.follow(drive_ends(), values_, slopes_);
  previous_values_ = values_;
  previous_slopes_ = slopes_;
  shorten_step_after_rest();
}

// What was at rest has taken long steps, and its motion now is another one. Shorter ones find their way themselves.
void Stepper::shorten_step_after_rest() {
  constexpr double long_step = 0.02;  // s; a finger in motion takes a third of that
  if (next_step_ > long_step) next_step_ = std::min(next_step_, first_step());
}

// A step over which the solution hardly bends: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I
// (1993), II.4, for order 5, by the norm of the largest. The estimated error of a much longer one means nothing: it may
// be accepted with joints degrees off.
double Stepper::first_step() const {
  const auto largest = [&](const PackedState& of) {
    double out = 0.0;
    for (std::size_t i = 0; i < of.size(); ++i)
      out = std::max(out, std::abs(of[i]) / error_checker_.allowed(i, std::abs(values_[i])));
    return out;
  };
  const double size = largest(values_);
  const double slope = largest(slopes_);
  const double guess = size < 1e-5 || slope < 1e-5 ? 1e-6 : 0.01 * size / slope;
  PackedState there(values_);
  for (std::size_t i = 0; i < there.size(); ++i) there[i] += guess * slopes_[i];
  PackedState bent(slopes_.size(), 0.0);
  derive(there, bent, time_ + guess);
  for (std::size_t i = 0; i < bent.size(); ++i) bent[i] = (bent[i] - slopes_[i]) / guess;
  const double steepest = std::max(slope, largest(bent));
  constexpr double order = 5.0;
  const double other = steepest <= 1e-15 ? std::max(1e-6, 1e-3 * guess) : std::pow(0.01 / steepest, 1.0 / order);
  return std::min(100.0 * guess, other);
}

void Stepper::step() {
  is_given_ = false;
  take_step();
}

void Stepper::step_to(double end) {
  is_given_ = true;
  next_step_ = end - time_;
  take_step();
}

void Stepper::take_step() {
  if (friction_change_) {
    const HeldJoints::Change change = *friction_change_;
    PackedState whole = packed();
    if (!change.slips) {
      const auto rate = static_cast<std::size_t>(model_.joints() + change.joint);
      values_[rate] -= whole[rate];
      whole[rate] = 0.0;
    }
    change_friction(whole, change.slips ? change.joint : -1);
    derive(values_, slopes_, time_);
    if (!is_given_) shorten_step_after_rest();
  }
  if (drive_.come_to_rest(values_)) derive(values_, slopes_, time_);
  if (!is_given_) next_step_ = drive_.longest_step(values_, slopes_, next_step_);
  drive_.forget_what_is_gone(time_);
  previous_values_ = values_;
  previous_slopes_ = slopes_;
  previous_time_ = time_;
  const bool may_be_stiff = !contact_changed_ && !curve_ && !model_.has_terms();
  last_was_stiff_ = may_be_stiff && step_stiffly();
  if (!last_was_stiff_) step_explicitly();
}

bool Stepper::step_stiffly() {
  const StiffStep::Taken taken =
      stiff_.take(previous_values_, previous_slopes_, input_.currents, input_.applied, next_step_, is_given_);
  next_step_ = taken.next;
  contact_changed_ = taken.contact_changed;
  if (taken.duration == 0.0) return false;
  time_ = previous_time_ + taken.duration;
  values_.assign(stiff_.end().begin(), stiff_.end().end());
  slopes_.resize(values_.size());
  derive(values_, slopes_, time_);
  return true;
}

void Stepper::step_explicitly() {
  // A change of faces in the first or last thousandth of a step is as good as at its end. One of friction is not: a
  // joint that stops is put at rest, and its rate there has to be zero, or two motions that hardly differ would come
  // out apart.
  constexpr double least = 1e-3;
  constexpr double least_of_friction = 1e-9;  // not nothing: friction of the wrong sign would keep it there
  advance();
  const double whole = time_ - previous_time_;
  double end = first_contact();
  contact_changed_ = end - previous_time_ >= least * whole && end - previous_time_ <= (1.0 - least) * whole;
  if (!contact_changed_) end = time_;
  friction_change_ = first_friction_change(end);
  if (friction_change_) {
    end = std::max(friction_change_->time, previous_time_ + least_of_friction * whole);
    contact_changed_ = false;
  }
  if (end >= time_) return;
  const double next = next_step_;
  const auto advance_by = [&](double step) {
    next_step_ = step;
    time_ = previous_time_;
    advance();
  };
  advance_by(end - previous_time_);
  if (time_ < end - least * (end - previous_time_)) friction_change_.reset();  // it took a shorter step
  if (friction_change_ && !friction_change_->slips) {
    // Where the dense output of the whole step has a rate of zero the step itself has what sets both apart: the secant
    // method from there, two or three steps.
    constexpr int most = 5;
    constexpr double zero = 1e-12;  // of the step
    const int rate = model_.joints() + friction_change_->joint;
    const auto rate_left = [&] { return packed()[static_cast<std::size_t>(rate)]; };
    double left = rate_left();
    double slope = slopes_[static_cast<std::size_t>(rate)] + drive_.fading_slope(rate, 1, time_);
    for (int i = 0; i < most; ++i) {
      const double late = left / slope;
      if (!(std::abs(late) > zero * whole && std::abs(late) < least * whole && late < time_ - previous_time_)) break;
      const double before = time_;
      advance_by(time_ - previous_time_ - late);
      slope = (rate_left() - left) / (time_ - before);
      left = rate_left();
    }
  }
  if (friction_change_) next_step_ = std::max(next_step_, next);
}

// The first in the last step and before `end`. While joints are held nothing keeps a step short, and an input may come
// and go in it: it is looked for from each row of the input's curve to the next.
std::optional<HeldJoints::Change> Stepper::first_friction_change(double end) const {
  if (!model_.holds_joints()) return std::nullopt;
  std::vector<double> times;
  if (curve_) {
    const std::span<const double> rows = curve_->times();
    for (auto row = std::ranges::upper_bound(rows, previous_time_); row != rows.end() && *row < end; ++row)
      times.push_back(*row);
  }
  times.push_back(end);
  return held_joints_.first_change(
      previous_time_, times, [this](double time) { return time < time_ ? inside(time) : packed(); },
      [this](double time) { return derivative_at(time); });
}

void Stepper::change_friction(const PackedState& whole, int slipping) {
  friction_change_.reset();
  if (!model_.holds_joints()) return;
  held_joints_.decide(whole, slipping, derivative_at(time_));
  held_joints_.set(held_joints_.signs(), values_);
}

PackedState Stepper::with_held_joints(PackedState whole, double time) const {
  if (held_joints_.held().empty()) return whole;
  held_joints_.set(held_joints_.shares(whole, derivative_at(time)), whole);
  held_joints_.stop(whole);
  return whole;
}

double Stepper::first_contact() const {
  double first = time_;
  const PackedState before = drive_.whole(previous_values_, previous_time_);
  const PackedState after = drive_.whole(values_, time_);
  for (int j = 0; j < model_.joints(); ++j) {
    const double closing = model_.hinges()[j].contact.closing_angle;
    const bool pressed = before[j] < closing;
    if (pressed == (after[j] < closing)) continue;
    const double sign = pressed ? 1.0 : -1.0;
    first = crossing(previous_time_, first, [&](double time) { return sign * (inside(time)[j] - closing); });
  }
  return first;
}

void Stepper::advance() {
  const auto system = [this](const PackedState& values, PackedState& slopes, double time) {
    derive(values, slopes, time);
  };
  if (is_given_) {
    // Of what a step may have: that of a motion nearby had 1 at most. Where this one meets what that one met at another
    // time, a stop, its errors decide.
    constexpr double most = 10.0;
    PackedState errors(values_.size());
    controlled_.stepper().do_step(system, previous_values_, previous_slopes_, time_, values_, slopes_, next_step_,
                                  errors);
    ExplicitPair::algebra_type algebra;
    if (error_checker_.error(algebra, previous_values_, previous_slopes_, errors, next_step_) <= most) {
      time_ += next_step_;
      return;
    }
    is_given_ = false;
  }
  while (controlled_.try_step(system, previous_values_, previous_slopes_, time_, values_, slopes_, next_step_) ==
         odeint::fail) {
  }
}

State Stepper::at(double time) const {
  if (last_was_stiff_) {
    const int n = model_.joints();
    const MotionVector values = stiff_.at((time - previous_time_) / (time_ - previous_time_));
    return {.angles = values.head(n), .rates = values.tail(n), .internal = {}};
  }
  return unpack(with_held_joints(inside(time), time));
}

PackedState Stepper::inside(double time) const {
  PackedState values(values_.size());
  controlled_.stepper().calc_state(time, values, previous_values_, previous_slopes_, previous_time_, values_, slopes_,
                                   time_);
  return drive_.whole(std::move(values), time);
}

Stepper::Bending Stepper::bending() const {
  const int n = model_.joints();
  const auto sum = [n](const PackedState& values, int first) {
    return std::accumulate(values.begin() + first, values.begin() + first + n, 0.0);
  };
  const PackedState values = packed();
  return {.time = time_,
          .angle = sum(values, 0),
          .speed = sum(values, n),
          .acceleration = sum(slopes_, n) + drive_.fading_slope(n, n, time_)};
}

State Stepper::unpack(const PackedState& values) const {
  const int n = model_.joints();
  return {.angles = Eigen::Map<const Eigen::VectorXd>(values.data(), n),
          .rates = Eigen::Map<const Eigen::VectorXd>(values.data() + n, n),
          .internal = Eigen::Map<const Eigen::VectorXd>(values.data() + 2 * n, model_.internal_states())};
}

}  // namespace coilwright::simulation
