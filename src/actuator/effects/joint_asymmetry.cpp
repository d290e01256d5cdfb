#include "actuator/effects/springs.hpp"
#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

class JointAsymmetry final : public DescribedEffect {
 public:
  JointAsymmetry()
      : DescribedEffect(
            {.id = "joint_asymmetry",
             .stage = Stage::hinge,
             .description = "the joints are not alike",
             .equation = "k_2 -> rho k_2, of every second joint; k_2 = rho k_1 where they are declared alike",
             .source = "k ~ h_b^3 of a moulded hinge: 5 % in its height are 16 % in its stiffness",
             .check = "measure the stiffness of each joint by itself with a force gauge",
             .parameters = {{.key = "stiffness_ratio",
                             .text = "of every second joint's stiffness to its declared one",
                             .lower = 0.1,
                             .upper = 10.0,
                             .absent = 1.0}}}) {}

  std::optional<std::string> inapplicable(const ModelSpec& spec) const override {
    if (spec.hinges.size() < 2) return "the model has one joint only";
    for (std::size_t j = 1; j < spec.hinges.size(); j += 2)
      if (spec.hinges[j].stiffness > 0.0) return std::nullopt;
    return "no second joint has a spring";
  }

  std::vector<std::vector<double>> starts(const RigScale& /*scale*/) const override { return one_by_one({0.8, 1.25}); }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    for (std::size_t j = 1; j < spec.hinges.size(); j += 2) spec.hinges[j].stiffness *= values[0];
    return nullptr;
  }
};

}  // namespace

const EffectKind& joint_asymmetry() {
  static const JointAsymmetry kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
