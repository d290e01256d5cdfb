#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/simulation/quantity.hpp"

namespace coilwright::simulation {

/// Largest acceptable irreversible loss of a magnet's moment, per cent: the remanences of one grade differ by as much.
inline constexpr double most_irreversible_loss = 1.0;

/// A limit at an operating point that a part of the actuator sets by its material, or the supply by its voltage,
/// whatever a study asks for.
struct PartLimit {
  std::string_view quantity;      ///< name of a standard quantity or of supply_load(): "magnet_temperature_degC"
  std::optional<double> value{};  ///< in the unit of that name; absent in a thermal runaway
  double limit{};                 ///< in the same unit
  bool at_most = true;            ///< whether the value must not exceed the limit; otherwise it must not fall below it
  std::string consequence{};      ///< consequence of exceeding it, as the end of a sentence
  bool conditional = false;       ///< whether the parts bear more under a condition, which the consequence names

  [[nodiscard]] bool is_broken() const noexcept { return !value || (at_most ? *value > limit : *value < limit); }
  /// Distance from the limit over its scale (its magnitude, or 1 if that is 0); negative if it is broken, -1 without a
  /// value.
  [[nodiscard]] double margin() const noexcept;
};

/// The limits of coils, magnets and wire at the operating point of `design`; that of the supply if the point states its
/// voltage; and the angle at which the faces of joints touch if some are pressed together. A limit is left out if its
/// quantity does not exist for another reason than a runaway (a magnet without a grade has no coercivity).
[[nodiscard]] std::vector<PartLimit> part_limits(const DesignView& design);

/// `limits` of `design` for a text: the meaning of a limit of shut joints also says what shuts them, which is computed
/// from the torques of every pair of bodies.
[[nodiscard]] std::vector<PartLimit> told(std::vector<PartLimit> limits, const DesignView& design);

/// part_limits() of `design` for a text.
[[nodiscard]] inline std::vector<PartLimit> told_part_limits(const DesignView& design) {
  return told(part_limits(design), design);
}

/// The limits that the design breaks. Conditional ones are included only if no other one of the same kind, heat or
/// field, is broken.
[[nodiscard]] std::vector<PartLimit> broken_part_limits(const DesignView& design);

}  // namespace coilwright::simulation
