#include <algorithm>

#include "actuator/effects/effect_rows.hpp"

// What comes late: by a first-order lag, of a coil's current or of what a camera's tracking shows, or by a delay.
namespace coilwright::actuator::effects {
namespace {

// A shorter lag changes no sample of a camera or an encoder (at 10 kHz: a fifth of a sample), and would only ask the
// integrator for steps that small: it is taken as none.
constexpr double quasi_static = 20e-6;

// One state a coil: its current.
class CurrentLag final : public FollowingTerm {
 public:
  using FollowingTerm::FollowingTerm;

  void settle(const Kinematics& /*motion*/, const CoilCurrents& currents, double* out) const override {
    std::copy_n(currents.data(), states(), out);
  }

  double lag() const override { return time_constant(); }

  void drive(InternalStateView own, CoilCurrents& currents) const override {
    for (int c = 0; c < states(); ++c) {
      if (own.slopes != nullptr) own.slopes[c] = slope(currents[c], own.states[c]);
      currents[c] = own.states[c];
    }
  }
};

// One state a joint: its angle as shown. Linear, so the shown sum of angles is the sum of the shown angles.
class TrackingLag final : public FollowingTerm {
 public:
  using FollowingTerm::FollowingTerm;

  void settle(const Kinematics& motion, const CoilCurrents& /*currents*/, double* out) const override {
    std::copy_n(motion.angles.data(), states(), out);
  }

  void show(InternalStateView own, mechanics::JointVector& angles, mechanics::JointVector& rates) const override {
    for (int j = 0; j < states(); ++j) {
      rates[j] = slope(angles[j], own.states[j]);
      angles[j] = own.states[j];
      if (own.slopes != nullptr) own.slopes[j] = rates[j];
    }
  }
};

class DelayTerm final : public EffectTerm {
 public:
  explicit DelayTerm(double delay) : delay_(delay) {}
  double delay() const override { return delay_; }

 private:
  double delay_;
};

constexpr double longest_delay = 1.0;  // s; the slowest camera chains take a sixth of that
// A camera that stamps a picture when it has begun to expose it, or a bus that stamps it in advance.
constexpr double earliest = -0.05;  // s

}  // namespace

// Last in the drive's row: what the driver commands, limits and biases, the coil's inductance delays.
EffectProperties coil_lag() {
  return {.id = "coil_lag",
          .stage = Stage::drive,
          .description = "the current follows its command with a delay: L/R, or a current loop's bandwidth",
          .equation = "i' = (i_cmd - i)/T; none below T = 0.02 ms",
          .source = "L i' + R i = u, T = L/R",
          .check = "record the coil's current in one step with a shunt and an oscilloscope",
          .parameters = {from_zero("time_constant_ms", "of the current's answer to a step", 1.0)},
          .starts =
              [](const RigScale& scale) {
                // A lag shows where the motion is fast, however rarely a camera looks.
                const double fast = 0.05 * scale.angle / scale.rate;
                const double low = std::clamp(std::min(scale.interval, fast), 2.0 * quasi_static, 0.1);
                return one_by_one(log_spread(low, std::clamp(0.1 * scale.duration, 2.0 * low, 0.5), 3));
              },
          .build = [](Values values, ModelSpec& spec) -> Term {
            if (values[0] < quasi_static) return nullptr;
            return std::make_unique<CurrentLag>(spec.coils, values[0]);
          }};
}

EffectProperties tracking_lag() {
  return {.id = "tracking_lag",
          .stage = Stage::camera,
          .description = "the camera's tracking filters: what it shows follows the motion",
          .equation = "shown' = (theta - shown)/T, every angle",
          .source = "first-order low-pass filter; definition",
          .check = "move a target by hand and compare the tracked angle with the raw pictures",
          .parameters = {from_zero("time_constant_ms", "of the filter", 1.0)},
          .starts =
              [](const RigScale& scale) {
                const double low = std::clamp(scale.interval, 1e-3, 0.1);
                return one_by_one({low, std::min(4.0 * low, 0.5)});
              },
          .build = [](Values values, ModelSpec& spec) -> Term {
            if (values[0] < quasi_static) return nullptr;
            return std::make_unique<TrackingLag>(spec.chain.joints(), values[0]);
          }};
}

EffectProperties measurement_delay() {
  return {.id = "measurement_delay",
          .stage = Stage::camera,
          .description = "camera or bus show the motion late",
          .equation = "y(t) = theta(t - T)",
          .source = "definition",
          .check = "film a light that is switched on together with the current",
          .parameters = {{.key = "delay_ms",
                          .text = "between motion and record",
                          .lower = earliest,
                          .upper = longest_delay,
                          .absent = 0.0}},
          // Not convex where the motion rings: from a sample to several frames of a slow camera.
          .starts =
              [](const RigScale& scale) {
                const double low = std::min(scale.interval, 0.1 * longest_delay);
                const double high = std::clamp(0.1 * scale.duration, 2.0 * low, 0.1 * longest_delay);
                return one_by_one(log_spread(low, high, 4));
              },
          .build = [](Values values, ModelSpec& /*spec*/) -> Term { return std::make_unique<DelayTerm>(values[0]); }};
}

}  // namespace coilwright::actuator::effects
