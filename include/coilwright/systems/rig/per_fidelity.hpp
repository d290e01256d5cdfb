#pragma once

#include <type_traits>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"

namespace coilwright::systems::rig {

/// The values of a rig with the torque of a coil and its magnet computed in both ways.
template <class Value>
struct PerFidelity {
  Value line_of_centres{};  ///< by the paper's (20)-(22), (21) corrected
  Value exact{};            ///< by the whole force and torque of the tilted, displaced pair

  /// The value by that fidelity.
  [[nodiscard]] const Value& of(magnetics::Fidelity fidelity) const {
    return fidelity == magnetics::Fidelity::exact ? exact : line_of_centres;
  }
};

/// Calls `value` for each fidelity.
template <class Callable>
[[nodiscard]] auto per_fidelity(const Callable& value)
    -> PerFidelity<std::invoke_result_t<const Callable&, magnetics::Fidelity>> {
  return {.line_of_centres = value(magnetics::Fidelity::line_of_centres), .exact = value(magnetics::Fidelity::exact)};
}

/// The design with its torque computed by `fidelity`. With a fidelity other than its own it loses effects that it
/// cannot have there: an exact design cannot have `off_axis_force`. Precondition: it can be built.
[[nodiscard]] actuator::Design with_fidelity(actuator::Design design, magnetics::Fidelity fidelity);

}  // namespace coilwright::systems::rig
