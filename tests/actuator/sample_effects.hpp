#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/actuator/model/model.hpp"

namespace coilwright::actuator::sample {

/// An effect of a test's own: what it does is a function, so that no effect of the catalogue takes part.
class Kind : public EffectKind {
 public:
  using Build = std::function<std::unique_ptr<const EffectTerm>(std::span<const double>, ModelSpec&)>;
  Kind(std::string id, Stage stage, std::vector<EffectParameter> parameters, Build build)
      : id_(std::move(id)), stage_(stage), parameters_(std::move(parameters)), build_(std::move(build)) {}

  [[nodiscard]] std::string_view id() const override { return id_; }
  [[nodiscard]] Stage stage() const override { return stage_; }
  [[nodiscard]] std::string_view description() const override { return "a sample"; }
  [[nodiscard]] std::string_view equation() const override { return ""; }
  [[nodiscard]] std::string_view source() const override { return ""; }
  [[nodiscard]] std::span<const EffectParameter> parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::string> inapplicable(const ModelSpec& spec) const override {
    return refuse ? refuse(spec) : std::nullopt;
  }
  [[nodiscard]] std::vector<std::vector<double>> starts(const RigScale& /*scale*/) const override { return {}; }
  [[nodiscard]] std::unique_ptr<const EffectTerm> build(std::span<const double> values,
                                                        ModelSpec& spec) const override {
    return build_(values, spec);
  }

  std::function<std::optional<std::string>(const ModelSpec&)> refuse;

 private:
  std::string id_;
  Stage stage_;
  std::vector<EffectParameter> parameters_;
  Build build_;
};

inline EffectParameter number(std::string_view key) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {.key = key, .text = "a number", .lower = -infinity, .upper = infinity};
}

/// A term of one class, built from the values.
template <typename Term>
Kind kind_of(std::string id, Stage stage, std::vector<EffectParameter> parameters) {
  return Kind(std::move(id), stage, std::move(parameters), [](std::span<const double> values, ModelSpec& spec) {
    return std::make_unique<const Term>(values, spec);
  });
}

/// Every current follows its command: i' = (command - i) / T.
class Lag : public EffectTerm {
 public:
  Lag(std::span<const double> values, const ModelSpec& spec) : time_(values[0]), coils_(spec.coils) {}
  [[nodiscard]] int states() const override { return coils_; }
  void settle(const Kinematics& /*motion*/, const CoilCurrents& currents, double* own) const override {
    std::copy_n(currents.data(), coils_, own);
  }
  void drive(InternalStateView own, CoilCurrents& currents) const override {
    for (int c = 0; c < coils_; ++c) {
      if (own.slopes) own.slopes[c] = (currents[c] - own.states[c]) / time_;
      currents[c] = own.states[c];
    }
  }

 private:
  double time_;
  int coils_;
};
inline const Kind lag = kind_of<Lag>("sample_lag", Stage::drive, {number("time_s")});

/// i -> gain i.
class DriveGain : public EffectTerm {
 public:
  DriveGain(std::span<const double> values, const ModelSpec& /*spec*/) : gain_(values[0]) {}
  void drive(InternalStateView /*own*/, CoilCurrents& currents) const override { currents *= gain_; }

 private:
  double gain_;
};
inline const Kind drive_gain = kind_of<DriveGain>("sample_drive_gain", Stage::drive, {number("gain")});

/// The force of a current is gain times as large.
class ForceGain : public EffectTerm {
 public:
  ForceGain(std::span<const double> values, const ModelSpec& /*spec*/) : gain_(values[0]) {}
  void magnetize(InternalStateView /*own*/, const CoilCurrents& /*currents*/, CoilCurrents& strength) const override {
    strength *= gain_;
  }

 private:
  double gain_;
};
inline const Kind force_gain = kind_of<ForceGain>("sample_force_gain", Stage::magnetics, {number("gain")});

/// Standard linear solid: a spring of stiffness k in a row with a damper k T, beside the hinge; the damper's angle xi
/// is the state, xi' = (theta - xi) / T. Slow where the third value is not 0.
class Creep : public EffectTerm {
 public:
  Creep(std::span<const double> values, const ModelSpec& spec)
      : stiffness_(values[0]), time_(values[1]), slow_(values[2] != 0.0), joints_(spec.chain.joints()) {}
  [[nodiscard]] int states() const override { return joints_; }
  [[nodiscard]] bool slow() const override { return slow_; }
  void settle(const Kinematics& motion, const CoilCurrents& /*currents*/, double* own) const override {
    std::copy_n(motion.angles.data(), joints_, own);
  }
  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView own,
                   mechanics::JointVector& torques) const override {
    for (int j = 0; j < joints_; ++j) {
      const double stretch = motion.angles[j] - own.states[j];
      torques[j] -= stiffness_ * stretch;
      if (own.slopes) own.slopes[j] = stretch / time_;
    }
  }

 private:
  double stiffness_;
  double time_;
  bool slow_;
  int joints_;
};
inline const Kind creep =
    kind_of<Creep>("sample_creep", Stage::hinge, {number("stiffness_Nm_rad"), number("time_s"), number("slow")});

