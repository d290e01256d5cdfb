#include "stepper.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

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

// Of a step, over the time in which pressed faces ring by a radian: shorter steps are left to the explicit pair, which
// is stable up to about 2.5. Between 0.05 and 1 the time for sixty random designs does not change by more than 7 %.
constexpr double stiff_step = 0.5;

// Where `changed` first becomes true, to a billionth of the way from `before`, where it is not, to `after`, where it
// is.
template <typename Changed>
double bisected(double before, double after, const Changed& changed) {
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (before + after);
    (changed(middle) ? after : before) = middle;
  }
  return after;
}

// Where `excess` crosses zero: from `before`, where it is below, to `after`, where it is above; there or just behind.
template <typename Excess>
double crossing(double before, double after, const Excess& excess) {
  const double low = excess(before);
  const double high = excess(after);
  // A joint that has just been let go sets out from zero itself.
  if (!(low < 0.0 && high > 0.0)) return bisected(before, after, [&](double time) { return excess(time) > 0.0; });
  std::uintmax_t most = 60;
  constexpr int bits = 36;  // as fine as the step's own errors
  return boost::math::tools::toms748_solve(excess, before, after, low, high,
                                           boost::math::tools::eps_tolerance<double>(bits), most)
      .second;
}

}  // namespace

double Stepper::ErrorChecker::error(algebra_type& /*algebra*/, const PackedState& values, const PackedState& slopes,
                                    const PackedState& errors, double step) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double floor = i < internal_begin_ ? tolerance_.absolute : tolerance_.internal;
    const double allowed = floor + tolerance_.relative * (std::abs(values[i]) + std::abs(step) * std::abs(slopes[i]));
    // A step so long that the equation overflowed inside it says nothing: it is too long, unless it began like that.
    if (!std::isfinite(errors[i]) && std::isfinite(allowed)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, std::abs(errors[i]) / allowed);
  }
  return largest;
}

Stepper::Stepper(const actuator::Model& model, const Tolerance& tolerance)
    : model_(model),
      error_checker_(tolerance, model.joints()),
      controlled_(error_checker_),
      drive_(model),
      tolerance_(tolerance),
      squared_contact_frequencies_(model.chain().joint_mobility()),
      held_joints_(model) {
  for (int j = 0; j < model.joints(); ++j) squared_contact_frequencies_[j] *= model.hinges()[j].contact.stiffness;
}

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
    const actuator::InternalStates settled =
        model_.settled(mechanics::JointVector::Zero(model_.joints()), input_at(times[row]).currents);
    ends.insert(ends.end(), settled.data(), settled.data() + states);
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
    drive_.hold(time, model_.settled(state.angles, input_.currents).head(model_.drive_states()), values_, slopes_,
                [&](const PackedState& values, PackedState& slopes) { derive_whole(values, slopes, time); });
  if (curve_ && drive_.knows_along_curves()) drive_.follow(drive_ends(), values_, slopes_);
  previous_values_ = values_;
  previous_slopes_ = slopes_;
  // What was at rest has taken long steps, and its motion now is another one. Shorter ones find their way themselves.
  constexpr double long_step = 0.02;  // s; a finger in motion takes a third of that
  if (next_step_ > long_step) next_step_ = std::min(next_step_, first_step());
}

