#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/described_effect.hpp"
#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/units/angle.hpp"

// What the rows of the standard effects are written with.
namespace coilwright::actuator::effects {

/// How many degrees a radian has: 5.0 / degrees is an angle of 5 degrees.
inline constexpr double degrees = units::degrees_per_radian;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// States (heat, creep) that move within this time constant, s, or less are part of a step's answer; slower ones are
/// held during one.
inline constexpr double slow_time = 1.0;

using Values = std::span<const double>;
using Term = std::unique_ptr<const EffectTerm>;
using Starts = std::vector<std::vector<double>>;

/// The effect of a row: one for the life of the program.
template <EffectProperties (*row)()>
[[nodiscard]] const EffectKind& kind_of() {
  static const DescribedEffect kind(row());
  return kind;
}

/// A number that is not negative, up to `most`, without an effect at zero.
[[nodiscard]] constexpr EffectParameter from_zero(std::string_view key, std::string_view text, double most = infinity) {
  return {.key = key, .text = text, .lower = 0.0, .upper = most, .absent = 0.0};
}

/// A number of either sign, up to `most` both ways, without an effect at zero.
[[nodiscard]] constexpr EffectParameter about_zero(std::string_view key, std::string_view text,
                                                   double most = infinity) {
  return {.key = key, .text = text, .lower = -most, .upper = most, .absent = 0.0};
}

/// A factor of `most` at most, or one part in `most` at least, without an effect at one.
[[nodiscard]] constexpr EffectParameter about_one(std::string_view key, std::string_view text, double most) {
  return {.key = key, .text = text, .lower = 1.0 / most, .upper = most, .absent = 1.0};
}

/// `count` >= 2 values from `low` to `high`, equally far apart in logarithm; 0 < low. Where high <= low: low alone.
[[nodiscard]] std::vector<double> log_spread(double low, double high, int count);

/// Every value by itself, as starts of an effect with one parameter.
[[nodiscard]] Starts one_by_one(const std::vector<double>& values);

/// Starts of an effect with one parameter that are the same on every rig.
[[nodiscard]] inline auto always(std::vector<double> values) {
  return [values = std::move(values)](const RigScale& /*scale*/) { return one_by_one(values); };
}

/// Starts of an effect with one parameter: shares of what `whole` is of a rig, a member of RigScale or a function of
/// it.
template <typename Whole>
[[nodiscard]] auto shares_of(Whole whole, std::vector<double> shares) {
  return [whole, shares = std::move(shares)](const RigScale& scale) {
    std::vector<double> values;
    for (const double share : shares) values.push_back(share * std::invoke(whole, scale));
    return one_by_one(values);
  };
}

/// Every first value with every second one.
[[nodiscard]] Starts each_with_each(const std::vector<double>& first, const std::vector<double>& second);

/// Why an effect of the coils cannot be in `spec`; nothing where there are some.
[[nodiscard]] std::optional<std::string> without_coils(const ModelSpec& spec);

/// Why an effect that scales with a joint's spring cannot be in `spec`; nothing where some joint has one.
[[nodiscard]] std::optional<std::string> without_springs(const ModelSpec& spec);

/// Why a model's joints have no motor with a shaft, bearings and gear: a coil and a magnet act across one of them.
/// Nothing where the drives are torques over current or torques as such.
[[nodiscard]] std::optional<std::string> without_shafts(const ModelSpec& spec);

/// Stiffness of every joint, N m/rad.
[[nodiscard]] mechanics::JointVector stiffnesses(const ModelSpec& spec);

/// States that follow what enters them by a first-order lag.
class FollowingTerm : public EffectTerm {
 public:
  FollowingTerm(int states, double time_constant) : states_(states), time_constant_(time_constant) {}
  int states() const final { return states_; }
  bool slow() const final { return time_constant_ > slow_time; }

 protected:
  [[nodiscard]] double time_constant() const { return time_constant_; }
  [[nodiscard]] double slope(double entering, double state) const { return (entering - state) / time_constant_; }

 private:
  int states_;
  double time_constant_;
};

/// Drive: each coil's current i becomes of(i).
template <typename Function>
[[nodiscard]] Term driven_current(Function of) {
  class DrivenCurrent final : public EffectTerm {
   public:
    explicit DrivenCurrent(Function f) : f_(std::move(f)) {}
    void drive(InternalStateView /*own*/, CoilCurrents& currents) const override {
      for (double& current : currents) current = f_(current);
    }

   private:
    Function f_;
  };
  return std::make_unique<DrivenCurrent>(std::move(of));
}

/// Camera: of(theta) is shown of an angle theta.
template <typename Function>
[[nodiscard]] Term shown_angle(Function of) {
  class ShownAngle final : public EffectTerm {
   public:
    explicit ShownAngle(Function f) : f_(std::move(f)) {}
    double observed(double angle) const override { return f_(angle); }

   private:
    Function f_;
  };
  return std::make_unique<ShownAngle>(std::move(of));
}

/// Magnetics and hinge: add(motion, torques) adds to the joints' torques; without states.
template <typename Function>
[[nodiscard]] Term added_torque(Function add) {
  class AddedTorque final : public EffectTerm {
   public:
    explicit AddedTorque(Function f) : f_(std::move(f)) {}
    void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView /*own*/,
                     mechanics::JointVector& torques) const override {
      f_(motion, torques);
    }

   private:
    Function f_;
  };
  return std::make_unique<AddedTorque>(std::move(add));
}

}  // namespace coilwright::actuator::effects
