#include <algorithm>

#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

// As of a coil's lag: a shorter filter changes no sample and would only cost steps.
constexpr double shortest_lag = 20e-6;

// One state a joint: its angle as shown. Linear, so the shown sum of angles is the sum of the shown angles.
class TrackingLagTerm final : public EffectTerm {
 public:
  TrackingLagTerm(int joints, double time_constant) : joints_(joints), time_constant_(time_constant) {}

  int states() const override { return joints_; }

  void settle(const Kinematics& motion, const CoilCurrents& /*currents*/, double* out) const override {
    std::copy_n(motion.angles.data(), joints_, out);
  }

  void show(InternalStateView own, mechanics::JointVector& angles, mechanics::JointVector& rates) const override {
    for (int j = 0; j < joints_; ++j) {
      rates[j] = (angles[j] - own.states[j]) / time_constant_;
      angles[j] = own.states[j];
      if (own.slopes != nullptr) own.slopes[j] = rates[j];
    }
  }

 private:
  int joints_;
  double time_constant_;
};

class TrackingLag final : public DescribedEffect {
 public:
  TrackingLag()
      : DescribedEffect(
            {.id = "tracking_lag",
             .stage = Stage::camera,
             .description = "the camera's tracking filters: what it shows follows the motion",
             .equation = "shown' = (theta - shown)/T, every angle",
             .source = "first-order low-pass filter; definition",
             .check = "move a target by hand and compare the tracked angle with the raw pictures",
             .parameters = {
                 {.key = "time_constant_ms", .text = "of the filter", .lower = 0.0, .upper = 1.0, .absent = 0.0}}}) {}

  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    const double low = std::clamp(scale.interval, 1e-3, 0.1);
    return one_by_one({low, std::min(4.0 * low, 0.5)});
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    if (values[0] < shortest_lag) return nullptr;
    return std::make_unique<TrackingLagTerm>(spec.chain.joints(), values[0]);
  }
};

}  // namespace

const EffectKind& tracking_lag() {
  static const TrackingLag kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
