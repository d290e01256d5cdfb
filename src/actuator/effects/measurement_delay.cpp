#include <algorithm>

#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

constexpr double longest = 1.0;  // s; the slowest camera chains take a sixth of that
// A camera that stamps a picture when it has begun to expose it, or a bus that stamps it in advance.
constexpr double earliest = -0.05;  // s

class DelayTerm final : public EffectTerm {
 public:
  explicit DelayTerm(double delay) : delay_(delay) {}

  double delay() const override { return delay_; }

 private:
  double delay_;
};

class MeasurementDelay final : public DescribedEffect {
 public:
  MeasurementDelay()
      : DescribedEffect({.id = "measurement_delay",
                         .stage = Stage::camera,
                         .description = "camera or bus show the motion late",
                         .equation = "y(t) = theta(t - T)",
                         .source = "definition",
                         .check = "film a light that is switched on together with the current",
                         .parameters = {{.key = "delay_ms",
                                         .text = "between motion and record",
                                         .lower = earliest,
                                         .upper = longest,
                                         .absent = 0.0}}}) {}

  // Not convex where the motion rings: from a sample to several frames of a slow camera.
  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    const double low = std::min(scale.interval, 0.1 * longest);
    return one_by_one(log_spread(low, std::clamp(0.1 * scale.duration, 2.0 * low, 0.1 * longest), 4));
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& /*spec*/) const override {
    if (values[0] == 0.0) return nullptr;
    return std::make_unique<DelayTerm>(values[0]);
  }
};

}  // namespace

const EffectKind& measurement_delay() {
  static const MeasurementDelay kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
