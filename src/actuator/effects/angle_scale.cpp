#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

class ScaleTerm final : public EffectTerm {
 public:
  explicit ScaleTerm(double scale) : scale_(scale) {}

  double observed(double angle) const override { return scale_ * angle; }

 private:
  double scale_;
};

class AngleScale final : public DescribedEffect {
 public:
  AngleScale()
      : DescribedEffect(
            {.id = "angle_scale",
             .stage = Stage::camera,
             .description = "the sensor's scale is off: lens, encoder counts",
             .equation = "y = s theta, every angle shown",
             .source = "definition",
             .check = "bend the joints by a known angle, along a printed template, and compare what the sensor shows",
             .parameters = {
                 {.key = "scale", .text = "angle shown over angle", .lower = 0.5, .upper = 2.0, .absent = 1.0}}}) {}

  std::vector<std::vector<double>> starts(const RigScale& /*scale*/) const override { return one_by_one({0.97, 1.03}); }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& /*spec*/) const override {
    if (values[0] == 1.0) return nullptr;
    return std::make_unique<ScaleTerm>(values[0]);
  }
};

}  // namespace

const EffectKind& angle_scale() {
  static const AngleScale kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
