#include "actuator/effects/springs.hpp"
#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

class RestAngle final : public DescribedEffect {
 public:
  RestAngle()
      : DescribedEffect({.id = "rest_angle",
                         .stage = Stage::hinge,
                         .description = "the hinges relax at an angle of their own: pre-stress, set",
                         .equation = "q = -k (theta - theta_0), every joint",
                         .source = "linear spring with a natural angle; definition",
                         .check = "lay the finger on its side, without current, and read the angle of its joints",
                         .parameters = {{.key = "angle_deg",
                                         .text = "angle at which a hinge is relaxed, every joint",
                                         .lower = -45.0 / degrees,
                                         .upper = 45.0 / degrees,
                                         .absent = 0.0}}}) {}

  std::optional<std::string> inapplicable(const ModelSpec& spec) const override { return without_springs(spec); }

  std::vector<std::vector<double>> starts(const RigScale& /*scale*/) const override {
    return one_by_one({2.0 / degrees, -2.0 / degrees});
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    for (Hinge& hinge : spec.hinges) hinge.torque_offset += hinge.stiffness * values[0];
    return nullptr;
  }
};

}  // namespace

const EffectKind& rest_angle() {
  static const RestAngle kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
