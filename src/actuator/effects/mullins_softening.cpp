#include <algorithm>
#include <cmath>
#include <utility>

#include "actuator/effects/springs.hpp"
#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

// The largest stretch is the largest that lasted for about this long, s: without it the slope of the state jumps at
// each new stretch. The softening lags by one sample's part of its own rise, and nothing is won from it (see below).
constexpr double memory = 1e-3;

// One state a joint: its largest angle so far, either way. It only grows, so the torque k theta (1 - D(m)) never gives
// back more than it took: with the energy k theta^2 (1 - D) / 2 the loss is k theta^2 D'(m) m' / 2 >= 0.
class MullinsTerm final : public EffectTerm {
 public:
  struct Spec {
    double softening{};
    double angle{};
    double stretched{};
  };
  MullinsTerm(mechanics::JointVector stiffness, const Spec& spec) : stiffness_(std::move(stiffness)), spec_(spec) {}

  int states() const override { return static_cast<int>(stiffness_.size()); }
  // A step response is that of a finger that has known no more than its rest: it has one equilibrium to settle in,
  // whatever its overshoot would leave behind.
  bool slow() const override { return true; }

  void settle(const Kinematics& motion, const CoilCurrents& /*currents*/, double* out) const override {
    for (int j = 0; j < states(); ++j) out[j] = std::max(std::abs(motion.angles[j]), spec_.stretched);
  }

  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView own,
                   mechanics::JointVector& torques) const override {
    for (int j = 0; j < states(); ++j) {
      const double largest = std::max(own.states[j], 0.0);
      torques[j] -= stiffness_[j] * motion.angles[j] * spec_.softening * std::expm1(-largest / spec_.angle);
      if (own.slopes != nullptr) own.slopes[j] = std::max(0.0, std::abs(motion.angles[j]) - own.states[j]) / memory;
    }
  }

 private:
  mechanics::JointVector stiffness_;
  Spec spec_;
};

std::vector<EffectParameter> virgin_parameters() {
  return {{.key = "softening",
           .text = "share of a virgin hinge's stiffness that a large stretch takes for good",
           .lower = 0.0,
           .upper = 1.0,
           .absent = 0.0},
          {.key = "angle_deg",
           .text = "largest angle so far at which 63 % of that is gone",
           .lower = 0.5 / degrees,
           .upper = 180.0 / degrees}};
}

std::vector<EffectParameter> stretched_parameters() {
  std::vector<EffectParameter> out = virgin_parameters();
  out.push_back({.key = "stretched_deg",
                 .text = "largest angle before the first sample of every run, every joint",
                 .lower = 0.0,
                 .upper = 180.0 / degrees,
                 .absent = 0.0});
  return out;
}

EffectProperties described(std::string_view description, std::vector<EffectParameter> parameters) {
  return {.id = "mullins_softening",
          .stage = Stage::hinge,
          .description = description,
          .equation = "k -> k (1 - d (1 - exp(-theta_max/theta_0))), theta_max the largest |theta| so far, every joint",
          .source =
              "Mullins, Rubber Chem. Technol. 42 (1969) 339; the exponential as in Ogden and Roxburgh's "
              "pseudo-elastic softening (Proc. R. Soc. A 455, 1999) to first order",
          .check = "repeat one small step before and after the largest bend, and again next day",
          .parameters = std::move(parameters)};
}

std::unique_ptr<const EffectTerm> build_mullins(const ModelSpec& spec, const MullinsTerm::Spec& values) {
  if (values.softening == 0.0) return nullptr;
  return std::make_unique<MullinsTerm>(stiffnesses(spec), values);
}

class StretchedBefore final : public DescribedEffect {
 public:
  StretchedBefore()
      : DescribedEffect(described("silicone softens beyond the largest stretch that it has known before",
                                  stretched_parameters())) {}

  std::optional<std::string> inapplicable(const ModelSpec& spec) const override { return without_springs(spec); }

  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    const double angle = std::clamp(0.5 * scale.angle, parameters()[1].lower, parameters()[1].upper);
    const double largest = std::max(std::abs(scale.upper_angle), std::abs(scale.lower_angle));
    return {{0.15, angle, std::clamp(0.6 * largest, 0.1 / degrees, parameters()[2].upper)}};
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    return build_mullins(spec, {.softening = values[0], .angle = values[1], .stretched = values[2]});
  }
};

// A run begins with what its start stretches, no more: a finger that has rested for a day, or is new.
class MullinsSoftening final : public DescribedEffect {
 public:
  MullinsSoftening()
      : DescribedEffect(described("silicone that has not been stretched before softens in its first cycles",
                                  virgin_parameters())) {}

  const EffectKind* with_further_numbers() const override {
    static const StretchedBefore kind;
    return &kind;
  }

  std::optional<std::string> inapplicable(const ModelSpec& spec) const override { return without_springs(spec); }

  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    const double low = std::clamp(0.3 * scale.angle, parameters()[1].lower, 0.5 * parameters()[1].upper);
    return each_with_each({0.15}, {low, std::clamp(scale.angle, 1.5 * low, parameters()[1].upper)});
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    return build_mullins(spec, {.softening = values[0], .angle = values[1]});
  }
};

}  // namespace

const EffectKind& mullins_softening() {
  static const MullinsSoftening kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
