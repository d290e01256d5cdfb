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

/// Whether a diagnosis can name an effect: it is in the catalogue of measured-data/1, or outside every catalogue. Some
/// of those outside are kept for the end: no threshold may be chosen with them.
enum class Standing { catalogue, outsider, kept };

/// A kind of effect that can be hidden in data.
struct HiddenKind {
  std::string id;  ///< id of measured-data/1, or a name for an effect outside the catalogue
  Standing standing = Standing::catalogue;
  bool strength_beyond_calibration = false;  ///< whether its strength is that after the fit of stiffness and damping
  std::vector<HiddenNumber> numbers;         ///< empty for an effect that is either present or not
  /// Draws signs and shapes, and returns the function that sets the strength: 0 is absent, 1 the physical bound.
  std::function<std::function<void(UnmodelledEffects&, double)>(Random&, const AngleRange&, UnmodelledEffects&)> draw;
  std::string variant{};  ///< name of a kind that shares its id with another

  [[nodiscard]] const std::string& name() const { return variant.empty() ? id : variant; }
  [[nodiscard]] bool outsider() const { return standing != Standing::catalogue; }
};

/// All ids of measured-data/1, then the effects outside every catalogue. dry_friction with Stribeck's numbers is a
/// kind of its own that bears the same id: hidden_kind("stribeck_friction").
[[nodiscard]] std::span<const HiddenKind> hidden_kinds();

/// By its name. Throws std::invalid_argument for an unknown one.
[[nodiscard]] const HiddenKind& hidden_kind(std::string_view name);

}  // namespace truth
