#include <algorithm>
#include <cmath>
#include <limits>

#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

class DeadbandTerm final : public EffectTerm {
 public:
  explicit DeadbandTerm(double band) : band_(band) {}

  void drive(InternalStateView /*own*/, CoilCurrents& currents) const override {
    for (double& current : currents) current = std::copysign(std::max(std::abs(current) - band_, 0.0), current);
  }

 private:
  double band_;
};

// Continuous: what is lost at the band is lost beyond it too, as on a bridge whose switches take their dead time from
// every pulse. The other kind of band, which lets a larger command through whole, is a nonlinear driver and not a band.
class DriverDeadband final : public DescribedEffect {
 public:
  DriverDeadband()
      : DescribedEffect(
            {.id = "driver_deadband",
             .stage = Stage::drive,
             .description = "small commands are lost in the driver",
             .equation = "i -> sgn(i) max(|i| - d, 0)",
             .source = "dead zone of an actuator: Tao and Kokotovic, IEEE Trans. Autom. Control 39 (1994) 59",
             .check = "put an ammeter in the coil's lead and command small currents in steps around the band",
             .parameters = {{.key = "current_A",
                             .text = "half the band of commands without an answer",
                             .lower = 0.0,
                             .upper = std::numeric_limits<double>::infinity(),
                             .absent = 0.0}}}) {}

  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    return one_by_one({0.03 * scale.current, 0.15 * scale.current});
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& /*spec*/) const override {
    if (values[0] == 0.0) return nullptr;
    return std::make_unique<DeadbandTerm>(values[0]);
  }
};

}  // namespace

const EffectKind& driver_deadband() {
  static const DriverDeadband kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
