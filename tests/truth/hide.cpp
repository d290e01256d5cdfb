#include "truth/hide.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "truth/confounders.hpp"

namespace truth {
namespace {

// The share of its bound at which an effect has the strength that is asked for; 1 if it is weaker even at its bound.
template <typename StrengthAt>
double share_for(double asked, StrengthAt&& strength_at) {
  const auto excess = [&](double log_share) {
    double there = 1e3;  // a finger that leaves its range or has no equilibrium: too strong
    try {
      there = strength_at(std::exp(log_share));
    } catch (const std::runtime_error&) {
    }
    return std::log(std::max(there, 1e-6) / asked);
  };
  const double at_bound = excess(0.0);
  if (at_bound <= 0.0) return 1.0;
  const double weakest = std::log(1e-5);
  const double at_weakest = excess(weakest);
  if (at_weakest >= 0.0) return std::exp(weakest);
  std::uintmax_t iterations = 20;
  // Half a per cent is far below the accuracy with which the strength of an effect can be determined.
  const auto [lower, upper] = boost::math::tools::toms748_solve(
      excess, weakest, 0.0, at_weakest, at_bound, [](double a, double b) { return std::abs(b - a) < 5e-3; },
      iterations);
  return std::exp(lower);
}

// The largest share at which the finger stays in its range and the effect is no stronger than that.
template <typename StrengthAt>
double share_at_bound(double strongest, StrengthAt&& strength_at) {
  for (double share = 1.0; share > 1e-5; share *= 0.8) {
    try {
      if (strength_at(share) <= strongest) return share;
    } catch (const std::runtime_error&) {
    }
  }
  return 1e-5;
}

// The share that gives the first number of a kind this value, in the unit of its key.
double share_of_value(const HiddenKind& kind, const UnmodelledEffects& shape,
                      const std::function<void(UnmodelledEffects&, double)>& set_strength, double value) {
  const HiddenNumber& number = kind.numbers.front();
  const auto at = [&](double share) {
    UnmodelledEffects effects = shape;
    set_strength(effects, share);
    return effects.*number.member * number.denominator;
  };
  return (value - at(0.0)) / (at(1.0) - at(0.0));
}

}  // namespace

HidingPlace::HidingPlace(Camera camera_in, const Finger& finger_in, const std::vector<Experiment>& runs_in,
                         double noise_in)
    : camera(camera_in),
      finger(finger_in),
      runs(runs_in),
      noise(noise_in),
      nominal(recorded_angles(camera, finger, {}, runs)),
      calibration(camera, finger, runs, nominal),
      range(angle_range_of(finger, runs)) {}

HiddenEffect hide(const HidingPlace& place, const Hiding& asked, Random& random, UnmodelledEffects& all) {
  const HiddenKind& kind = hidden_kind(asked.name);
  UnmodelledEffects alone;
  alone.chance = all.chance;
  const double drawn = random.log_uniform(asked.weakest, asked.strongest);
  const auto set_strength = kind.draw(random, place.range, alone);
  const auto with = [&](double share) {
    UnmodelledEffects effects = alone;
    set_strength(effects, share);
    return recorded_angles(place.camera, place.finger, effects, place.runs);
  };
  const auto strength = [&](double share) {
    const RecordedAngles moved = with(share);
    return largest_difference(kind.strength_beyond_calibration ? place.calibration.absorb(moved, place.nominal) : moved,
                              place.nominal) /
           place.noise;
  };
  const bool adjustable = !kind.numbers.empty();
  double share = 1.0;
  if (adjustable && asked.value)
    share = share_of_value(kind, alone, set_strength, *asked.value);
  else if (adjustable && asked.at_bound)
    share = share_at_bound(asked.strongest, strength);
  else if (adjustable)
    share = share_for(drawn, strength);
  set_strength(alone, share);
  const RecordedAngles moved = with(share);
  const RecordedAngles left = place.calibration.absorb(moved, place.nominal);
  HiddenEffect effect{.id = kind.id,
                      .outsider = kind.outsider(),
                      .numbers = {},
                      .asked = adjustable && !asked.at_bound && !asked.value ? drawn : 0.0,
                      .share_of_bound = share,
                      .strength = largest_difference(moved, place.nominal) / place.noise,
                      .strength_after_calibration = largest_difference(left, place.nominal) / place.noise,
                      .visible = total_difference(left, place.nominal) > visible * place.noise};
  if (asked.find_confounders)
    effect.confounders = confounders_of({.id = kind.id,
                                         .camera = place.camera,
                                         .finger = place.finger,
                                         .runs = place.runs,
                                         .nominal = place.nominal,
                                         .moved = moved,
                                         .noise = place.noise});
  for (const HiddenNumber& number : kind.numbers)
    effect.numbers.push_back({.key = number.key, .value = alone.*number.member * number.denominator});
  add_effect(kind, alone, all);
  return effect;
}

void add_effect(const HiddenKind& kind, const UnmodelledEffects& from, UnmodelledEffects& to) {
  for (const HiddenNumber& number : kind.numbers) to.*number.member = from.*number.member;
  to.off_axis = to.off_axis || from.off_axis;
  to.coil_coil = to.coil_coil || from.coil_coil;
}

}  // namespace truth
