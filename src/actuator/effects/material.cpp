#include <algorithm>
#include <cmath>

#include "actuator/effects/effect_rows.hpp"

// The silicone remembers: creep, a loop, a first stretch.
namespace coilwright::actuator::effects {
namespace {

using mechanics::JointVector;

constexpr double shortest = 1e-3;  // s; a faster dashpot is a damper to any camera
constexpr double longest_time_constant = 1e5;

// One state a joint: the angle xi to which its dashpot has crept.
class CreepTerm final : public EffectTerm {
 public:
  CreepTerm(JointVector stiffness, double time_constant)
      : stiffness_(std::move(stiffness)), time_constant_(time_constant) {}

  int states() const override { return static_cast<int>(stiffness_.size()); }
  bool slow() const override { return time_constant_ > slow_time; }

  void settle(const Kinematics& motion, const CoilCurrents& /*currents*/, double* out) const override {
    std::copy_n(motion.angles.data(), states(), out);
  }

  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView own,
                   JointVector& torques) const override {
    for (int j = 0; j < states(); ++j) {
      const double stretch = motion.angles[j] - own.states[j];
      torques[j] -= stiffness_[j] * stretch;
      if (own.slopes != nullptr) own.slopes[j] = stretch / time_constant_;
    }
  }

 private:
  JointVector stiffness_;  // kappa k
  double time_constant_;
};

// One state a joint: z in [-1, 1].
class HysteresisTerm final : public EffectTerm {
 public:
  HysteresisTerm(int joints, double amplitude, double sharpness)
      : joints_(joints), amplitude_(amplitude), sharpness_(sharpness) {}

  int states() const override { return joints_; }

  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView own,
                   JointVector& torques) const override {
    for (int j = 0; j < joints_; ++j) {
      const double rate = motion.rates[j];
      torques[j] -= amplitude_ * own.states[j];
      if (own.slopes != nullptr) own.slopes[j] = sharpness_ * (rate - std::abs(rate) * own.states[j]);
    }
  }

 private:
  int joints_;
  double amplitude_;
  double sharpness_;
};

// The largest stretch is the largest that lasted for about this long, s: without it the slope of the state jumps at
// each new stretch. The softening lags by one sample's part of its own rise, and nothing is won from it (see below).
constexpr double memory = 1e-3;

// One state a joint: its largest angle so far, either way. It only grows, so the torque k theta (1 - D(m)) never gives
// back more than it took: with the energy k theta^2 (1 - D) / 2 the loss is k theta^2 D'(m) m' / 2 >= 0.
class MullinsTerm final : public EffectTerm {
 public:
  MullinsTerm(JointVector stiffness, double softening, double angle, double stretched)
      : stiffness_(std::move(stiffness)), softening_(softening), angle_(angle), stretched_(stretched) {}

  int states() const override { return static_cast<int>(stiffness_.size()); }
  // A step response is that of a finger that has known no more than its rest: it has one equilibrium to settle in,
  // whatever its overshoot would leave behind.
  bool slow() const override { return true; }

  void settle(const Kinematics& motion, const CoilCurrents& /*currents*/, double* out) const override {
    for (int j = 0; j < states(); ++j) out[j] = std::max(std::abs(motion.angles[j]), stretched_);
  }

  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView own,
                   JointVector& torques) const override {
    for (int j = 0; j < states(); ++j) {
      const double largest = std::max(own.states[j], 0.0);
      torques[j] -= stiffness_[j] * motion.angles[j] * softening_ * std::expm1(-largest / angle_);
      if (own.slopes != nullptr) own.slopes[j] = std::max(0.0, std::abs(motion.angles[j]) - own.states[j]) / memory;
    }
  }

 private:
  JointVector stiffness_;
  double softening_;
  double angle_;
  double stretched_;  // largest angle before the run
};

constexpr EffectParameter softening =
    from_zero("softening", "share of a virgin hinge's stiffness that a large stretch takes for good", 1.0);
constexpr EffectParameter softening_angle{.key = "angle_deg",
                                          .text = "largest angle so far at which 63 % of that is gone",
                                          .lower = 0.5 / degrees,
                                          .upper = 180.0 / degrees};
constexpr EffectParameter stretched =
    from_zero("stretched_deg", "largest angle before the first sample of every run, every joint", 180.0 / degrees);

