#include <algorithm>
#include <cmath>

#include "actuator/effects/effect_rows.hpp"

// What brakes a joint that moves: friction on bristles, of its own and of its drive, and drag.
namespace coilwright::actuator::effects {
namespace {

using mechanics::JointVector;

// A joint that sticks swings on its bristles at this angular frequency, rad/s, with this damping ratio: it springs
// back by 0.04 mrad in a finger with 0.6 N mm, and no rig asks for steps shorter than 2 ms by sticking. At 300 rad/s
// joints came to rest up to half a degree beside where Coulomb's law holds them.
constexpr double presliding_frequency = 1500.0;
constexpr double presliding_damping = 0.7;

// Fastest turning over of a bristle, 1/s. Without a floor, weak friction on a fast joint turns over within
// microseconds and the integrator has to follow; half a millisecond is below a sample.
constexpr double turnover_rate = 2e3;

// How much more than sliding friction a joint at rest holds, and how fast that falls: a bristle breaks at
// gamma = 1 + (rho - 1) exp(-(w / w_s)^2) times the deflection of a sliding one.
struct StribeckFall {
  double excess{};  // rho - 1
  double rate{};    // w_s, rad/s

  [[nodiscard]] double breaking(double speed) const {
    const double share = speed / rate;
    return 1.0 + excess * std::exp(-share * share);
  }
};

// One state a joint: the bristle's deflection over that of a sliding one, y = s0 z / tau_c, in [-rho, rho].
//
// With delta = tau_c / s0 and s = w - |w| y / gamma:
//   y' = s / (delta + |w| / r),   F = tau_c y + s1 s / (1 + s1 |w| / (c tau_c)),   c = max(1, rho / 2).
// Passive whatever the motion, F w - d/dt(tau_c delta y^2 / 2) >= 0, where s1 >= c s0 / r and rho <= 3; here s1 / s0 =
// 2 zeta / 1500 s = 1.9 / r. (docs/theory/effects.md. Without Stribeck's fall s1 >= s0 / (2 r) is enough.) The plain
// LuGre law (r infinite, s1 not tapered) is so only up to |w| = 4 tau_c / s1.
class BristleTerm : public EffectTerm {
 public:
  int states() const final { return static_cast<int>(stiffness_.size()); }

 protected:
  explicit BristleTerm(JointVector stiffness, StribeckFall fall = {})
      : stiffness_(std::move(stiffness)),
        damping_(2.0 * presliding_damping / presliding_frequency * stiffness_),
        most_damped_(std::max(1.0, 0.5 * (1.0 + fall.excess))),
        fall_(fall) {}

  // Joint j, whose sliding friction is tau_c = `torque` >= 0, N m.
  void brake(const Kinematics& motion, int j, double torque, InternalStateView own, JointVector& torques) const {
    const double rate = motion.rates[j];
    const double speed = std::abs(rate);
    const double bent = fall_.excess == 0.0 ? own.states[j] : own.states[j] / fall_.breaking(speed);
    const double slip = rate - speed * bent;
    if (torque > 0.0) {
      const double damped = most_damped_ * damping_[j] * slip / (most_damped_ * torque + damping_[j] * speed);
      torques[j] -= torque * (own.states[j] + damped);
    }
    if (own.slopes == nullptr) return;
    const double turning = torque + stiffness_[j] * speed / turnover_rate;
    own.slopes[j] = turning > 0.0 ? stiffness_[j] * slip / turning : 0.0;
  }

 private:
  JointVector stiffness_;  // s0, N m/rad
  JointVector damping_;    // s1, N m s/rad
  double most_damped_;     // c: the most that the bristles' damping can make of tau_c where they do not bend
  StribeckFall fall_;
};

class FrictionTerm final : public BristleTerm {
 public:
  FrictionTerm(JointVector stiffness, double torque, StribeckFall fall)
      : BristleTerm(std::move(stiffness), fall), torque_(torque) {}

  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView own,
                   JointVector& torques) const override {
    for (int j = 0; j < states(); ++j) brake(motion, j, torque_, own, torques);
  }

 private:
  double torque_;  // tau_c, N m; > 0
};

// Friction whose torque tau_c = mu |q_drive| follows the drive: y stays in [-1, 1] however that changes. Where a drive
// changes under bent bristles their energy tau_c^2 y^2 / (2 s0) changes with it: 1e-8 J of a finger's, below what any
// record shows.
class LoadFrictionTerm final : public BristleTerm {
 public:
  LoadFrictionTerm(JointVector stiffness, MagneticStage drives, double coefficient)
      : BristleTerm(std::move(stiffness)), drives_(std::move(drives)), coefficient_(coefficient) {}

  void add_torques(const Kinematics& motion, const CoilCurrents& strength, InternalStateView own,
                   JointVector& torques) const override {
    JointVector drive = motion.applied != nullptr ? *motion.applied : JointVector::Zero(states());
    drives_.add_torques(motion.chain, motion.angles, strength, drive);
    for (int j = 0; j < states(); ++j) brake(motion, j, coefficient_ * std::abs(drive[j]), own, torques);
  }

