#include <cmath>
#include <limits>

#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

// One state a joint: z in [-1, 1].
class HysteresisTerm final : public EffectTerm {
 public:
  HysteresisTerm(int joints, double amplitude, double sharpness)
      : joints_(joints), amplitude_(amplitude), sharpness_(sharpness) {}

  int states() const override { return joints_; }

  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView own,
                   mechanics::JointVector& torques) const override {
    for (int j = 0; j < joints_; ++j) {
      const double rate = motion.rates[j];
      torques[j] -= amplitude_ * own.states[j];
      if (own.slopes != nullptr) own.slopes[j] = sharpness_ * (rate - std::abs(rate) * own.states[j]);
    }
  }

 private:
  int joints_;
  double amplitude_;
  double sharpness_;
};

// The same law as dry friction's bristle, but wide: a loop that needs degrees to turn over is the material's, one that
// turns over within a milliradian is friction. The bound on the sharpness, 100/rad or 10 mrad, keeps the two apart.
class Hysteresis final : public DescribedEffect {
 public:
  Hysteresis()
      : DescribedEffect({.id = "hysteresis",
                         .stage = Stage::hinge,
                         .description = "the material's loop does not depend on how fast it is gone through",
                         .equation = "q -= a z, z' = gamma (omega - |omega| z), every joint",
                         .source =
                             "Bouc, 4th Conf. on Nonlinear Oscillation, Prague 1967; Wen, J. Eng. Mech. Div. ASCE "
                             "102 (1976) 249, with n = 1 and no pinching: Dahl",
                         .check = "go up and down through the same currents slowly and compare the angles at rest",
                         .parameters = {{.key = "amplitude_Nmm",
                                         .text = "torque between middle and edge of the loop",
                                         .lower = 0.0,
                                         .upper = std::numeric_limits<double>::infinity(),
                                         .absent = 0.0},
                                        {.key = "sharpness_1_rad",
                                         .text = "one over the angle within which the loop turns over",
                                         .lower = 0.5,
                                         .upper = 100.0}}}) {}

  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    return each_with_each({0.05 * scale.torque}, {3.0, 12.0, 50.0});
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    if (values[0] == 0.0) return nullptr;
    return std::make_unique<HysteresisTerm>(spec.chain.joints(), values[0], values[1]);
  }
};

}  // namespace

const EffectKind& hysteresis() {
  static const Hysteresis kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
