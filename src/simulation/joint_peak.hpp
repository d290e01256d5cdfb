#pragma once

#include "coilwright/simulation/state.hpp"
#include "stepper.hpp"

namespace coilwright::simulation {

/// The largest angle that any joint takes over one motion, turning points between the integrator's steps included.
class JointPeak {
 public:
  explicit JointPeak(const State& start);
  /// After every step of the motion; `now` is stepper.now().
  void add(const Stepper& stepper, const State& now);
  [[nodiscard]] double angle() const { return angle_; }  ///< largest magnitude so far, rad

 private:
  State before_;
  double angle_;
};

}  // namespace coilwright::simulation
