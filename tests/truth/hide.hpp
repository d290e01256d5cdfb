#pragma once

#include <optional>
#include <string>
#include <vector>

#include "truth/hidden_effect.hpp"
#include "truth/hidden_effects.hpp"
#include "truth/recording.hpp"

namespace truth {

/// The runs in which an effect is to be hidden, and the finger without it.
struct HidingPlace {
  HidingPlace(Camera camera, const Finger& finger, const std::vector<Experiment>& runs, double noise);

  Camera camera;
  Finger finger;
  const std::vector<Experiment>& runs;
  double noise;  ///< rad
  RecordedAngles nominal;
  Calibration calibration;
  AngleRange range;
};

/// How strong an effect is to be.
struct Hiding {
  std::string name;               ///< of its kind
  double weakest = 3.0;           ///< smallest strength, in standard deviations of the noise
  double strongest = 15.0;        ///< largest strength
  bool at_bound = false;          ///< at its physical bound, or where it is as strong as `strongest` before that
  std::optional<double> value{};  ///< of its first number, in the key's unit, in place of a strength
  bool find_confounders = false;
};

/// Draws sign, shape and strength of an effect, and adds it to `all`.
[[nodiscard]] HiddenEffect hide(const HidingPlace& place, const Hiding& asked, Random& random, UnmodelledEffects& all);

/// Copies the numbers of one kind.
void add_effect(const HiddenKind& kind, const UnmodelledEffects& from, UnmodelledEffects& to);

}  // namespace truth
