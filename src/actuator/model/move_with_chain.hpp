#pragma once

#include <span>

#include "coilwright/actuator/model/effect.hpp"

namespace coilwright::actuator {

/// Holds joints of a chain at rest: `accelerations` (n), rad/s^2, come as the chain would have them by itself and leave
/// as it has them with what holds these joints; `mass` (n, n) leaves as that of a chain whose joints nothing moves
/// there.
void hold_at_rest(std::span<const int> joints, mechanics::JointMatrix& mass, mechanics::JointVector& accelerations);

/// Lets the bodies of effects move with a chain whose mass matrix is `mass` (n, n). `accelerations` (n), rad/s^2, come
/// as the chain would have them by itself and leave as it has them with the bodies; those of the bodies' coordinates go
/// to `moved`, m/s^2 or rad/s^2, one for each body, at most max_bodies.
void move_with_chain(mechanics::JointMatrix mass, std::span<const EffectTerm::Body> bodies,
                     mechanics::JointVector& accelerations, std::span<double> moved);

}  // namespace coilwright::actuator
