#include <algorithm>
#include <cmath>
#include <limits>

#include "actuator/effects/heat.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

// One state a coil: x = alpha (T - T_ambient), by how much its resistance has risen.
class CoilHeatTerm final : public EffectTerm {
 public:
  struct Spec {
    double fade{};
    double time_constant{};
    double warm_start{};
  };
  CoilHeatTerm(int coils, const Spec& spec)
      : coils_(coils), fade_(spec.fade), time_constant_(spec.time_constant), warm_start_(spec.warm_start) {}

  int states() const override { return coils_; }
  bool slow() const override { return time_constant_ > slow_time; }

  // x (1 + x) = a i^2.
  void settle(const Kinematics& /*motion*/, const CoilCurrents& currents, double* out) const override {
    for (int c = 0; c < coils_; ++c) {
      const double load = fade_ * currents[c] * currents[c];
      out[c] = 2.0 * load / (1.0 + std::sqrt(1.0 + 4.0 * load));
    }
  }

  void begin(const Kinematics& motion, const CoilCurrents& currents, double* out) const override {
    settle(motion, currents, out);
    for (int c = 0; c < coils_; ++c) out[c] *= warm_start_;
  }

  void drive(InternalStateView own, CoilCurrents& currents) const override {
    for (int c = 0; c < coils_; ++c) {
      const double rise = std::max(own.states[c], 0.0);  // an integrator's trial step may undershoot
      const double cold = currents[c];
      currents[c] = cold / (1.0 + rise);
      if (own.slopes != nullptr) own.slopes[c] = (fade_ * cold * currents[c] - own.states[c]) / time_constant_;
    }
  }

 private:
  int coils_;
  double fade_;
  double time_constant_;
  double warm_start_;
};

class CoilHeating final : public DescribedEffect {
 public:
  CoilHeating()
      : DescribedEffect(
            {.id = "coil_heating",
             .stage = Stage::drive,
             .description = "a warm coil resists more, so its current fades under a given voltage",
             .equation = "i -> i/(1 + x), x' = (a i^2/(1 + x) - x)/T, x = alpha dT: power u^2/R falls as R rises",
             .source = "copper's linear resistivity (IEC 60028) and one heat capacity: C dT' = u i - dT/R_th",
             .check = "log voltage and current through one long hold: their quotient rises as the coil warms",
             .parameters = {{.key = "fade_1_A2",
                             .text = "rise of the resistance in the steady state over the power of a cold coil",
                             .lower = 0.0,
                             .upper = std::numeric_limits<double>::infinity(),
                             .absent = 0.0},
                            {.key = "time_constant_s",
                             .text = "thermal time constant of the coil",
                             .lower = shortest_heat,
                             .upper = longest_heat},
                            warm_start}}) {}

  std::vector<std::vector<double>> starts(const RigScale& scale) const override { return heat_starts(scale); }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    if (values[0] == 0.0) return nullptr;
    return std::make_unique<CoilHeatTerm>(
        spec.coils, CoilHeatTerm::Spec{.fade = values[0], .time_constant = values[1], .warm_start = values[2]});
  }
};

}  // namespace

const EffectKind& coil_heating() {
  static const CoilHeating kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