// A step over which the solution hardly bends: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I
// (1993), II.4, for order 5, by the norm of the largest. The estimated error of a much longer one means nothing: it may
// be accepted with joints degrees off.
double Stepper::first_step() const {
  const auto n = static_cast<std::size_t>(model_.joints());
  const auto largest = [&](const PackedState& of) {
    double out = 0.0;
    for (std::size_t i = 0; i < of.size(); ++i) {
      const double floor = i < 2 * n ? tolerance_.absolute : tolerance_.internal;
      out = std::max(out, std::abs(of[i]) / (floor + tolerance_.relative * std::abs(values_[i])));
    }
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
    const FrictionChange change = *friction_change_;
    PackedState whole = packed();
    if (!change.slips) {
      const auto rate = static_cast<std::size_t>(model_.joints() + change.joint);
      values_[rate] -= whole[rate];
      whole[rate] = 0.0;
    }
    change_friction(whole, change.slips ? change.joint : -1);
    derive(values_, slopes_, time_);
  }
  if (drive_.come_to_rest(values_)) derive(values_, slopes_, time_);
  if (!is_given_) next_step_ = drive_.longest_step(values_, slopes_, next_step_);
  drive_.forget_what_is_gone(time_);
  previous_values_ = values_;
  previous_slopes_ = slopes_;
  previous_time_ = time_;
  const double frequency = contact_changed_ || curve_ || model_.has_terms() ? 0.0 : contact_frequency();
  contact_changed_ = false;
  last_was_stiff_ = false;
  if (frequency == 0.0 || !step_stiffly(frequency)) step_explicitly();
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
    // Where the dense output of the whole step has a rate of zero the step itself has what sets both apart.
    const int rate = model_.joints() + friction_change_->joint;
    const double late = packed()[static_cast<std::size_t>(rate)] /
                        (slopes_[static_cast<std::size_t>(rate)] + drive_.fading_slope(rate, 1, time_));
    if (std::abs(late) < least * whole && late < time_ - previous_time_) advance_by(time_ - previous_time_ - late);
  }
  if (friction_change_) next_step_ = std::max(next_step_, next);
}

// The first inside the last step and before that time.
std::optional<Stepper::FrictionChange> Stepper::first_friction_change(double before) const {
  if (!model_.holds_joints()) return std::nullopt;
  const int n = model_.joints();
  // By how much the friction that holds a joint is too large, or how fast one slides against the sign of its friction.
  const auto excess = [&](const PackedState& there, double time, int joint) {
    if (held_joints_.holds(joint)) return std::abs(held_joints_.shares(there, derivative_at(time))[joint]) - 1.0;
    return -held_joints_.signs()[joint] * there[static_cast<std::size_t>(n + joint)];
  };
  const auto whole_at = [&](double time) { return time < time_ ? inside(time) : packed(); };
  std::optional<FrictionChange> first;
  PackedState last = whole_at(before);
  for (int j = 0; j < n; ++j) {
    if (!(excess(last, before, j) > 0.0)) continue;
    before = crossing(previous_time_, before, [&](double time) { return excess(inside(time), time, j); });
    last = whole_at(before);
    first = {.time = before, .joint = j, .slips = held_joints_.holds(j)};
  }
  return first;
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
  for (const int joint : held_joints_.held()) whole[static_cast<std::size_t>(model_.joints() + joint)] = 0.0;
  return whole;
}

// An upper bound of the frequency at which the joints ring whose faces push, rad/s: the trace of M^-1 K of the stops.
double Stepper::contact_frequency() const {
  const int n = model_.joints();
  double sum = 0.0;
  for (int j = 0; j < n; ++j)
    if (model_.hinges()[j].contact.torque(previous_values_[j], previous_values_[n + j]) > 0.0)
      sum += squared_contact_frequencies_[j];
  return std::sqrt(sum);
}

// Of the step just tried, over what is allowed. A pressed joint hardly moves: its errors count as much as they do in
// the motion of the whole, whose largest angle and rate set the scale.
double Stepper::stiff_error(double step) const {
  const int n = model_.joints();
  const MotionVector& end = rosenbrock_.end();
  const MotionVector& error = rosenbrock_.error();
  const Eigen::Map<const Eigen::VectorXd> slopes(previous_slopes_.data(), 2 * n);
  const auto part = [&](int first) {
    const double size =
        end.segment(first, n).lpNorm<Eigen::Infinity>() + step * slopes.segment(first, n).lpNorm<Eigen::Infinity>();
    return error.segment(first, n).lpNorm<Eigen::Infinity>() / (tolerance_.absolute + tolerance_.relative * size);
  };
  return std::max(part(0), part(n));
}

