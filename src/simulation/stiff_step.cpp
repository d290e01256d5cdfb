#include "stiff_step.hpp"

#include <algorithm>
#include <cmath>

#include "crossing.hpp"

namespace coilwright::simulation {
namespace {

// Of a step, over the time in which pressed faces ring by a radian: shorter steps are left to the explicit pair, which
// is stable up to about 2.5. Between 0.05 and 1 the time for sixty random designs does not change by more than 7 %.
constexpr double shortest = 0.5;

}  // namespace

StiffStep::StiffStep(const actuator::Model& model, const StepTolerance& tolerance)
    : model_(model), tolerance_(tolerance), squared_frequencies_(model.chain().joint_mobility()) {
  for (int j = 0; j < model.joints(); ++j) squared_frequencies_[j] *= model.hinges()[j].contact.stiffness;
}

// An upper bound of the frequency at which the joints ring whose faces push, rad/s: the trace of M^-1 K of the stops.
double StiffStep::ringing(const PackedState& start) const {
  const int n = model_.joints();
  double sum = 0.0;
  for (int j = 0; j < n; ++j)
    if (model_.hinges()[j].contact.torque(start[j], start[n + j]) > 0.0) sum += squared_frequencies_[j];
  return std::sqrt(sum);
}

// Of the step just tried, over what is allowed. A pressed joint hardly moves: its errors count as much as they do in
// the motion of the whole, whose largest angle and rate set the scale.
double StiffStep::error(const MotionVector& slopes, double duration) const {
  const int n = model_.joints();
  const auto part = [&](int first) {
    const double size = step_.end().segment(first, n).lpNorm<Eigen::Infinity>() +
                        duration * slopes.segment(first, n).lpNorm<Eigen::Infinity>();
    return step_.error().segment(first, n).lpNorm<Eigen::Infinity>() /
           (tolerance_.absolute + tolerance_.relative * size);
  };
  return std::max(part(0), part(n));
}

// Share of the step just tried at which a joint's faces have begun or ceased to push, if they ever do: its end, or a
// place inside where they are likeliest to touch or to lose touch for a moment.
std::optional<double> StiffStep::changed_share(const FrozenContact& contact, int joint, const MotionVector& start,
                                               double duration) const {
  if (contact.changed(joint, step_.end())) return 1.0;
  double inside = 0.5;
  if (!contact.pushing(joint)) {
    const int n = model_.joints();
    const double angle = std::min(start[joint], step_.end()[joint]);
    const double before = start[n + joint];
    const double after = step_.end()[n + joint];
    // An angle that falls and rises again lies above the tangents at both ends, give or take what bends them.
    const double closing = model_.hinges()[joint].contact.closing_angle;
    if (before >= 0.0 || after <= 0.0 || angle + duration * std::max(before, -after) > closing) return std::nullopt;
    inside = bisected(0.0, 1.0, [&](double share) { return step_.at(share)[n + joint] > 0.0; });
  }
  if (contact.changed(joint, step_.at(inside))) return inside;
  return std::nullopt;
}

// Share of the step at which the first of the joints' faces begin or cease to push; 1 if none do.
double StiffStep::first_change(const FrozenContact& contact, const MotionVector& start, double duration) const {
  double first = 1.0;
  for (int j = 0; j < model_.joints(); ++j) {
    const std::optional<double> share = changed_share(contact, j, start, duration);
    if (!share) continue;
    const double here = bisected(0.0, *share, [&](double at) { return contact.changed(j, step_.at(at)); });
    first = std::min(first, here);
  }
  return first;
}

StiffStep::Taken StiffStep::take(const PackedState& start_values, const PackedState& start_slopes,
                                 const actuator::CoilCurrents& currents, const mechanics::JointVector& applied,
                                 double duration, bool is_given) {
  Taken out{.next = duration};
  const double frequency = ringing(start_values);
  if (frequency == 0.0) return out;
  const Eigen::Index size = 2 * model_.joints();
  const MotionVector start = Eigen::Map<const Eigen::VectorXd>(start_values.data(), size);
  const MotionVector derived = Eigen::Map<const Eigen::VectorXd>(start_slopes.data(), size);
  const FrozenContact contact(model_, currents, applied, start);
  const mechanics::ChainSlopes slopes = contact.slopes(start, derived);
  const auto take_whole = [&] {
    step_.take(start, derived, slopes, duration, [&](const MotionVector& at) { return contact.derive(at); });
  };
  for (bool accepted = false; !accepted;) {
    if (!(duration * frequency > shortest)) return out;
    take_whole();
    const double error = this->error(derived, duration);
    accepted = is_given || error <= 1.0;
    const double change = 0.9 * std::pow(error, -1.0 / RosenbrockStep::method.order);
    out.next = duration * (std::isfinite(error) ? std::clamp(change, 0.2, 5.0) : 0.2);
    if (!accepted) duration = out.next;
  }
  const double share = first_change(contact, start, duration);
  if (share < 1.0) {
    // What has changed rings at first: the explicit pair takes the next step.
    out.contact_changed = true;
    out.next = std::min(out.next, 1.0 / std::sqrt(squared_frequencies_.sum()));
    if (share < 1e-3) return out;
    duration *= share;
    take_whole();
  }
  out.duration = duration;
  return out;
}

}  // namespace coilwright::simulation
