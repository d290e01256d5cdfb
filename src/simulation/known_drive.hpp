#pragma once

#include <Eigen/Core>
#include <optional>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/algebra/lagged_curve.hpp"
#include "coilwright/algebra/smooth_curve.hpp"
#include "packed_state.hpp"

namespace coilwright::simulation {

/// What is known in closed form of the states of a drive, and of what they leave in the motion, so that an integrator
/// need not follow it: `values` and `slopes` are what is left to integrate, with the drive's states among them.
class KnownDrive {
 public:
  explicit KnownDrive(const actuator::Model& model);

  /// From `time` on under a held input, at whose end the drive's states are `end`. A lag is known in closed form while
  /// the input is held, and leaves the motion a transient of its own: a part p = a exp(-t / T) of the whole state x
  /// that hardly anything else is seen in. What is integrated is z = x - p, z' = f(z + p) - p', which is exact whatever
  /// a is. That of the lag's states, x less where they end, makes z constant there. The rest of a is chosen such that z
  /// sets out like a motion that has no transient, with the slopes of the place x - a: by iteration of
  /// a = T (f(x - a) - f(x)), which converges where T is short against all else; `derive` is at the time of the start.
  void hold(double time, Eigen::VectorXd end, PackedState& values, PackedState& slopes, const PackedDerivative& derive);
  /// Along an input that follows a curve; a lag's states tend to `ends` (algebra::LaggedCurve).
  void follow(algebra::SmoothCurve ends, const PackedState& values, PackedState& slopes);
  /// Whether follow() saves steps: a slower lag is as smooth as the motion.
  [[nodiscard]] bool knows_along_curves() const;
  /// Begins anew, with nothing known.
  void forget();

  [[nodiscard]] bool knows_something() const { return !fading_.empty() || lagged_; }
  /// Integrated values with what is known.
  [[nodiscard]] PackedState whole(PackedState values, double time) const;
  /// Of slopes of the whole, those of what is integrated.
  void leave_what_is_integrated(PackedState& slopes, double time) const;
  /// The sum of slopes that what fades adds to `count` values from `first` on.
  [[nodiscard]] double fading_slope(int first, int count, double time) const;

  /// Sets states that have come to exactly where they end: they limit no step any more. Whether it did.
  [[nodiscard]] bool come_to_rest(PackedState& values);
  /// The longest step, s, at most `next`: states that are integrated tend to constants while the input is held, and an
  /// explicit method that takes a lag of microseconds at the edge of its stability never gets there: it keeps an error
  /// about its tolerance, and steps of the lag's own length for good. Until they have arrived no step is longer than
  /// the time in which the last of them would at its present speed. The last, not the first: a lag that follows a
  /// warming coil passes its own end on the way, at full speed.
  [[nodiscard]] double longest_step(const PackedState& values, const PackedState& slopes, double next) const;
  /// Forgets what has faded to nothing.
  void forget_what_is_gone(double time);

 private:
  [[nodiscard]] double fading_share(double time) const;
  void add_fading(PackedState& values, double share) const;

  std::size_t first_;   // of the drive's states
  std::size_t states_;  // of the drive
  double lag_;          // of the drive (Model::drive_lag), s
  double start_time_ = 0.0;
  // Where the drive's states end under the held input; empty once they are there, and for a model without any.
  Eigen::VectorXd end_;
  PackedState fading_;                          // what of the state fades with the lag, at the start; empty: nothing
  std::optional<algebra::LaggedCurve> lagged_;  // the drive's states along a curve
};

}  // namespace coilwright::simulation
