#include <algorithm>

#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

// A shorter lag changes no sample of a camera or an encoder (at 10 kHz: a fifth of a sample), and would only ask the
// integrator for steps that small: it is taken as none.
constexpr double quasi_static = 20e-6;

// One state a coil: its current.
class LagTerm final : public EffectTerm {
 public:
  LagTerm(int coils, double time_constant) : coils_(coils), time_constant_(time_constant) {}

  int states() const override { return coils_; }

  void settle(const Kinematics& /*motion*/, const CoilCurrents& currents, double* out) const override {
    std::copy_n(currents.data(), coils_, out);
  }

  void drive(InternalStateView own, CoilCurrents& currents) const override {
    for (int c = 0; c < coils_; ++c) {
      if (own.slopes != nullptr) own.slopes[c] = (currents[c] - own.states[c]) / time_constant_;
      currents[c] = own.states[c];
    }
  }

 private:
  int coils_;
  double time_constant_;
};

// Last in the drive's row: what the driver commands, limits and biases, the coil's inductance delays.
class CoilLag final : public DescribedEffect {
 public:
  CoilLag()
      : DescribedEffect(
            {.id = "coil_lag",
             .stage = Stage::drive,
             .description = "the current follows its command with a delay: L/R, or a current loop's bandwidth",
             .equation = "i' = (i_cmd - i)/T; none below T = 0.02 ms",
             .source = "L i' + R i = u, T = L/R",
             .check = "record the coil's current in one step with a shunt and an oscilloscope",
             .parameters = {{.key = "time_constant_ms",
                             .text = "of the current's answer to a step",
                             .lower = 0.0,
                             .upper = 1.0,
                             .absent = 0.0}}}) {}

  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    const double low = std::clamp(scale.interval, 2.0 * quasi_static, 0.1);
    return one_by_one(log_spread(low, std::clamp(0.1 * scale.duration, 2.0 * low, 0.5), 3));
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    if (values[0] < quasi_static) return nullptr;
    return std::make_unique<LagTerm>(spec.coils, values[0]);
  }
};

}  // namespace

const EffectKind& coil_lag() {
  static const CoilLag kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
