#include <cmath>
#include <utility>

#include "actuator/effects/bristles.hpp"
#include "actuator/effects/joint_drive.hpp"
#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

using mechanics::JointVector;

// The bristles of dry_friction, one state y a joint, whose torque tau_c = mu |q_drive| follows the drive:
//   y' = (w - |w| y) / (tau_c / s0 + |w| / r),   F = tau_c y + s1 (w - |w| y) / (1 + s1 |w| / tau_c).
// y stays in [-1, 1] however the drive changes. Where a drive changes under bent bristles their energy
// tau_c^2 y^2 / (2 s0) changes with it: 1e-8 J of a finger's, below what any record shows.
class LoadFrictionTerm final : public EffectTerm {
 public:
  LoadFrictionTerm(JointVector stiffness, MagneticStage drives, double coefficient)
      : stiffness_(std::move(stiffness)),
        damping_(2.0 * presliding_damping / presliding_frequency * stiffness_),
        drives_(std::move(drives)),
        coefficient_(coefficient) {}

  int states() const override { return static_cast<int>(stiffness_.size()); }

  void add_torques(const Kinematics& motion, const CoilCurrents& strength, InternalStateView own,
                   JointVector& torques) const override {
    JointVector drive = motion.applied != nullptr ? *motion.applied : JointVector::Zero(states());
    drives_.add_torques(motion.chain, motion.angles, strength, drive);
    for (int j = 0; j < states(); ++j) {
      const double rate = motion.rates[j];
      const double speed = std::abs(rate);
      const double sliding = coefficient_ * std::abs(drive[j]);
      const double slip = rate - speed * own.states[j];
      if (sliding > 0.0) torques[j] -= sliding * (own.states[j] + damping_[j] * slip / (sliding + damping_[j] * speed));
      if (own.slopes != nullptr) {
        const double turning = sliding + stiffness_[j] * speed / turnover_rate;
        own.slopes[j] = turning > 0.0 ? stiffness_[j] * slip / turning : 0.0;
      }
    }
  }

 private:
  JointVector stiffness_;  // s0, N m/rad
  JointVector damping_;    // s1, N m s/rad
  MagneticStage drives_;
  double coefficient_;  // mu; > 0
};

class LoadFriction final : public DescribedEffect {
 public:
  LoadFriction()
      : DescribedEffect(
            {.id = "load_friction",
             .stage = Stage::hinge,
             .description = "friction of gears and bearings that grows with the torque they pass on",
             .equation = "q -= mu |q_drive| sgn(omega), every joint, q_drive the torque of its motor; sticks up to "
                         "mu |q_drive|, on bristles of 1500 rad/s",
             .source = "load-dependent part of the friction of a robot's joint: Bittencourt and Gunnarsson, J. Dyn. "
                       "Syst. Meas. Control 134 (2012) 051013, linear in the magnitude of the joint's torque",
             .check = "move a load slowly up and down through one pose and read the motor's torque: half of their "
                      "difference grows with the load",
             .parameters = {{.key = "coefficient",
                             .text = "friction over the magnitude of the drive's torque, every joint",
                             .lower = 0.0,
                             .upper = 1.0,
                             .absent = 0.0}}}) {}

  std::optional<std::string> inapplicable(const ModelSpec& spec) const override { return without_shafts(spec); }

  std::vector<std::vector<double>> starts(const RigScale& /*scale*/) const override { return one_by_one({0.03, 0.2}); }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    if (values[0] == 0.0) return nullptr;
    JointVector stiffness = presliding_frequency * presliding_frequency * spec.chain.joint_mobility().cwiseInverse();
    return std::make_unique<LoadFrictionTerm>(std::move(stiffness), spec.magnetics, values[0]);
  }
};

}  // namespace

const EffectKind& load_friction() {
  static const LoadFriction kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