 private:
  MagneticStage drives_;
  double coefficient_;  // mu; > 0
};

// Stiffness of the bristles of every joint, N m/rad.
JointVector bristles_of(const ModelSpec& spec) {
  return presliding_frequency * presliding_frequency * spec.chain.joint_mobility().cwiseInverse();
}

constexpr EffectParameter torque_parameter = from_zero("torque_Nmm", "friction torque of a sliding joint, every joint");
constexpr std::string_view friction_check =
    "bend the finger slowly by hand and let go, once from either side: it comes to rest at two angles";

EffectProperties stribeck_friction() {
  return {
      .id = "dry_friction",
      .stage = Stage::hinge,
      .description = "friction at the hinges or segment faces that falls once they slide",
      .equation =
          "q -= tau_c (1 + (rho - 1) exp(-(omega/omega_s)^2)) sgn(omega), every joint; sticks up to rho tau_c, on "
          "bristles of 1500 rad/s",
      .source =
          "LuGre with Stribeck's fall: Canudas de Wit et al., IEEE Trans. Autom. Control 40 (1995) 419, eqs. (4) and "
          "(5)",
      .check = friction_check,
      .parameters =
          {torque_parameter,
           {.key = "stribeck_ratio", .text = "static over sliding friction", .lower = 1.0, .upper = 3.0, .absent = 1.0},
           {.key = "stribeck_rate_rad_s",
            .text = "joint rate at which most of the difference has gone",
            .lower = 0.01,
            .upper = 100.0}},
      .starts =
          [](const RigScale& scale) {
            // Long holds make the rate of the whole record far less than that of its steps.
            const double slow = std::clamp(0.05 * scale.rate, 0.01, 10.0);
            const double fast = std::clamp(4.0 * scale.rate, 2.0 * slow, 100.0);
            Starts out;
            for (const double torque : {0.02 * scale.torque, 0.15 * scale.torque})
              for (const double rate : log_spread(slow, fast, 3)) out.push_back({torque, 1.4, rate});
            return out;
          },
      .build = [](Values values, ModelSpec& spec) -> Term {
        return std::make_unique<FrictionTerm>(bristles_of(spec), values[0],
                                              StribeckFall{.excess = values[1] - 1.0, .rate = values[2]});
      }};
}

}  // namespace

EffectProperties dry_friction() {
  return {.id = "dry_friction",
          .stage = Stage::hinge,
          .description = "Coulomb friction at the hinges or segment faces",
          .equation = "q -= tau_c sgn(omega), every joint; sticks up to tau_c, on bristles of 1500 rad/s",
          .source =
              "LuGre without Stribeck: Canudas de Wit et al., IEEE Trans. Autom. Control 40 (1995) 419; Astrom and "
              "Canudas de Wit, IEEE Control Syst. Mag. 28 (2008) 101",
          .check = friction_check,
          .parameters = {torque_parameter},
          .further = &kind_of<stribeck_friction>(),
          .starts = shares_of(&RigScale::torque, {0.02, 0.15}),
          .build = [](Values values, ModelSpec& spec) -> Term {
            return std::make_unique<FrictionTerm>(bristles_of(spec), values[0], StribeckFall{});
          }};
}

EffectProperties load_friction() {
  return {
      .id = "load_friction",
      .stage = Stage::hinge,
      .description = "friction of gears and bearings that grows with the torque they pass on",
      .equation =
          "q -= mu |q_drive| sgn(omega), every joint, q_drive the torque of its motor; sticks up to mu |q_drive|, on "
          "bristles of 1500 rad/s",
      .source =
          "load-dependent part of the friction of a robot's joint: Bittencourt and Gunnarsson, J. Dyn. Syst. Meas. "
          "Control 134 (2012) 051013, linear in the magnitude of the joint's torque",
      .check =
          "move a load slowly up and down through one pose and read the motor's torque: half of their difference grows "
          "with the load",
      .parameters = {from_zero("coefficient", "friction over the magnitude of the drive's torque, every joint", 1.0)},
      .starts = always({0.03, 0.2}),
      .build = [](Values values, ModelSpec& spec) -> Term {
        return std::make_unique<LoadFrictionTerm>(bristles_of(spec), spec.magnetics, values[0]);
      },
      .inapplicable = without_shafts};
}

EffectProperties quadratic_drag() {
  return {
      .id = "quadratic_drag",
      .stage = Stage::hinge,
      .description = "drag that grows with the square of the rate: air",
      .equation = "q -= c omega |omega|, every joint",
      .source = "drag at high Reynolds number: Batchelor, An Introduction to Fluid Dynamics, 1967",
      .check = "repeat a release with a card glued across the tip: drag grows with its area",
      .parameters = {from_zero("drag_Nmms2_rad2", "drag coefficient, every joint")},
      .starts = shares_of([](const RigScale& scale) { return scale.torque / (scale.rate * scale.rate); }, {0.02, 0.2}),
      .build = [](Values values, ModelSpec& /*spec*/) {
        return added_torque([drag = values[0]](const EffectTerm::Kinematics& motion, JointVector& torques) {
          torques.array() -= drag * motion.rates.array() * motion.rates.array().abs();
        });
      }};
}

}  // namespace coilwright::actuator::effects
