#pragma once

#include <type_traits>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"

namespace coilwright::systems::rig {

/// What a rig would read if the torque of a coil and its magnet were found in either way.
template <class Value>
struct PerFidelity {
  Value line_of_centres{};  ///< by the paper's (20)-(22), (21) corrected
  Value exact{};            ///< by the whole force and torque of the tilted, displaced pair

  /// The one that was found in that way.
  [[nodiscard]] const Value& of(magnetics::Fidelity fidelity) const {
    return fidelity == magnetics::Fidelity::exact ? exact : line_of_centres;
  }
};

/// `value` of each fidelity, a callable of magnetics::Fidelity.
template <class Callable>
[[nodiscard]] auto per_fidelity(const Callable& value)
    -> PerFidelity<std::invoke_result_t<const Callable&, magnetics::Fidelity>> {
  return {.line_of_centres = value(magnetics::Fidelity::line_of_centres), .exact = value(magnetics::Fidelity::exact)};
}

/// The design with its torque found by `fidelity`. In another one than its own it goes without effects that it cannot
/// have there: an exact design has no `off_axis_force` that it lacks. Precondition: it can be built.
[[nodiscard]] actuator::Design with_fidelity(actuator::Design design, magnetics::Fidelity fidelity);

}  // namespace coilwright::systems::rig
