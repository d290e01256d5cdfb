#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "truth/motion.hpp"
#include "truth/quirks.hpp"
#include "truth/random.hpp"

namespace truth {

/// A number of a hidden effect.
struct HiddenNumber {
  std::string key;           ///< as the answer writes it, unit at its end
  double Quirks::*member{};  ///< SI
  double denominator = 1.0;  ///< SI value = value in the key's unit / denominator
};

/// Something that can be hidden in data.
struct HiddenKind {
  std::string id;  ///< of the format's table; of an outsider, a name of our own
  bool outsider = false;
  std::vector<HiddenNumber> numbers;  ///< empty: it is there or not
  /// Draws signs and shapes, and gives what sets the strength: 0 is absent, 1 the physical bound.
  std::function<std::function<void(Quirks&, double)>(Random&, const Reach&, Quirks&)> draw;
};

/// All ids of measured-data/1, then what stays out of every catalogue.
[[nodiscard]] std::span<const HiddenKind> hidden_kinds();

/// Throws std::invalid_argument for a name that is not there.
[[nodiscard]] const HiddenKind& hidden_kind(std::string_view id);

}  // namespace truth
