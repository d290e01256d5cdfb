#include <cmath>
#include <limits>
#include <utility>

#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

using mechanics::JointVector;

// A joint that sticks swings on its bristles at this angular frequency, rad/s, with this damping ratio: it springs back
// by 0.04 mrad in a finger with 0.6 N mm, and no rig asks for steps shorter than 2 ms by sticking. At 300 rad/s joints
// came to rest up to half a degree beside where Coulomb's law holds them.
constexpr double presliding_frequency = 1500.0;
constexpr double presliding_damping = 0.7;

// Fastest turning over of a bristle, 1/s. Without a floor, weak friction on a fast joint turns over within microseconds
// and the integrator has to follow; half a millisecond is below a sample.
constexpr double turnover_rate = 2e3;

// One state a joint: the bristle's deflection over its largest, y = s0 z / tau_c, in [-1, 1].
//
// With delta = tau_c / s0: y' = (w - |w| y) / (delta + |w| / r), F = tau_c y + s1 (w - |w| y) / (1 + s1 |w| / tau_c).
// Passive whatever the motion: F w - d/dt(tau_c delta y^2 / 2) >= 0 where s1 >= s0 / (2 r), and here s1 / s0 =
// 2 zeta / 1500 s = 3.7 times that. The plain LuGre law (r infinite, s1 not tapered) is so only up to |w| = 4 tau_c /
// s1.
class FrictionTerm final : public EffectTerm {
 public:
  FrictionTerm(JointVector stiffness, double torque)
      : stiffness_(std::move(stiffness)),
        damping_(2.0 * presliding_damping / presliding_frequency * stiffness_),
        torque_(torque) {}

  int states() const override { return static_cast<int>(stiffness_.size()); }

  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView own,
                   JointVector& torques) const override {
    for (int j = 0; j < states(); ++j) {
      const double rate = motion.rates[j];
      const double speed = std::abs(rate);
      const double slip = rate - speed * own.states[j];
      torques[j] -= torque_ * (own.states[j] + damping_[j] * slip / (torque_ + damping_[j] * speed));
      if (own.slopes != nullptr)
        own.slopes[j] = stiffness_[j] * slip / (torque_ + stiffness_[j] * speed / turnover_rate);
    }
  }

 private:
  JointVector stiffness_;  // s0, N m/rad
  JointVector damping_;    // s1, N m s/rad
  double torque_;          // tau_c, N m; > 0
};

class DryFriction final : public DescribedEffect {
 public:
  DryFriction()
      : DescribedEffect(
            {.id = "dry_friction",
             .stage = Stage::hinge,
             .description = "Coulomb friction at the hinges or segment faces",
             .equation = "q -= tau_c sgn(omega), every joint; sticks up to tau_c, on bristles of 1500 rad/s",
             .source = "LuGre without Stribeck: Canudas de Wit et al., IEEE Trans. Autom. Control 40 (1995) "
                       "419; Astrom and Canudas de Wit, IEEE Control Syst. Mag. 28 (2008) 101",
             .parameters = {{.key = "torque_Nmm",
                             .text = "friction torque of a sliding joint, every joint",
                             .lower = 0.0,
                             .upper = std::numeric_limits<double>::infinity(),
                             .absent = 0.0}}}) {}

  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    return one_by_one({0.02 * scale.torque, 0.15 * scale.torque});
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    if (values[0] == 0.0) return nullptr;
    JointVector stiffness = presliding_frequency * presliding_frequency * spec.chain.joint_mobility().cwiseInverse();
    return std::make_unique<FrictionTerm>(std::move(stiffness), values[0]);
  }
};

}  // namespace

const EffectKind& dry_friction() {
  static const DryFriction kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
