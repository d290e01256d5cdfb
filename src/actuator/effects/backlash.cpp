#include <algorithm>
#include <cmath>

#include "actuator/effects/effect_rows.hpp"

namespace coilwright::actuator::effects {
namespace {

using mechanics::JointVector;

// Share of a joint's inertia (one over its mobility, over the number of joints: so the rest of the mass matrix stays
// positive at every pose) that is the magnet's, and flies through the gap.
constexpr double inertia_share = 0.3;

// On its seat the magnet swings at this angular frequency, rad/s, with this damping ratio: silicone gives way and takes
// up the blow. No camera sees that it is not infinite.
constexpr double seat_frequency = 1500.0;
constexpr double seat_damping = 0.5;

// A gap of this size, rad, sets half of the magnet free. It makes the effect fade with its gap; a hundredth of a degree
// is 5 um at 30 mm.
constexpr double firm_gap = 0.01 / degrees;

// The damping sets in over this share of the gap, so that the seat's torque has no jump.
constexpr double soft_share = 0.1;

// One body a joint: the magnet's angle from the middle of its seat, x. Its torque pushes it across the gap and reaches
// the joint through the seat only, so M theta'' + J x'' = q with the whole magnetic torque in q, and
// J (theta'' + x'') = q_magnet - seat(x, x'). Both hold for the share w of magnet and torque that is free.
class BacklashTerm final : public EffectTerm {
 public:
  BacklashTerm(MagneticStage magnetics, JointVector inertia, double gap)
      : magnetics_(std::move(magnetics)), inertia_(std::move(inertia)), gap_(gap) {}

  int states() const override { return 2 * bodies(); }
  int bodies() const override { return static_cast<int>(inertia_.size()); }

  // In the middle without a torque; else pressed into its seat.
  void settle(const Kinematics& motion, const CoilCurrents& strength, double* out) const override {
    const JointVector pushed = torques(motion, strength);
    for (int j = 0; j < bodies(); ++j) {
      const double pressed = pushed[j] / (inertia_[j] * seat_frequency * seat_frequency);
      out[j] = pressed == 0.0 ? 0.0 : std::copysign(0.5 * gap_, pressed) + pressed;
      out[bodies() + j] = 0.0;
    }
  }

  void describe_bodies(const Kinematics& motion, const CoilCurrents& strength, const double* states,
                       Body* out) const override {
    const JointVector pushed = torques(motion, strength);
    const double free = gap_ / (gap_ + firm_gap);
    for (int j = 0; j < bodies(); ++j) {
      out[j].mass = free * inertia_[j];
      out[j].coupling[j] = out[j].mass;
      out[j].force = free * (pushed[j] - inertia_[j] * seat(states[j], states[bodies() + j]));
    }
  }

 private:
  JointVector torques(const Kinematics& motion, const CoilCurrents& strength) const {
    JointVector out = JointVector::Zero(motion.angles.size());
    magnetics_.add_torques(motion.chain, motion.angles, strength, out);
    return out;
  }

  // Over the magnet's inertia, rad/s^2: against x; it never pulls the magnet to itself.
  [[nodiscard]] double seat(double angle, double rate) const {
    const double depth = std::abs(angle) - 0.5 * gap_;
    if (depth <= 0.0) return 0.0;
    const double inwards = std::copysign(rate, angle * rate);
    const double damping = 2.0 * seat_damping * seat_frequency * depth / (depth + soft_share * gap_);
    return std::copysign(std::max(0.0, seat_frequency * seat_frequency * depth + damping * inwards), angle);
  }

  MagneticStage magnetics_;
  JointVector inertia_;  // J, kg m^2
  double gap_;
};

}  // namespace

// Last among the magnetics: it carries the torque of what the others have made of them.
EffectProperties backlash() {
  return {
      .id = "backlash",
      .stage = Stage::magnetics,
      .description = "a magnet is loose: it crosses a gap before its torque reaches the joint",
      .equation =
          "J (theta'' + x'') = q_magnet - seat(x), which is 0 where |x| < gap/2; the joint gets seat(x); J = 0.3/(n "
          "mobility), seat 1500 rad/s, damping ratio 0.5",
      .source =
          "two inertias and a dead zone: Nordin and Gutman, Automatica 38 (2002) 1633; inertia and seat are choices",
      .check =
          "hold the joint and push the magnet to and fro by hand: it must neither click nor move in its seat; measure "
          "how far it moves: the gap found here rests on an assumed inertia and bounce",
      .parameters = {from_zero("gap_deg", "from one side of its seat to the other, as an angle of the joint",
                               10.0 / degrees)},
      .starts =
          shares_of([](const RigScale& scale) { return std::clamp(0.02 * scale.angle, 0.05 / degrees, 1.0 / degrees); },
                    {1.0, 5.0, 20.0}),
      .build = [](Values values, ModelSpec& spec) -> Term {
        JointVector inertia = inertia_share / spec.chain.joints() * spec.chain.joint_mobility().cwiseInverse();
        return std::make_unique<BacklashTerm>(spec.magnetics, std::move(inertia), values[0]);
      }};
}

}  // namespace coilwright::actuator::effects
