#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

class AngleOffsetTerm final : public EffectTerm {
 public:
  explicit AngleOffsetTerm(double offset) : offset_(offset) {}

  double observed(double angle) const override { return angle + offset_; }

 private:
  double offset_;
};

// After the scale: an offset is what the sensor shows at zero.
class AngleOffset final : public DescribedEffect {
 public:
  AngleOffset()
      : DescribedEffect({.id = "angle_offset",
                         .stage = Stage::camera,
                         .description = "the sensor's zero is off",
                         .equation = "y = theta + theta_b, every angle shown",
                         .source = "definition",
                         .check = "hold the finger straight against a ruler and read the angle that the sensor shows",
                         .parameters = {{.key = "angle_deg",
                                         .text = "shown at angle zero",
                                         .lower = -10.0 / degrees,
                                         .upper = 10.0 / degrees,
                                         .absent = 0.0}}}) {}

  std::vector<std::vector<double>> starts(const RigScale& /*scale*/) const override {
    return one_by_one({1.0 / degrees, -1.0 / degrees});
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& /*spec*/) const override {
    if (values[0] == 0.0) return nullptr;
    return std::make_unique<AngleOffsetTerm>(values[0]);
  }
};

}  // namespace

const EffectKind& angle_offset() {
  static const AngleOffset kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
