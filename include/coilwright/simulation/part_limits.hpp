#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/simulation/quantity.hpp"

namespace coilwright::simulation {

/// Percent of its moment that a magnet may lose for good: what remanences of one grade differ by anyway.
inline constexpr double most_irreversible_loss = 1.0;

/// A limit that a part of the actuator sets by what it is made of, or its supply by the voltage that it has, whatever a
/// study asks for, at an operating point.
struct PartLimit {
  std::string_view quantity;      ///< its name: "magnet_temperature_degC", of a standard quantity or supply_load()
  std::optional<double> value{};  ///< in the unit of that name; nothing in a thermal runaway
  double limit{};                 ///< in the same unit
  bool at_most = true;            ///< whether the value must not exceed the limit; otherwise it must not fall below it
  std::string consequence{};      ///< what happens beyond it, as the end of a sentence
  bool conditional = false;       ///< whether the parts stand more under a condition, which the consequence names

  [[nodiscard]] bool is_broken() const noexcept { return !value || (at_most ? *value > limit : *value < limit); }
  /// Distance from the limit over its scale (its magnitude, or 1 where it is 0), negative where it is broken; -1 where
  /// there is no value.
  [[nodiscard]] double margin() const noexcept;
};

/// The limits of coils, magnets and wire at the operating point of `design`, of the supply where the point states its
/// voltage, and the angle at which the faces of its joints touch where some are pressed together. One whose quantity
/// does not exist for a reason other than a runaway (a magnet without a grade has no coercivity) is left out.
[[nodiscard]] std::vector<PartLimit> part_limits(const DesignView& design);

/// Those of them that the design breaks; conditional ones only where no other one of the same kind, heat or field, is
/// broken anyway.
[[nodiscard]] std::vector<PartLimit> broken_part_limits(const DesignView& design);

}  // namespace coilwright::simulation
