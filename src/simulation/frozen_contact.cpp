#include "frozen_contact.hpp"

namespace coilwright::simulation {

using mechanics::JointVector;

FrozenContact::FrozenContact(const actuator::Model& model, const actuator::CoilCurrents& currents,
                             const JointVector& applied, const MotionVector& start)
    : model_(model), currents_(currents), applied_(applied) {
  for (int j = 0; j < model.joints(); ++j) pushing_[j] = pushes(j, start);
}

// What the model's faces do is taken back as an applied torque, and what they are held to do is put in its place.
MotionVector FrozenContact::derive(const MotionVector& values) const {
  const int n = model_.joints();
  const JointVector angles = values.head(n);
  const JointVector rates = values.tail(n);
  JointVector applied = applied_;
  for (int j = 0; j < n; ++j) {
    const mechanics::FaceContact& contact = model_.hinges()[j].contact;
    applied[j] -= contact.torque(angles[j], rates[j]);
    if (pushing_[j]) applied[j] += contact.stiffness * (contact.closing_angle - angles[j]) - contact.damping * rates[j];
  }
  JointVector accelerations;
  model_.derivative(angles, rates, {}, currents_, applied, accelerations, {});
  MotionVector out(2 * n);
  out << rates, accelerations;
  return out;
}

mechanics::ChainSlopes FrozenContact::slopes(const MotionVector& values, const MotionVector& derived) const {
  const int n = model_.joints();
  mechanics::ChainSlopes out =
      model_.slopes_without_contact(values.head(n), values.tail(n), derived.tail(n), currents_);
  for (int j = 0; j < n; ++j) {
    if (!pushing_[j]) continue;
    out.by_angle(j, j) += model_.hinges()[j].contact.stiffness;
    out.by_rate(j, j) += model_.hinges()[j].contact.damping;
  }
  return out;
}

}  // namespace coilwright::simulation