// What both kinds have in common: silicone that is new to its stretches, and silicone that has known some.
EffectProperties mullins(std::string_view description) {
  return {.id = "mullins_softening",
          .stage = Stage::hinge,
          .description = description,
          .equation = "k -> k (1 - d (1 - exp(-theta_max/theta_0))), theta_max the largest |theta| so far, every joint",
          .source =
              "Mullins, Rubber Chem. Technol. 42 (1969) 339; the exponential as in Ogden and Roxburgh's pseudo-elastic "
              "softening (Proc. R. Soc. A 455, 1999) to first order",
          .check = "repeat one small step before and after the largest bend, and again next day",
          .build = [](Values values, ModelSpec& spec) -> Term {
            return std::make_unique<MullinsTerm>(stiffnesses(spec), values[0], values[1],
                                                 values.size() > 2 ? values[2] : 0.0);
          },
          .inapplicable = without_springs};
}

EffectProperties stretched_before() {
  EffectProperties row = mullins("silicone softens beyond the largest stretch that it has known before");
  row.parameters = {softening, softening_angle, stretched};
  row.starts = [](const RigScale& scale) {
    const double angle = std::clamp(0.5 * scale.angle, softening_angle.lower, softening_angle.upper);
    const double largest = std::max(std::abs(scale.upper_angle), std::abs(scale.lower_angle));
    return Starts{{0.15, angle, std::clamp(0.6 * largest, 0.1 / degrees, stretched.upper)}};
  };
  return row;
}

}  // namespace

EffectProperties viscoelastic_creep() {
  return {.id = "viscoelastic_creep",
          .stage = Stage::hinge,
          .description = "the silicone creeps: stiffer at first, softer after a while",
          .equation = "q -= kappa k (theta - xi), xi' = (theta - xi)/T",
          .source = "standard linear solid: Ferry, Viscoelastic Properties of Polymers, 1980, ch. 1 and 3",
          .check = "hold one current for a minute and watch whether the angle goes on moving",
          .parameters = {from_zero("stiffness_ratio", "stiffness that relaxes over stiffness that stays", 20.0),
                         {.key = "time_constant_s",
                          .text = "relaxation time at a held angle",
                          .lower = shortest,
                          .upper = longest_time_constant}},
          .starts =
              [](const RigScale& scale) {
                const double low = std::clamp(4.0 * scale.interval, shortest, longest_time_constant);
                return each_with_each({0.2},
                                      log_spread(low, std::clamp(scale.duration, low, longest_time_constant), 4));
              },
          .build = [](Values values, ModelSpec& spec) -> Term {
            return std::make_unique<CreepTerm>(values[0] * stiffnesses(spec), values[1]);
          },
          .inapplicable = without_springs};
}

// A loop that needs degrees to turn over is the material's; one that turns over at once is dry friction, the limit of
// this law. The bound on the sharpness, 100/rad or 10 mrad, keeps the two apart.
EffectProperties hysteresis() {
  return {.id = "hysteresis",
          .stage = Stage::hinge,
          .description = "the material's loop does not depend on how fast it is gone through",
          .equation = "q -= a z, z' = gamma (omega - |omega| z), every joint",
          .source =
              "Bouc, 4th Conf. on Nonlinear Oscillation, Prague 1967; Wen, J. Eng. Mech. Div. ASCE 102 (1976) 249, "
              "with n = 1 and no pinching: Dahl",
          .check = "go up and down through the same currents slowly and compare the angles at rest",
          .parameters = {from_zero("amplitude_Nmm", "torque between middle and edge of the loop"),
                         {.key = "sharpness_1_rad",
                          .text = "one over the angle within which the loop turns over",
                          .lower = 0.5,
                          .upper = 100.0}},
          .starts =
              [](const RigScale& scale) {
                return each_with_each({0.05 * scale.torque}, {3.0, 12.0, 50.0});
              },
          .build = [](Values values, ModelSpec& spec) -> Term {
            return std::make_unique<HysteresisTerm>(spec.chain.joints(), values[0], values[1]);
          }};
}

// A run begins with what its start stretches, no more: a finger that has rested for a day, or is new.
EffectProperties mullins_softening() {
  EffectProperties row = mullins("silicone that has not been stretched before softens in its first cycles");
  row.parameters = {softening, softening_angle};
  row.further = &kind_of<stretched_before>();
  row.starts = [](const RigScale& scale) {
    const double low = std::clamp(0.3 * scale.angle, softening_angle.lower, 0.5 * softening_angle.upper);
    return each_with_each({0.15}, {low, std::clamp(scale.angle, 1.5 * low, softening_angle.upper)});
  };
  return row;
}

}  // namespace coilwright::actuator::effects