// Share of the step just tried at which a joint's faces have begun or ceased to push, if they ever do: its end, or a
// place inside where they are likeliest to touch or to lose touch for a moment.
std::optional<double> Stepper::changed_share(const FrozenContact& contact, int joint, double step) const {
  if (contact.changed(joint, rosenbrock_.end())) return 1.0;
  double inside = 0.5;
  if (!contact.pushing(joint)) {
    const int n = model_.joints();
    const double angle = std::min(previous_values_[joint], rosenbrock_.end()[joint]);
    const double before = previous_values_[n + joint];
    const double after = rosenbrock_.end()[n + joint];
    // An angle that falls and rises again lies above the tangents at both ends, give or take what bends them.
    const double closing = model_.hinges()[joint].contact.closing_angle;
    if (before >= 0.0 || after <= 0.0 || angle + step * std::max(before, -after) > closing) return std::nullopt;
    inside = bisected(0.0, 1.0, [&](double share) { return rosenbrock_.at(share)[n + joint] > 0.0; });
  }
  if (contact.changed(joint, rosenbrock_.at(inside))) return inside;
  return std::nullopt;
}

// Share of the step at which the first of the joints' faces begin or cease to push; 1 if none do.
double Stepper::first_change(const FrozenContact& contact, double step) const {
  double first = 1.0;
  for (int j = 0; j < model_.joints(); ++j) {
    const std::optional<double> share = changed_share(contact, j, step);
    if (!share) continue;
    const double here = bisected(0.0, *share, [&](double at) { return contact.changed(j, rosenbrock_.at(at)); });
    first = std::min(first, here);
  }
  return first;
}

// One step of the Rosenbrock method; it ends where the first faces begin or cease to push. False, with nothing done,
// where the motion asks for steps so short that the explicit pair may as well take them.
bool Stepper::step_stiffly(double frequency) {
  const Eigen::Index size = 2 * model_.joints();
  const MotionVector start = Eigen::Map<const Eigen::VectorXd>(previous_values_.data(), size);
  const MotionVector derived = Eigen::Map<const Eigen::VectorXd>(previous_slopes_.data(), size);
  const FrozenContact contact(model_, input_.currents, input_.applied, start);
  const mechanics::ChainSlopes slopes = contact.slopes(start, derived);
  const auto take = [&](double step) {
    rosenbrock_.take(start, derived, slopes, step, [&](const MotionVector& at) { return contact.derive(at); });
  };
  double step = next_step_;
  for (bool accepted = false; !accepted;) {
    if (!(step * frequency > stiff_step)) return false;
    take(step);
    const double error = stiff_error(step);
    accepted = is_given_ || error <= 1.0;
    const double change = 0.9 * std::pow(error, -1.0 / RosenbrockStep::method.order);
    next_step_ = step * (std::isfinite(error) ? std::clamp(change, 0.2, 5.0) : 0.2);
    if (!accepted) step = next_step_;
  }
  const double share = first_change(contact, step);
  if (share < 1.0) {
    // What has changed rings at first: the explicit pair takes the next step.
    contact_changed_ = true;
    next_step_ = std::min(next_step_, 1.0 / std::sqrt(squared_contact_frequencies_.sum()));
    if (share < 1e-3) return false;
    step *= share;
    take(step);
  }
  last_was_stiff_ = true;
  time_ = previous_time_ + step;
  values_.assign(rosenbrock_.end().data(), rosenbrock_.end().data() + size);
  slopes_.resize(values_.size());
  derive(values_, slopes_, time_);
  return true;
}

double Stepper::first_contact() const {
  double first = time_;
  const PackedState before = drive_.whole(previous_values_, previous_time_);
  const PackedState after = drive_.whole(values_, time_);
  for (int j = 0; j < model_.joints(); ++j) {
    const double closing = model_.hinges()[j].contact.closing_angle;
    const bool pressed = before[j] < closing;
    if (pressed == (after[j] < closing)) continue;
    first = bisected(previous_time_, first, [&](double time) { return (inside(time)[j] < closing) != pressed; });
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
    Pair::algebra_type algebra;
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
    const MotionVector values = rosenbrock_.at((time - previous_time_) / (time_ - previous_time_));
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
