#include <algorithm>
#include <utility>

#include "actuator/effects/springs.hpp"
#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

constexpr double shortest = 1e-3;  // s; a faster dashpot is a damper to any camera
constexpr double longest_time_constant = 1e5;
constexpr double slow_time = 1.0;

// One state a joint: the angle xi to which its dashpot has crept.
class CreepTerm final : public EffectTerm {
 public:
  CreepTerm(mechanics::JointVector stiffness, double time_constant)
      : stiffness_(std::move(stiffness)), time_constant_(time_constant) {}

  int states() const override { return static_cast<int>(stiffness_.size()); }
  bool slow() const override { return time_constant_ > slow_time; }

  void settle(const Kinematics& motion, const CoilCurrents& /*currents*/, double* out) const override {
    std::copy_n(motion.angles.data(), states(), out);
  }

  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView own,
                   mechanics::JointVector& torques) const override {
    for (int j = 0; j < states(); ++j) {
      const double stretch = motion.angles[j] - own.states[j];
      torques[j] -= stiffness_[j] * stretch;
      if (own.slopes != nullptr) own.slopes[j] = stretch / time_constant_;
    }
  }

 private:
  mechanics::JointVector stiffness_;  // kappa k
  double time_constant_;
};

class ViscoelasticCreep final : public DescribedEffect {
 public:
  ViscoelasticCreep()
      : DescribedEffect(
            {.id = "viscoelastic_creep",
             .stage = Stage::hinge,
             .description = "the silicone creeps: stiffer at first, softer after a while",
             .equation = "q -= kappa k (theta - xi), xi' = (theta - xi)/T",
             .source = "standard linear solid: Ferry, Viscoelastic Properties of Polymers, 1980, ch. 1 and 3",
             .check = "hold one current for a minute and watch whether the angle goes on moving",
             .parameters = {{.key = "stiffness_ratio",
                             .text = "stiffness that relaxes over stiffness that stays",
                             .lower = 0.0,
                             .upper = 20.0,
                             .absent = 0.0},
                            {.key = "time_constant_s",
                             .text = "relaxation time at a held angle",
                             .lower = shortest,
                             .upper = longest_time_constant}}}) {}

  std::optional<std::string> inapplicable(const ModelSpec& spec) const override { return without_springs(spec); }

  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    const double low = std::clamp(4.0 * scale.interval, shortest, longest_time_constant);
    return each_with_each({0.2}, log_spread(low, std::clamp(scale.duration, low, longest_time_constant), 4));
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    if (values[0] == 0.0) return nullptr;
    return std::make_unique<CreepTerm>(values[0] * stiffnesses(spec), values[1]);
  }
};

}  // namespace

const EffectKind& viscoelastic_creep() {
  static const ViscoelasticCreep kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
