#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

class GainTerm final : public EffectTerm {
 public:
  explicit GainTerm(double gain) : gain_(gain) {}

  void magnetize(InternalStateView /*own*/, const CoilCurrents& /*currents*/, CoilCurrents& strength) const override {
    strength *= gain_;
  }

 private:
  double gain_;
};

class ForceGain final : public DescribedEffect {
 public:
  ForceGain()
      : DescribedEffect(
            {.id = "force_gain",
             .stage = Stage::magnetics,
             .description = "all forces of the coils are off by one factor: remanence, turns or current sensor",
             .equation = "f -> gamma f",
             .source = "the force is a product of remanence, turns and current: Ravaud et al., IEEE Trans. "
                       "Magn. 46 (2010) 3585",
             .check = "measure one torque or force at rest under a known current (runs of kind static_torque or "
                      "blocked_force)",
             .parameters = {{.key = "gain",
                             .text = "real over declared force of a coil at a current",
                             .lower = 0.1,
                             .upper = 10.0,
                             .absent = 1.0}}}) {}

  std::vector<std::vector<double>> starts(const RigScale& /*scale*/) const override { return one_by_one({0.9, 1.1}); }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& /*spec*/) const override {
    if (values[0] == 1.0) return nullptr;
    return std::make_unique<GainTerm>(values[0]);
  }
};

}  // namespace

const EffectKind& force_gain() {
  static const ForceGain kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