/// A spring and a viscous damper more at every joint.
class SpringDamper : public EffectTerm {
 public:
  SpringDamper(std::span<const double> values, const ModelSpec& /*spec*/)
      : stiffness_(values[0]), damping_(values[1]) {}
  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView /*own*/,
                   mechanics::JointVector& torques) const override {
    torques -= stiffness_ * motion.angles + damping_ * motion.rates;
  }
  void add_damping(const Kinematics& /*motion*/, const CoilCurrents& /*strength*/,
                   mechanics::JointMatrix& damping) const override {
    damping.diagonal().array() += damping_;
  }

 private:
  double stiffness_;
  double damping_;
};
inline const Kind spring_damper = kind_of<SpringDamper>("sample_spring_damper", Stage::hinge,
                                                        {number("stiffness_Nm_rad"), number("damping_Nms_rad")});

/// Bristles of Dahl: q = -torque z, z' = (rate - |rate| z) / give.
class Friction : public EffectTerm {
 public:
  Friction(std::span<const double> values, const ModelSpec& spec)
      : torque_(values[0]), give_(values[1]), joints_(spec.chain.joints()) {}
  [[nodiscard]] int states() const override { return joints_; }
  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView own,
                   mechanics::JointVector& torques) const override {
    for (int j = 0; j < joints_; ++j) {
      torques[j] -= torque_ * own.states[j];
      if (own.slopes) own.slopes[j] = (motion.rates[j] - std::abs(motion.rates[j]) * own.states[j]) / give_;
    }
  }

 private:
  double torque_;
  double give_;
  int joints_;
};
inline const Kind friction =
    kind_of<Friction>("sample_friction", Stage::hinge, {number("torque_Nm"), number("give_rad")});

/// A term that does nothing.
class Nothing : public EffectTerm {
 public:
  Nothing(std::span<const double> /*values*/, const ModelSpec& /*spec*/) {}
};
inline const Kind nothing = kind_of<Nothing>("sample_nothing", Stage::hinge, {});

/// The base turned, rad: nothing that acts while the model runs.
inline const Kind tilt("sample_tilt", Stage::chain, {number("tilt")},
                       [](std::span<const double> values, ModelSpec& spec) -> std::unique_ptr<const EffectTerm> {
                         spec.chain = spec.chain.under_gravity(spec.chain.gravity(), values[0]);
                         return nullptr;
                       });

/// The camera shows scale * angle + offset, late.
class Camera : public EffectTerm {
 public:
  Camera(std::span<const double> values, const ModelSpec& /*spec*/)
      : scale_(values[0]), offset_(values[1]), delay_(values[2]) {}
  [[nodiscard]] double observed(double angle) const override { return scale_ * angle + offset_; }
  [[nodiscard]] double delay() const override { return delay_; }

 private:
  double scale_;
  double offset_;
  double delay_;
};
inline const Kind camera =
    kind_of<Camera>("sample_camera", Stage::camera, {number("scale"), number("offset"), number("delay_s")});

/// `model` with other effects.
inline Model with_effects(const Model& model, std::vector<Effect> effects) {
  ModelSpec spec = model.nominal_spec();
  spec.effects = std::move(effects);
  return Model(std::move(spec));
}

/// A link of unit mass moment about its joint (`inertia`, kg m^2), without gravity, with a coil whose torque per ampere
/// is 1 N m/A at every angle: J theta'' = i - k theta - b theta'.
struct Rig {
  double inertia = 2.0;
  double stiffness = 0.0;
  double damping = 0.0;
};
inline Model rig(const Rig& values, std::vector<Effect> effects) {
  const mechanics::Link link{.length = 1.0, .com_along = 0.0, .mass = 1.0, .inertia = values.inertia};
  const auto ones = [](std::span<const double> /*angles*/, std::span<double> torques) {
    std::fill(torques.begin(), torques.end(), 1.0);
  };
  HingePair pair{.torque_per_ampere = std::make_shared<const magnetics::Curve>(
                     ones, magnetics::Curve::Spec{.lower = -3.0, .upper = 3.0, .tolerance = 1e-9})};
  return Model({.chain = mechanics::PlanarChain({&link, 1}, 0.0),
                .hinges = {{.stiffness = values.stiffness, .damping = values.damping}},
                .magnetics = MagneticStage({std::move(pair)}, {}),
                .coils = 1,
                .tip = {.link = 0, .along = 1.0},
                .effects = std::move(effects)});
}

}  // namespace coilwright::actuator::sample
