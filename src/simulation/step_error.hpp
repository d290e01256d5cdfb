#pragma once

#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cstddef>

#include "packed_state.hpp"

namespace coilwright::simulation {

/// Dormand and Prince's 5(4) pair.
using ExplicitPair = boost::numeric::odeint::runge_kutta_dopri5<PackedState>;

/// Allowed error of one step in every state x: absolute + relative (|x| + h |dx/dt|).
struct StepTolerance {
  double relative{};  ///< dimensionless
  double absolute{};  ///< rad for angles, rad/s for rates
  double internal{};  ///< the same for an effect's state, in its SI unit
};

/// Odeint's own check of a step's errors, but with a floor of their own for the effects' states.
class StepErrorChecker {
 public:
  using algebra_type = ExplicitPair::algebra_type;
  using operations_type = ExplicitPair::operations_type;

  StepErrorChecker(const StepTolerance& tolerance, int joints)
      : tolerance_(tolerance), internal_begin_(2 * static_cast<std::size_t>(joints)) {}

  /// The largest error over what it may be.
  [[nodiscard]] double error(algebra_type& algebra, const PackedState& values, const PackedState& slopes,
                             const PackedState& errors, double step) const;
  /// Allowed error of the state at that place, whose size (|x| + h |dx/dt|) that is.
  [[nodiscard]] double allowed(std::size_t place, double size) const {
    return (place < internal_begin_ ? tolerance_.absolute : tolerance_.internal) + tolerance_.relative * size;
  }

 private:
  StepTolerance tolerance_;
  std::size_t internal_begin_;
};

}  // namespace coilwright::simulation
