#include <algorithm>
#include <cmath>

#include "actuator/effects/effect_rows.hpp"

// What brakes a joint that moves: dry friction, of its own and of its drive, and drag.
namespace coilwright::actuator::effects {
namespace {

using mechanics::JointVector;

// How much more than sliding friction a joint at rest holds, and how fast that falls:
// gamma = 1 + (rho - 1) exp(-(w / w_s)^2) times the friction of a fast one.
struct StribeckFall {
  double excess{};    // rho - 1
  double rate = 1.0;  // w_s, rad/s

  [[nodiscard]] double factor(double rate_now) const {
    const double share = rate_now / rate;
    return excess == 0.0 ? 1.0 : 1.0 + excess * std::exp(-share * share);
  }
};

// Coulomb's law, with where it stands between its two regimes as a state: F = tau_c gamma(w) y, y = sgn(w) of a joint
// that slides, and whatever holds it, |y| <= 1, of one at rest (EffectTerm::holds_joints).
class CoulombTerm : public EffectTerm {
 public:
  explicit CoulombTerm(int joints) : joints_(joints) {}
  int states() const final { return joints_; }
  bool holds_joints() const final { return true; }

 protected:
  static void leave(InternalStateView own, int joint) {
    if (own.slopes != nullptr) own.slopes[joint] = 0.0;
  }

 private:
  int joints_;
};

class FrictionTerm final : public CoulombTerm {
 public:
  FrictionTerm(int joints, double torque, StribeckFall fall) : CoulombTerm(joints), torque_(torque), fall_(fall) {}

  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView own,
                   JointVector& torques) const override {
    for (int j = 0; j < states(); ++j) {
      torques[j] -= torque_ * fall_.factor(motion.rates[j]) * own.states[j];
      leave(own, j);
    }
  }

 private:
  double torque_;  // tau_c, N m; > 0
  StribeckFall fall_;
};

// Friction whose torque tau_c = mu |q_drive| follows the drive.
class LoadFrictionTerm final : public CoulombTerm {
 public:
  LoadFrictionTerm(int joints, MagneticStage drives, double coefficient)
      : CoulombTerm(joints), drives_(std::move(drives)), coefficient_(coefficient) {}

  void add_torques(const Kinematics& motion, const CoilCurrents& strength, InternalStateView own,
                   JointVector& torques) const override {
    JointVector drive = motion.applied != nullptr ? *motion.applied : JointVector::Zero(states());
    drives_.add_torques(motion.chain, motion.angles, strength, drive);
    for (int j = 0; j < states(); ++j) {
      torques[j] -= coefficient_ * std::abs(drive[j]) * own.states[j];
      leave(own, j);
    }
  }

 private:
  MagneticStage drives_;
  double coefficient_;  // mu; > 0
};

constexpr EffectParameter torque_parameter = from_zero("torque_Nmm", "friction torque of a sliding joint, every joint");
constexpr std::string_view friction_check =
    "bend the finger slowly by hand and let go, once from either side: it comes to rest at two angles";

EffectProperties stribeck_friction() {
  return {
      .id = "dry_friction",
      .stage = Stage::hinge,
      .description = "friction at the hinges or segment faces that falls once they slide",
      .equation = "q -= tau_c (1 + (rho - 1) exp(-(omega/omega_s)^2)) sgn(omega), every joint; sticks up to rho tau_c",
      .source =
          "Stribeck's fall in the form of Canudas de Wit et al., IEEE Trans. Autom. Control 40 (1995) 419, eq. (5)",
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
        return std::make_unique<FrictionTerm>(spec.chain.joints(), values[0],
                                              StribeckFall{.excess = values[1] - 1.0, .rate = values[2]});
      }};
}

}  // namespace

EffectProperties dry_friction() {
  return {.id = "dry_friction",
          .stage = Stage::hinge,
          .description = "Coulomb friction at the hinges or segment faces",
          .equation = "q -= tau_c sgn(omega), every joint; sticks up to tau_c",
          .source = "Coulomb's law: Armstrong-Helouvry et al., Automatica 30 (1994) 1083, section 3.1",
          .check = friction_check,
          .parameters = {torque_parameter},
          .further = &kind_of<stribeck_friction>(),
          .starts = shares_of(&RigScale::torque, {0.02, 0.15}),
          .build = [](Values values, ModelSpec& spec) -> Term {
            return std::make_unique<FrictionTerm>(spec.chain.joints(), values[0], StribeckFall{});
          }};
}

EffectProperties load_friction() {
  return {
      .id = "load_friction",
      .stage = Stage::hinge,
      .description = "friction of gears and bearings that grows with the torque they pass on",
      .equation =
          "q -= mu |q_drive| sgn(omega), every joint, q_drive the torque of its motor; sticks up to mu |q_drive|",
      .source =
          "load-dependent part of the friction of a robot's joint: Bittencourt and Gunnarsson, J. Dyn. Syst. Meas. "
          "Control 134 (2012) 051013, linear in the magnitude of the joint's torque",
      .check =
          "move a load slowly up and down through one pose and read the motor's torque: half of their difference grows "
          "with the load",
      .parameters = {from_zero("coefficient", "friction over the magnitude of the drive's torque, every joint", 1.0)},
      .starts = always({0.03, 0.2}),
      .build = [](Values values, ModelSpec& spec) -> Term {
        return std::make_unique<LoadFrictionTerm>(spec.chain.joints(), spec.magnetics, values[0]);
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
