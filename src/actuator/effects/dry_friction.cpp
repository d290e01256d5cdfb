#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "actuator/effects/bristles.hpp"
#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

using mechanics::JointVector;

constexpr double infinity = std::numeric_limits<double>::infinity();

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
class FrictionTerm final : public EffectTerm {
 public:
  FrictionTerm(JointVector stiffness, double torque, StribeckFall fall)
      : stiffness_(std::move(stiffness)),
        damping_(2.0 * presliding_damping / presliding_frequency * stiffness_),
        torque_(torque),
        most_damped_(std::max(1.0, 0.5 * (1.0 + fall.excess))),
        fall_(fall) {}

  int states() const override { return static_cast<int>(stiffness_.size()); }

  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView own,
                   JointVector& torques) const override {
    for (int j = 0; j < states(); ++j) {
      const double rate = motion.rates[j];
      const double speed = std::abs(rate);
      const double bent = fall_.excess == 0.0 ? own.states[j] : own.states[j] / fall_.breaking(speed);
      const double slip = rate - speed * bent;
      const double damped = most_damped_ * damping_[j] * slip / (most_damped_ * torque_ + damping_[j] * speed);
      torques[j] -= torque_ * (own.states[j] + damped);
      if (own.slopes != nullptr)
        own.slopes[j] = stiffness_[j] * slip / (torque_ + stiffness_[j] * speed / turnover_rate);
    }
  }

 private:
  JointVector stiffness_;  // s0, N m/rad
  JointVector damping_;    // s1, N m s/rad
  double torque_;          // tau_c, N m; > 0
  double most_damped_;     // c: the most that the bristles' damping can make of tau_c where they do not bend
  StribeckFall fall_;
};

std::unique_ptr<const EffectTerm> build_friction(double torque, StribeckFall fall, const ModelSpec& spec) {
  if (torque == 0.0) return nullptr;
  JointVector stiffness = presliding_frequency * presliding_frequency * spec.chain.joint_mobility().cwiseInverse();
  return std::make_unique<FrictionTerm>(std::move(stiffness), torque, fall);
}

constexpr EffectParameter torque_parameter{.key = "torque_Nmm",
                                           .text = "friction torque of a sliding joint, every joint",
                                           .lower = 0.0,
                                           .upper = infinity,
                                           .absent = 0.0};

class StribeckFriction final : public DescribedEffect {
 public:
  StribeckFriction()
      : DescribedEffect(
            {.id = "dry_friction",
             .stage = Stage::hinge,
             .description = "friction at the hinges or segment faces that falls once they slide",
             .equation = "q -= tau_c (1 + (rho - 1) exp(-(omega/omega_s)^2)) sgn(omega), every joint; "
                         "sticks up to rho tau_c, on bristles of 1500 rad/s",
             .source = "LuGre with Stribeck's fall: Canudas de Wit et al., IEEE Trans. Autom. Control 40 "
                       "(1995) 419, eqs. (4) and (5)",
             .check =
                 "bend the finger slowly by hand and let go, once from either side: it comes to rest at two angles",
             .parameters = {torque_parameter,
                            {.key = "stribeck_ratio",
                             .text = "static over sliding friction",
                             .lower = 1.0,
                             .upper = 3.0,
                             .absent = 1.0},
                            {.key = "stribeck_rate_rad_s",
                             .text = "joint rate at which most of the difference has gone",
                             .lower = 0.01,
                             .upper = 100.0}}}) {}

  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    // Long holds make the rate of the whole record far less than that of its steps.
    const double slow = std::clamp(0.05 * scale.rate, 0.01, 10.0);
    const double fast = std::clamp(4.0 * scale.rate, 2.0 * slow, 100.0);
    std::vector<std::vector<double>> out;
    for (const double torque : {0.02 * scale.torque, 0.15 * scale.torque})
      for (const double rate : log_spread(slow, fast, 3)) out.push_back({torque, 1.4, rate});
    return out;
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    return build_friction(values[0], {.excess = values[1] - 1.0, .rate = values[2]}, spec);
  }
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
             .check =
                 "bend the finger slowly by hand and let go, once from either side: it comes to rest at two angles",
             .parameters = {torque_parameter}}) {}

  const EffectKind* with_further_numbers() const override {
    static const StribeckFriction kind;
    return &kind;
  }

  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    return one_by_one({0.02 * scale.torque, 0.15 * scale.torque});
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    return build_friction(values[0], {}, spec);
  }
};

}  // namespace

const EffectKind& dry_friction() {
  static const DryFriction kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
