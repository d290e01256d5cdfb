#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "truth/motion.hpp"
#include "truth/random.hpp"
#include "truth/unmodelled_effects.hpp"

namespace truth {

/// A number of a hidden effect.
struct HiddenNumber {
  std::string key;                      ///< as the answer writes it, with its unit at the end
  double UnmodelledEffects::*member{};  ///< SI
  double denominator = 1.0;             ///< SI value = value in the key's unit / denominator
};

/// A kind of effect that can be hidden in data.
struct HiddenKind {
  std::string id;                     ///< id of measured-data/1, or a name for an effect outside the catalogue
  bool outsider = false;              ///< whether it is outside every catalogue
  std::vector<HiddenNumber> numbers;  ///< empty for an effect that is either present or not
  /// Draws signs and shapes, and returns the function that sets the strength: 0 is absent, 1 the physical bound.
  std::function<std::function<void(UnmodelledEffects&, double)>(Random&, const AngleRange&, UnmodelledEffects&)> draw;
};

/// All ids of measured-data/1, then the effects outside every catalogue.
[[nodiscard]] std::span<const HiddenKind> hidden_kinds();

/// Throws std::invalid_argument for an unknown name.
[[nodiscard]] const HiddenKind& hidden_kind(std::string_view id);

}  // namespace truth
