#pragma once

#include <Eigen/Cholesky>
#include <utility>
#include <vector>

#include "coilwright/mechanics/cholesky_solve.hpp"
#include "coilwright/mechanics/contact_impulses.hpp"

namespace coilwright::mechanics {

/// Gap below which a contact counts as closed, m. Without it the rounding of its height would lift a resting body for a
/// step at a time; no gap of interest is as small.
inline constexpr double closed_gap = 1e-9;

/// Largest way of a landing body in the step in which it lands, m. Moreau's rule stops a body where it finds it at the
/// middle of a step, up to half of its way behind the other's face, and leaves it there: fingertips that come at 0.7
/// m/s end 70 um behind at steps of 0.2 ms, which is 2 % of the force of the grip.
inline constexpr double landing_way = 1e-5;

/// Whether something that is `gap`, m, away from a face in the middle of a step of `step`, s, and comes nearer at
/// `approach`, m/s, reaches the face in this step and moves by more than `most`, m, in it.
[[nodiscard]] inline bool lands_too_fast(double gap, double approach, double step, double most = landing_way) {
  const double way = approach * step;
  return way > most && gap < 0.5 * way;
}

/// A system at the middle of a step.
struct MiddleOfStep {
  /// M, (n, n); with stiff springs of stiffness K and dampers B taken implicitly: M + step B / 2 + step^2 K / 4.
  CoordinateMatrix mass;
  CoordinateVector force;         ///< all forces but those of contact, at the velocities of the step's start
  std::vector<Contact> contacts;  ///< contacts whose gap is at most closed_gap here
  bool lands{};                   ///< whether something lands in the step for which lands_too_fast() is true
};

/// The end of a step, and its contacts.
struct MoreauStep {
  CoordinateVector position;
  CoordinateVector velocity;
  CoordinateVector middle_velocity;      ///< mean of both ends, by which forces and impulses do their work
  std::vector<Contact> contacts;         ///< contacts that were closed
  std::vector<ContactImpulse> impulses;  ///< impulses of these contacts, in their order
};

/// The end of a step of `step`, s, that began with `velocity`, from the system at its middle, `middle`.
[[nodiscard]] inline MoreauStep end_of_step(const CoordinateVector& middle, const CoordinateVector& velocity,
                                            double step, MiddleOfStep system) {
  const Eigen::LLT<CoordinateMatrix> mass(system.mass);
  solve_lower(mass.matrixLLT(), system.force);
  solve_upper(mass.matrixLLT(), system.force);
  const CoordinateVector free = velocity + step * system.force;
  ContactStep after = contact_impulses(mass, free, system.contacts);
  return {.position = middle + 0.5 * step * after.velocities,
          .velocity = after.velocities,
          .middle_velocity = 0.5 * (velocity + after.velocities),
          .contacts = std::move(system.contacts),
          .impulses = std::move(after.impulses)};
}

/// Takes one step of Moreau's midpoint rule: positions to the middle, velocities by forces and contact impulses there,
/// positions to the end. `at_middle(position, velocity)` gives MiddleOfStep. First order in `step`, s, where contacts
/// change. Source: Moreau as contact_impulses(); Jean, Comput. Methods Appl. Mech. Eng. 177 (1999) 235.
template <class AtMiddle>
[[nodiscard]] MoreauStep moreau_step(const CoordinateVector& position, const CoordinateVector& velocity, double step,
                                     AtMiddle&& at_middle) {
  const CoordinateVector middle = position + 0.5 * step * velocity;
  return end_of_step(middle, velocity, step, std::forward<AtMiddle>(at_middle)(middle, velocity));
}

/// Takes a step of `step`, s, and halves it until nothing lands too fast in any part. It moves `position` and
/// `velocity`, and passes each part to `take(MoreauStep, its duration)`. `at_middle(position, velocity, duration)`
/// gives MiddleOfStep.
template <class AtMiddle, class Take>
void advance_to_landings(CoordinateVector& position, CoordinateVector& velocity, double step, const AtMiddle& at_middle,
                         const Take& take) {
  const CoordinateVector middle = position + 0.5 * step * velocity;
  MiddleOfStep system = at_middle(middle, velocity, step);
  if (system.lands) {
    for (int half = 0; half < 2; ++half) advance_to_landings(position, velocity, 0.5 * step, at_middle, take);
    return;
  }
  const MoreauStep next = end_of_step(middle, velocity, step, std::move(system));
  position = next.position;
  velocity = next.velocity;
  take(next, step);
}

}  // namespace coilwright::mechanics
