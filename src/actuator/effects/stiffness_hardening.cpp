#include <algorithm>
#include <cmath>
#include <limits>

#include "actuator/effects/springs.hpp"
#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

// As far as the spring's slope stays positive, 1 + 3 beta theta^2 > 0; beyond, a softening spring keeps its torque
// instead of letting go. At the lowest beta that is one radian.
class HardeningTerm final : public EffectTerm {
 public:
  HardeningTerm(mechanics::JointVector stiffness, double coefficient)
      : stiffness_(std::move(stiffness)),
        coefficient_(coefficient),
        turn_(coefficient < 0.0 ? 1.0 / std::sqrt(-3.0 * coefficient) : std::numeric_limits<double>::infinity()) {}

  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView /*own*/,
                   mechanics::JointVector& torques) const override {
    for (int j = 0; j < stiffness_.size(); ++j) {
      const double angle = motion.angles[j];
      const double within = std::clamp(angle, -turn_, turn_);
      torques[j] -= stiffness_[j] * (coefficient_ * within * within * within - (angle - within));
    }
  }

 private:
  mechanics::JointVector stiffness_;
  double coefficient_;
  double turn_;
};

class StiffnessHardening final : public DescribedEffect {
 public:
  StiffnessHardening()
      : DescribedEffect(
            {.id = "stiffness_hardening",
             .stage = Stage::hinge,
             .description = "the hinge is not linear: it stiffens (or softens) with the angle",
             .equation = "q -= k beta theta^3; where 1 + 3 beta theta^2 < 0 the whole spring's torque stays",
             .source = "first odd term of a hyperelastic spring: Duffing; Gent, Rubber Chem. Technol. 69 "
                       "(1996) 59",
             .check = "measure the torque of a joint over its angle with a force gauge, up to the largest angle",
             .parameters = {{.key = "coefficient_1_rad2",
                             .text = "share of the stiffness gained at one radian",
                             .lower = -1.0 / 3.0,
                             .upper = 1e3,
                             .absent = 0.0}}}) {}

  std::optional<std::string> inapplicable(const ModelSpec& spec) const override { return without_springs(spec); }

  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    const double square = scale.angle * scale.angle;
    return one_by_one({std::min(0.2 / square, 1e2), std::max(-0.05 / square, -0.2)});
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    if (values[0] == 0.0) return nullptr;
    return std::make_unique<HardeningTerm>(stiffnesses(spec), values[0]);
  }
};

}  // namespace

const EffectKind& stiffness_hardening() {
  static const StiffnessHardening kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
