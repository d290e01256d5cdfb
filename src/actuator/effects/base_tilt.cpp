#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

class BaseTilt final : public DescribedEffect {
 public:
  BaseTilt()
      : DescribedEffect({.id = "base_tilt",
                         .stage = Stage::chain,
                         .description = "the mounting is not level",
                         .equation = "V(theta_1, ...) -> V(theta_1 + phi, ...): gravity turned by phi",
                         .source = "definition; mechanics::PlanarChain",
                         .check = "put a spirit level on the mount, or hang a plumb line beside the finger",
                         .parameters = {{.key = "angle_deg",
                                         .text = "of the whole chain towards opening, besides the declared tilt",
                                         .lower = -45.0 / degrees,
                                         .upper = 45.0 / degrees,
                                         .absent = 0.0}}}) {}

  std::optional<std::string> inapplicable(const ModelSpec& spec) const override {
    if (spec.chain.gravity() == 0.0) return "the model has no gravity";
    return std::nullopt;
  }

  std::vector<std::vector<double>> starts(const RigScale& /*scale*/) const override {
    return one_by_one({2.0 / degrees, -2.0 / degrees});
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    spec.chain = spec.chain.under_gravity(spec.chain.gravity(), spec.chain.base_tilt() + values[0]);
    return nullptr;
  }
};

}  // namespace

const EffectKind& base_tilt() {
  static const BaseTilt kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
