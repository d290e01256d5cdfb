#include <algorithm>
#include <cmath>
#include <limits>

#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

class SaturationTerm final : public EffectTerm {
 public:
  explicit SaturationTerm(double limit) : limit_(limit) {}

  void drive(InternalStateView /*own*/, CoilCurrents& currents) const override {
    for (double& current : currents) current = std::clamp(current, -limit_, limit_);
  }

 private:
  double limit_;
};

// No finite limit is without effect on every command, so absent is infinity and lies outside the bounds; to a fit, any
// limit above its largest command is as good.
class DriverSaturation final : public DescribedEffect {
 public:
  DriverSaturation()
      : DescribedEffect({.id = "driver_saturation",
                         .stage = Stage::drive,
                         .description = "the driver or its supply gives less current than the largest command",
                         .equation = "i -> max(-i_max, min(i, i_max))",
                         .source = "current limit of a driver or u_max / R of its supply; definition",
                         .check = "put an ammeter in the coil's lead and command the largest current",
                         .parameters = {{.key = "current_A",
                                         .text = "largest current that the driver gives, either sign",
                                         .lower = 0.0,
                                         .upper = 1e3,
                                         .absent = std::numeric_limits<double>::infinity()}}}) {}

  // The fit sees a limit only while it cuts something off: from close below the largest command downwards.
  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    return one_by_one({0.95 * scale.current, 0.8 * scale.current, 0.6 * scale.current});
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& /*spec*/) const override {
    if (std::isinf(values[0])) return nullptr;
    return std::make_unique<SaturationTerm>(values[0]);
  }
};

}  // namespace

const EffectKind& driver_saturation() {
  static const DriverSaturation kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
