#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace coilwright::units {

/// A unit at the end of a key or a column name: "mm" in `gap_mm`, "deg_s" in `speed_deg_s`.
///
/// SI value = value * numerator / denominator + offset. Millimetres divide by 1000 (rather than multiply by 1e-3), so
/// that 9.9 mm is the double nearest to 0.0099.
struct Unit {
  std::string_view suffix;     ///< without the leading underscore
  std::string_view dimension;  ///< "length", "angular rate", ...; units of one dimension are interchangeable
  double numerator{1.0};
  double denominator{1.0};
  double offset{0.0};
};

/// The parts of a name: `gap_mm` is the quantity "gap" in the unit mm.
struct NameWithUnit {
  std::string_view quantity;
  Unit unit;
};

/// Every unit that a key or a column may carry.
[[nodiscard]] std::span<const Unit> all_units() noexcept;

/// Splits the longest unit from the end of `name` (`omega_deg_s` is in deg/s, not in s); absent if there is none.
[[nodiscard]] std::optional<NameWithUnit> split_unit(std::string_view name) noexcept;

/// The name without its unit: "gap" for `gap_mm`; the whole name if it has none.
[[nodiscard]] std::string_view quantity_of(std::string_view name) noexcept;

/// The part of a name that ends in its unit: "/magnetics/0/torque_Nmm_A" for the JSON pointer to one number of that
/// list, "/magnetics/0/torque_Nmm_A/12"; otherwise the whole name.
[[nodiscard]] std::string_view key_with_unit(std::string_view name) noexcept;

/// The unit of a difference between two values under `name`: the name's unit, but K for degC. A name without a unit has
/// an empty suffix, and its values are not converted.
[[nodiscard]] Unit difference_unit(std::string_view name) noexcept;

/// Converts `value` from `unit` to SI (radians, kelvin).
[[nodiscard]] double to_si(double value, const Unit& unit) noexcept;

/// Converts an SI `value` to `unit`: the result is the decimal with the fewest digits (15 or more) that to_si() turns
/// back into the same double, so that 9.9 mm, read and written, is 9.9 again; if there is none, the nearest quotient.
[[nodiscard]] double from_si(double value, const Unit& unit) noexcept;

/// from_si() with the unit of the name under which the value is written, `from_si(0.0099, "gap_mm")`; a name without a
/// unit leaves the value unchanged.
[[nodiscard]] double from_si(double value, std::string_view name) noexcept;

/// Converts `value`, written under `name`, to the units of a model in memory: SI and radians, but degC for
/// temperatures. A name without a unit leaves the value unchanged.
[[nodiscard]] double to_memory(double value, std::string_view name) noexcept;

/// The inverse of to_memory(), with the digits of from_si(). It restores the written value to the bit.
[[nodiscard]] double from_memory(double value, std::string_view name) noexcept;

}  // namespace coilwright::units
