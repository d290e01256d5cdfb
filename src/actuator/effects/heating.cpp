#include <algorithm>
#include <array>
#include <cmath>

#include "actuator/effects/effect_rows.hpp"

// Warm coils resist more, warm magnets are weaker.
namespace coilwright::actuator::effects {
namespace {

// A loss per square ampere, its thermal time constant, and how a run that starts at rest under a current finds the
// part: cold, as after a pause, or warm, as after a hold that outlasts the heat. Which it was is a matter of the rig's
// operator; a record tells.
class HeatTerm : public FollowingTerm {
 public:
  HeatTerm(int states, Values values) : FollowingTerm(states, values[1]), loss_(values[0]), warm_start_(values[2]) {}

  void begin(const Kinematics& motion, const CoilCurrents& currents, double* out) const final {
    settle(motion, currents, out);
    for (int i = 0; i < states(); ++i) out[i] *= warm_start_;
  }

 protected:
  double loss_;

 private:
  double warm_start_;
};

// One state a coil: x = alpha (T - T_ambient), by how much its resistance has risen.
class CoilHeatTerm final : public HeatTerm {
 public:
  using HeatTerm::HeatTerm;

  // x (1 + x) = a i^2.
  void settle(const Kinematics& /*motion*/, const CoilCurrents& currents, double* out) const override {
    for (int c = 0; c < states(); ++c) {
      const double load = loss_ * currents[c] * currents[c];
      out[c] = 2.0 * load / (1.0 + std::sqrt(1.0 + 4.0 * load));
    }
  }

  void drive(InternalStateView own, CoilCurrents& currents) const override {
    for (int c = 0; c < states(); ++c) {
      const double rise = std::max(own.states[c], 0.0);  // an integrator's trial step may undershoot
      const double cold = currents[c];
      currents[c] = cold / (1.0 + rise);
      if (own.slopes != nullptr) own.slopes[c] = slope(loss_ * cold * currents[c], own.states[c]);
    }
  }
};

// One state: x = beta (T - T_ambient), the share of their remanence that the magnets have lost.
class MagnetHeatTerm final : public HeatTerm {
 public:
  using HeatTerm::HeatTerm;

  void settle(const Kinematics& /*motion*/, const CoilCurrents& currents, double* out) const override {
    out[0] = steady(currents);
  }

  // A magnet loses all its remanence at the worst and never turns round.
  void magnetize(InternalStateView own, const CoilCurrents& currents, CoilCurrents& strength) const override {
    strength *= std::clamp(1.0 - own.states[0], 0.0, 1.0);
    if (own.slopes != nullptr) own.slopes[0] = slope(steady(currents), own.states[0]);
  }

 private:
  // All coils warm all magnets alike: every magnet lies between coils, and one camera cannot tell them apart.
  [[nodiscard]] double steady(const CoilCurrents& currents) const {
    return loss_ * currents.squaredNorm() / static_cast<double>(currents.size());
  }
};

// Bounds of a thermal time constant, s: of a bare wire, and of a rig that a day does not warm.
constexpr double shortest_heat = 0.1;
constexpr double longest_heat = 1e5;

constexpr std::array warm_starts = {0.0, 1.0};

std::vector<EffectParameter> heat_parameters(std::string_view loss, std::string_view loss_text,
                                             std::string_view time_text) {
  return {from_zero(loss, loss_text),
          {.key = "time_constant_s", .text = time_text, .lower = shortest_heat, .upper = longest_heat},
          {.key = "warm_start",
           .text = "0: a run that starts at rest starts cold, 1: warm from a long hold under its first current",
           .lower = 0.0,
           .upper = 1.0,
           .choices = warm_starts}};
}

// A fifth lost at the rig's current, in a twentieth to thrice the longest run, cold and warm.
Starts heat_starts(const RigScale& scale) {
  const double loss = 0.2 / (scale.current * scale.current);
  const double low = std::clamp(0.05 * scale.duration, shortest_heat, longest_heat);
  const double high = std::clamp(3.0 * scale.duration, low, longest_heat);
  Starts out;
  for (const double time_constant : log_spread(low, high, 3))
    for (const double warm : warm_starts) out.push_back({loss, time_constant, warm});
  return out;
}

}  // namespace

EffectProperties coil_heating() {
  return {.id = "coil_heating",
          .stage = Stage::drive,
          .description = "a warm coil resists more, so its current fades under a given voltage",
          .equation = "i -> i/(1 + x), x' = (a i^2/(1 + x) - x)/T, x = alpha dT: power u^2/R falls as R rises",
          .source = "copper's linear resistivity (IEC 60028) and one heat capacity: C dT' = u i - dT/R_th",
          .check = "log voltage and current through one long hold: their quotient rises as the coil warms",
          .parameters =
              heat_parameters("fade_1_A2", "rise of the resistance in the steady state over the power of a cold coil",
                              "thermal time constant of the coil"),
          .starts = heat_starts,
          .build = [](Values values, ModelSpec& spec) -> Term {
            return std::make_unique<CoilHeatTerm>(spec.coils, values);
          }};
}

EffectProperties magnet_heating() {
  return {
      .id = "magnet_heating",
      .stage = Stage::magnetics,
      .description = "warm magnets lose remanence, so the force fades at a given current",
      .equation = "f -> f max(1 - x, 0), x' = (a <i^2> - x)/T, x = beta dT, <i^2>: mean over the coils",
      .source =
          "reversible temperature coefficient of remanence, 0.09 to 0.12 %/K for NdFeB (IEC 60404-8-1), and one heat "
          "capacity",
      .check = "repeat one step cold and right after a long hold, and take the magnet's temperature",
      .parameters = heat_parameters("loss_1_A2", "share of the force lost in the steady state per square ampere",
                                    "thermal time constant of the magnets"),
      .starts = heat_starts,
      .build = [](Values values, ModelSpec& /*spec*/) -> Term { return std::make_unique<MagnetHeatTerm>(1, values); }};
}

}  // namespace coilwright::actuator::effects
