#include <limits>

#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

class DragTerm final : public EffectTerm {
 public:
  explicit DragTerm(double drag) : drag_(drag) {}

  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView /*own*/,
                   mechanics::JointVector& torques) const override {
    torques.array() -= drag_ * motion.rates.array() * motion.rates.array().abs();
  }

 private:
  double drag_;
};

class QuadraticDrag final : public DescribedEffect {
 public:
  QuadraticDrag()
      : DescribedEffect({.id = "quadratic_drag",
                         .stage = Stage::hinge,
                         .description = "drag that grows with the square of the rate: air",
                         .equation = "q -= c omega |omega|, every joint",
                         .source = "drag at high Reynolds number: Batchelor, An Introduction to Fluid Dynamics, 1967",
                         .check = "repeat a release with a card glued across the tip: drag grows with its area",
                         .parameters = {{.key = "drag_Nmms2_rad2",
                                         .text = "drag coefficient, every joint",
                                         .lower = 0.0,
                                         .upper = std::numeric_limits<double>::infinity(),
                                         .absent = 0.0}}}) {}

  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    const double whole = scale.torque / (scale.rate * scale.rate);
    return one_by_one({0.02 * whole, 0.2 * whole});
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& /*spec*/) const override {
    if (values[0] == 0.0) return nullptr;
    return std::make_unique<DragTerm>(values[0]);
  }
};

}  // namespace

const EffectKind& quadratic_drag() {
  static const QuadraticDrag kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
