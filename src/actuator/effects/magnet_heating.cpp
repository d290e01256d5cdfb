#include <algorithm>
#include <limits>

#include "actuator/effects/heat.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

// One state: x = beta (T - T_ambient), the share of their remanence that the magnets have lost.
class MagnetHeatTerm final : public EffectTerm {
 public:
  struct Spec {
    double loss{};
    double time_constant{};
    double warm_start{};
  };
  explicit MagnetHeatTerm(const Spec& spec)
      : loss_(spec.loss), time_constant_(spec.time_constant), warm_start_(spec.warm_start) {}

  int states() const override { return 1; }
  bool slow() const override { return time_constant_ > slow_time; }

  void settle(const Kinematics& /*motion*/, const CoilCurrents& currents, double* out) const override {
    out[0] = steady(currents);
  }

  void begin(const Kinematics& /*motion*/, const CoilCurrents& currents, double* out) const override {
    out[0] = warm_start_ * steady(currents);
  }

  // A magnet loses all its remanence at the worst and never turns round.
  void magnetize(InternalStateView own, const CoilCurrents& currents, CoilCurrents& strength) const override {
    strength *= std::clamp(1.0 - own.states[0], 0.0, 1.0);
    if (own.slopes != nullptr) own.slopes[0] = (steady(currents) - own.states[0]) / time_constant_;
  }

 private:
  // All coils warm all magnets alike: every magnet lies between coils, and one camera cannot tell them apart.
  double steady(const CoilCurrents& currents) const {
    return loss_ * currents.squaredNorm() / static_cast<double>(currents.size());
  }

  double loss_;
  double time_constant_;
  double warm_start_;
};

class MagnetHeating final : public DescribedEffect {
 public:
  MagnetHeating()
      : DescribedEffect(
            {.id = "magnet_heating",
             .stage = Stage::magnetics,
             .description = "warm magnets lose remanence, so the force fades at a given current",
             .equation = "f -> f max(1 - x, 0), x' = (a <i^2> - x)/T, x = beta dT, <i^2>: mean over the coils",
             .source = "reversible temperature coefficient of remanence, 0.09 to 0.12 %/K for NdFeB (IEC "
                       "60404-8-1), and one heat capacity",
             .check = "repeat one step cold and right after a long hold, and take the magnet's temperature",
             .parameters = {{.key = "loss_1_A2",
                             .text = "share of the force lost in the steady state per square ampere",
                             .lower = 0.0,
                             .upper = std::numeric_limits<double>::infinity(),
                             .absent = 0.0},
                            {.key = "time_constant_s",
                             .text = "thermal time constant of the magnets",
                             .lower = shortest_heat,
                             .upper = longest_heat},
                            warm_start}}) {}

  std::vector<std::vector<double>> starts(const RigScale& scale) const override { return heat_starts(scale); }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& /*spec*/) const override {
    if (values[0] == 0.0) return nullptr;
    return std::make_unique<MagnetHeatTerm>(
        MagnetHeatTerm::Spec{.loss = values[0], .time_constant = values[1], .warm_start = values[2]});
  }
};

}  // namespace

const EffectKind& magnet_heating() {
  static const MagnetHeating kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
