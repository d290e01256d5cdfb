#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

class OffsetTerm final : public EffectTerm {
 public:
  explicit OffsetTerm(double offset) : offset_(offset) {}

  void drive(InternalStateView /*own*/, CoilCurrents& currents) const override { currents.array() += offset_; }

 private:
  double offset_;
};

// After band and limit: the bias of a current loop's sensor flows at any command, at none too.
class CurrentOffset final : public DescribedEffect {
 public:
  CurrentOffset()
      : DescribedEffect({.id = "current_offset",
                         .stage = Stage::drive,
                         .description = "a bias of the driver or of its current sensor",
                         .equation = "i -> i + i_0",
                         .source = "definition",
                         .check = "command zero and read an ammeter in the coil's lead",
                         .parameters = {{.key = "current_mA",
                                         .text = "current of every coil at no command",
                                         .lower = -5.0,
                                         .upper = 5.0,
                                         .absent = 0.0}}}) {}

  bool needs_closed_circuit() const override { return true; }

  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    return one_by_one({0.02 * scale.current, -0.02 * scale.current});
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& /*spec*/) const override {
    if (values[0] == 0.0) return nullptr;
    return std::make_unique<OffsetTerm>(values[0]);
  }
};

}  // namespace

const EffectKind& current_offset() {
  static const CurrentOffset kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
